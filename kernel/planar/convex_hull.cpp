#include <burin/planar/convex_hull.h>

#include <algorithm>
#include <cstddef>

namespace burin {
namespace {

bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// The lower half of the hull of sorted points, without its last point.
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

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  half_hull(points.begin(), points.end(), hull);
  half_hull(points.rbegin(), points.rend(), hull);
  return hull;
}

}  // namespace burin
