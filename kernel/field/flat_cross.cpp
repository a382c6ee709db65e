#include "flat_cross.h"

#include <burin/surface/tangent_basis.h>

#include "fallback.h"

#include <cmath>

namespace burin::field {
namespace {

// Strokes go on over smooth borders, not over creases: these count so many times in the mean
// direction.
constexpr double kSmoothWeight = 4;
// An outline whose mean direction is weaker than this has none: a circle's is 0, a square's 1.
constexpr double kMinDominance = 0.15;
// Share of the outline from which a smooth border decides how a part without a direction is drawn.
constexpr double kSmoothShare = 0.3;
// Mean squared sine of the angle between a border and the circles about its centre up to which it
// is round.
constexpr double kRoundCross = 0.02;
// Degrees about the centre that one straight edge of a round border may span: two sides of a wedge
// have a centre, too.
constexpr double kWidestEdge = 45;
// Radius, as a share of the border's, of the hub where circles are too small to draw.
constexpr double kHub = 1e-3;

// The mean of the outline as a cross in `basis`, its length the
// strength in [0,1].
Vec2 mean_outline(const std::vector<OutlineEdge>& outline, const TangentBasis& basis) {
  Vec2 sum(0);
  double total = 0;
  for (const OutlineEdge& edge : outline) {
    const Vec2 arm = basis.coords(edge.arm);
    const double length = glm::length(arm);
    if (!(length > 0)) continue;
    const double weight = (edge.smooth ? kSmoothWeight : 1) * glm::length(edge.vector);
    sum += weight * complex_square(complex_square(arm / length));
    total += weight;
  }
  return total > 0 ? sum / total : Vec2(0);
}

double smooth_share(const std::vector<OutlineEdge>& outline) {
  double smooth = 0, total = 0;
  for (const OutlineEdge& edge : outline) {
    total += glm::length(edge.vector);
    if (edge.smooth) smooth += glm::length(edge.vector);
  }
  return total > 0 ? smooth / total : 0;
}

// Makes the patch one of circles if its smooth border is round: the centre is where the border's
// perpendicular bisectors meet, by least squares.
bool set_round(const std::vector<OutlineEdge>& outline, const TangentBasis& basis,
               FlatPatch& patch) {
  const Vec3 origin = outline.front().middle;
  double xx = 0, xy = 0, yy = 0;
  Vec2 right(0);
  for (const OutlineEdge& edge : outline) {
    const Vec2 e = basis.coords(edge.vector);
    const double length = glm::length(e);
    if (!edge.smooth || !(length > 0)) continue;
    const Vec2 d = e / length;
    xx += length * d.x * d.x;
    xy += length * d.x * d.y;
    yy += length * d.y * d.y;
    right += length * glm::dot(d, basis.coords(edge.middle - origin)) * d;
  }
  const double minor = xx * yy - xy * xy;
  if (!(minor > 0.01 * (xx + yy) * (xx + yy))) return false;  // nearly parallel: no centre
  const Vec2 c = Vec2(yy * right.x - xy * right.y, xx * right.y - xy * right.x) / minor;
  double off = 0, all = 0, radius = 0, weight = 0;
  for (const OutlineEdge& edge : outline) {
    const double length = glm::length(edge.vector);
    if (!edge.smooth || !(length > 0)) continue;
    const Vec2 r = basis.coords(edge.middle - origin) - c;
    const double along = glm::dot(r, basis.coords(edge.vector)) / length;
    const double across = std::abs(cross2(r, basis.coords(edge.vector))) / length;
    if (0.5 * length > std::tan(glm::radians(0.5 * kWidestEdge)) * across) return false;
    off += length * along * along;
    all += length * glm::dot(r, r);
    radius += length * glm::length(r);
    weight += length;
  }
  if (!(all > 0) || off > kRoundCross * all) return false;
  patch.center = origin + basis.vector(c);
  patch.hub = kHub * radius / weight;
  return true;
}

}  // namespace

std::optional<CrossDirections> FlatPatch::at(Vec3 position) const {
  if (!center) return arms;
  const Vec3 r = reject(position - *center, normal);
  const double radius = glm::length(r);
  if (radius <= hub) return std::nullopt;
  const Vec3 ray = r / radius, circle = glm::cross(normal, ray);
  return rays_first ? CrossDirections{ray, circle} : CrossDirections{circle, -ray};
}

void FlatPatch::swap_families() {
  rays_first = !rays_first;
  arms = {arms.second, -arms.first};
}

std::optional<FlatPatch> flat_cross(Vec3 normal, const std::vector<OutlineEdge>& outline,
                                    Vec3 fallback) {
  FlatPatch patch;
  patch.normal = normal;
  const TangentBasis basis(normal);
  const Vec2 mean = mean_outline(outline, basis);
  const double strength = glm::length(mean), smooth = smooth_share(outline);
  const Vec3 preferred = fallback_tangent(fallback, normal);
  const auto round = [&] { return set_round(outline, basis, patch); };
  patch.arms.first = preferred;
  if (strength > kMinDominance) {
    const Vec3 arm = basis.vector(complex_sqrt(complex_sqrt(mean / strength)));
    const Vec3 other = glm::cross(normal, arm);
    // Between two arms that are equally near the first one stays, whatever the rounding.
    const bool swap =
        std::abs(glm::dot(other, preferred)) > std::abs(glm::dot(arm, preferred)) + 1e-6;
    patch.arms.first = swap ? other : arm;
  } else if (smooth > kSmoothShare && !round()) {
    return std::nullopt;
  }
  patch.arms.second = glm::cross(normal, patch.arms.first);
  return patch;
}

}  // namespace burin::field
