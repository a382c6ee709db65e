#include "transform.h"

#include "origins.h"

#include <algorithm>
#include <cmath>

namespace burin::csg {
namespace {

constexpr double kSimilar = 1e-5;

bool keeps_circles(const Affine& a) {
  const double x = glm::length(a.x), y = glm::length(a.y), most = std::max(x, y);
  return std::abs(x - y) <= kSimilar * most && std::abs(glm::dot(a.x, a.y)) <= kSimilar * x * y;
}

}  // namespace

Region transformed(const Region& region, const Affine& affine) {
  const bool mirrored = affine.determinant() < 0;
  Region out;
  for (const Outline& o : region.outlines) {
    Outline moved = mirrored ? reversed(o) : o;
    for (Vec2& p : moved.points) p = affine(p);
    out.outlines.push_back(std::move(moved));
  }
  if (keeps_circles(affine)) {
    const double scale = std::sqrt(std::abs(affine.determinant()));
    for (const Arc& arc : region.arcs) {
      out.arcs.push_back({affine(arc.middle), scale * arc.radius, arc.step});
    }
  } else {
    for (Outline& o : out.outlines) std::ranges::fill(o.arc, -1);
  }
  return out;
}

}  // namespace burin::csg
