#include "places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <unordered_map>

namespace burin::csg {
namespace {

struct Cell {
  std::array<std::int64_t, 3> at;
  bool operator==(const Cell&) const = default;
};
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    std::uint64_t h = 0;
    for (const std::int64_t v : c.at) {
      h = (h ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

class Places {
 public:
  Places(const std::vector<Vec3>& points, double reach) : points_(points), reach_(reach) {}

  /// The nearest of those that stand for others, else the point itself, which does so from now on.
  std::uint32_t find(std::uint32_t point) {
    const Vec3 p = points_[point];
    const Cell home = cell_of(p);
    std::uint32_t best = point;
    double nearest = reach_;
    for (int i = 0; i < 27; ++i) {
      const Cell c{{home.at[0] + i % 3 - 1, home.at[1] + i / 3 % 3 - 1, home.at[2] + i / 9 - 1}};
      const auto [from, to] = cells_.equal_range(c);
      for (auto at = from; at != to; ++at) {
        const Vec3 d = glm::abs(points_[at->second] - p);
        const double off = std::max({d.x, d.y, d.z});
        if (off > nearest || (off == nearest && at->second > best)) continue;
        nearest = off;
        best = at->second;
      }
    }
    if (best == point) cells_.emplace(home, point);
    return best;
  }

 private:
  Cell cell_of(Vec3 p) const {
    const auto whole = [&](double v) { return static_cast<std::int64_t>(std::floor(v / reach_)); };
    return {{whole(p.x), whole(p.y), whole(p.z)}};
  }

  const std::vector<Vec3>& points_;
  double reach_;
  std::unordered_multimap<Cell, std::uint32_t, CellHash> cells_;
};

std::vector<std::uint32_t> all_of(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> out(points.size());
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

double largest_coordinate(const std::vector<Vec3>& points) {
  double out = 0;
  for (const Vec3& p : points) {
    out = std::max({out, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return out;
}

}  // namespace

std::vector<std::uint32_t> by_place(const std::vector<Vec3>& points,
                                    std::span<const std::uint32_t> which, double reach) {
  std::vector<std::uint32_t> out = all_of(points);
  // Coordinates beyond have no cell of their own, and no digits for one.
  constexpr double kMostCells = 0x1p52;
  if (!(largest_coordinate(points) / reach < kMostCells)) return out;
  Places places(points, reach);
  for (const std::uint32_t i : which) out[i] = places.find(i);
  return out;
}

std::vector<std::uint32_t> by_place(const std::vector<Vec3>& points, double reach) {
  return by_place(points, all_of(points), reach);
}

double last_digit(const std::vector<Vec3>& points) {
  constexpr double kDigits = 6, kMore = 1.01;
  const double size = largest_coordinate(points);
  return size > 0 ? kMore * std::pow(10.0, std::floor(std::log10(size)) + 1 - kDigits) : kFineGrid;
}

std::vector<std::uint32_t> open_corners(const Solid& solid) {
  using Side = std::array<std::uint32_t, 2>;
  std::vector<Side> edges, back, open;
  for (const auto& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({t[k], t[(k + 1) % 3]});
      back.push_back({t[(k + 1) % 3], t[k]});
    }
  }
  std::ranges::sort(edges);
  std::ranges::sort(back);
  std::ranges::set_difference(edges, back, std::back_inserter(open));
  std::vector<std::uint32_t> out;
  for (const Side& e : open) out.insert(out.end(), e.begin(), e.end());
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

bool closed(const Solid& solid) { return open_corners(solid).empty(); }

}  // namespace burin::csg
