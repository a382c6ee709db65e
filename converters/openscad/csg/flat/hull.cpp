#include "clip.h"
#include "origins.h"

#include <algorithm>

namespace burin::csg {
namespace {

bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// The lower half of the hull of sorted points, without its last point.
/// @cite Andrew1979
template <typename Iterator>
void half_hull(Iterator from, Iterator to, std::vector<Vec2>& out) {
  const std::size_t first = out.size();
  for (; from != to; ++from) {
    while (out.size() >= first + 2 &&
           cross2(out.back() - out[out.size() - 2], *from - out[out.size() - 2]) <= 0) {
      out.pop_back();
    }
    out.push_back(*from);
  }
  out.pop_back();
}

}  // namespace

Region hull_of(std::span<const Region> regions) {
  Origins origins;
  std::vector<Vec2> points;
  for (const Region& r : regions) {
    origins.add(r);
    for (const Outline& o : r.outlines) {
      points.insert(points.end(), o.points.begin(), o.points.end());
    }
  }
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return {};
  Outline outline;
  half_hull(points.begin(), points.end(), outline.points);
  half_hull(points.rbegin(), points.rend(), outline.points);
  if (outline.points.size() < 3) return {};
  outline.arc.assign(outline.points.size(), -1);
  Region region;
  region.outlines.push_back(std::move(outline));
  origins.tag(region);
  return region;
}

}  // namespace burin::csg
