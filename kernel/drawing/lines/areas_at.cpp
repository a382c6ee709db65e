#include <burin/drawing/areas_at.h>
#include <burin/planar/even_odd.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Paper mm of a row.
constexpr double kRow = 0.25;

std::int64_t row_of(double y) { return static_cast<std::int64_t>(std::floor(y / kRow)); }

NearLines borders_of(std::span<const Area> areas, double reach) {
  std::vector<Polyline> rings;
  for (const Area& area : areas) {
    for (const std::vector<Vec2>& ring : area.rings) {
      if (ring.empty()) continue;
      rings.push_back(ring);
      rings.back().push_back(ring.front());
    }
  }
  return {rings, reach};
}

}  // namespace

AreasAt::AreasAt(std::span<const Area> areas, double reach) : borders_(borders_of(areas, reach)) {
  for (std::size_t k = 0; k < areas.size(); ++k) {
    for (const std::vector<Vec2>& ring : areas[k].rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Side side{ring[i], ring[(i + 1) % ring.size()], k};
        const auto [low, high] = std::minmax(side.a.y, side.b.y);
        for (std::int64_t r = row_of(low); r <= row_of(high); ++r) rows_[r].push_back(side);
      }
    }
  }
}

std::vector<std::size_t> AreasAt::at(Vec2 p) const {
  std::vector<std::size_t> out;
  const auto row = rows_.find(row_of(p.y));
  if (row == rows_.end()) return out;
  bool inside = false;
  // Sides of a row are in the order of their areas.
  const std::vector<Side>& sides = row->second;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& s = sides[i];
    if (crosses_ray(s.a, s.b, p)) inside = !inside;
    if (i + 1 < sides.size() && sides[i + 1].area == s.area) continue;
    if (inside) out.push_back(s.area);
    inside = false;
  }
  return out;
}

}  // namespace burin
