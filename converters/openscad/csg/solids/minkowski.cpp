#include "minkowski.h"

#include <burin/base/error.h>

#include "hull3.h"

namespace burin::csg {
namespace {

// Sums of so many points in one hull take seconds and a gigabyte.
constexpr std::size_t kMostSums = 4'000'000;

std::vector<std::vector<Vec3>> parts_of(const Solid& solid) {
  if (convex(solid)) return {solid.positions};
  return convex_parts(solid);
}

}  // namespace

std::vector<Solid> minkowski_pieces(const Solid& a, const Solid& b, RunContext& context) {
  std::vector<Solid> out;
  if (a.empty() || b.empty()) return out;
  const auto first = parts_of(a), second = parts_of(b);
  for (const auto& p : first) {
    for (const auto& q : second) {
      context.check();
      if (p.size() * q.size() > kMostSums) {
        throw GeometryError("minkowski() of solids with too many corners");
      }
      std::vector<Vec3> sums;
      sums.reserve(p.size() * q.size());
      for (const Vec3& u : p) {
        for (const Vec3& v : q) sums.push_back(u + v);
      }
      out.push_back(convex_hull(sums));
    }
  }
  return out;
}

}  // namespace burin::csg
