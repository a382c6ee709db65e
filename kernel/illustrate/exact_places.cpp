#include "exact_places.h"

#include <burin/base/part_ranks.h>
#include <burin/illustrate/view_probe.h>
#include <burin/mesh/chord_error.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

// Surfaces behind each other that may be the nearest.
constexpr int kMostBehind = 4;
// Cosine to a ray under which the way from a triangle to its surface is not followed: along the
// surface it would be long.
constexpr double kGrazing = 0.05;
// Multiples of the occluder's resolution: coordinates that went through single precision (STL) once
// in each part.
constexpr double kStored = 4;
// Of what triangles are off: depths so near each other are one. More would widen the line in which
// a ball touches its pipe. Slanted planes are farther off their surface, by the tangent's square.
constexpr double kFlush = 2e-3;
// The same of meshes, where corners' normals say how the surface bends between them: facets of 15
// degrees beside such of 9 are within it.
constexpr double kFlushOfMesh = 0.05;

// Where a mesh's surface is over a place of a triangle: half-way to the mean of the tangent planes
// at its corners, which a parabola over each edge is. @cite Boubekeur2008
Vec3 rounded(const ProxyMesh& proxy, std::uint32_t face, Vec3 bary, Vec3 position) {
  Vec3 off(0);
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t w = proxy.wedges[face][static_cast<std::size_t>(i)];
    const Vec3& normal = proxy.wedge_normal[w];
    off -= 0.5 * bary[i] * glm::dot(position - proxy.wedge_position(w), normal) * normal;
  }
  return position + off;
}

}  // namespace

ExactAt exact_places(const Surface& surface) {
  if (!surface.exact()) return {};
  return [&surface](std::uint32_t face, Vec3 bary) {
    const SurfacePoint point = surface.lift({face, bary});
    return ExactPlace{point.position, surface.frame(point).normal};
  };
}

ExactDepths::ExactDepths(const Occluders& occluders)
    : proxies_(occluders.solid_proxies()),
      ranks_(occluders.ranks()),
      untold_(kStored * occluders.solid().resolution()) {
  for (const auto& surface : occluders.surfaces()) {
    places_.push_back(surface ? exact_places(*surface) : ExactAt{});
  }
  if (!needed()) return;
  for (std::size_t i = 0; i < proxies_.size(); ++i) {
    const auto part = static_cast<std::int32_t>(i);
    const std::size_t faces = places_[i] ? 1 : proxies_[i]->mesh.triangles.size();
    for (std::uint32_t f = 0; f < faces; ++f) most_off_ = std::max(most_off_, off({part, f}));
  }
}

double ExactDepths::off(FaceRef where) const {
  const auto part = static_cast<std::size_t>(where.part);
  const ProxyMesh& proxy = *proxies_[part];
  return places_[part] ? proxy.tolerance : chord_error(proxy, where.face);
}

double ExactDepths::cosine(FaceRef where, Vec3 direction) const {
  const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(where.part)];
  return std::max(std::abs(glm::dot(proxy.mesh.normal(where.face), direction)), kGrazing);
}

double ExactDepths::reach(FaceRef where, Vec3 direction) const {
  return (off(where) + most_off_ + 2 * untold_) / cosine(where, direction);
}

double ExactDepths::flush(FaceRef a, FaceRef b, Vec3 direction) const {
  const auto share = [&](FaceRef of) {
    return places_[static_cast<std::size_t>(of.part)] ? kFlush : kFlushOfMesh;
  };
  const double slant = cosine(a, direction);
  return untold_ / slant + (share(a) * off(a) + share(b) * off(b)) / (slant * slant * slant);
}

bool ExactDepths::precedes(std::int32_t part, std::int32_t other) const {
  return burin::precedes(ranks_, part, other);
}

ExactPlace ExactDepths::place(FaceRef where, Vec3 bary) const {
  const auto part = static_cast<std::size_t>(where.part);
  if (places_[part]) return places_[part](where.face, bary);
  const ProxyMesh& proxy = *proxies_[part];
  const Vec3 position = proxy.position(where.face, bary);
  return {rounded(proxy, where.face, bary, position), proxy.normal(where.face, bary)};
}

double ExactDepths::depth(FaceRef where, Vec3 bary, Vec3 position, Vec3 origin,
                          Vec3 direction) const {
  const double flat = glm::dot(position - origin, direction);
  const double error = off(where);
  if (error == 0) return flat;
  const ExactPlace exact = place(where, bary);
  const double cosine = glm::dot(exact.normal, direction);
  if (std::abs(cosine) < kGrazing) return flat;
  const double farther = glm::dot(exact.position - position, exact.normal) / cosine;
  const double most = error / kGrazing;
  return flat + std::clamp(farther, -most, most);
}

ViewProbe exact_view_probe(const Occluders& occluders, const ExactDepths& depths,
                           const Camera& camera) {
  ViewProbe probe = view_probe(occluders.solid(), camera);
  if (!depths.needed()) return probe;
  return [probe = std::move(probe), &solid = occluders.solid(), &depths,
          &camera](Vec2 at) -> std::optional<ViewHit> {
    const auto first = probe(at);
    if (!first) return first;
    const Vec3 origin = first->position, view = -camera.to_viewer(origin);
    const FaceRef where{first->part, first->point.face};
    const double reach = depths.reach(where, view), step = solid.tie();
    ViewHit best = *first;
    FaceRef nearest = where;
    std::optional<double> least;
    double from = 0;
    for (int i = 0; i < kMostBehind && from + step < reach; ++i) {
      const auto hit = solid.first_hit(origin, view, from + step, reach);
      if (!hit) break;
      from = hit->distance;
      if (hit->where.part == first->part) continue;
      if (!least) least = depths.depth(where, first->point.bary, origin, origin, view);
      const Vec3 position = origin + hit->distance * view;
      const double there = depths.depth(hit->where, hit->bary, position, origin, view);
      const bool on_each_other =
          std::abs(there - *least) < step + depths.flush(nearest, hit->where, view);
      if (on_each_other ? !depths.precedes(hit->where.part, best.part) : there > *least) continue;
      nearest = hit->where;
      best.part = hit->where.part;
      best.point = {hit->where.face, hit->bary};
      best.position = position;
      least = there;
    }
    return best;
  };
}

}  // namespace burin::detail
