#include "exact_places.h"

#include <burin/illustrate/view_probe.h>

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
// Of the diagonal: places so near each other are one.
constexpr double kSamePlace = 1e-9;
// Of what triangles are off: depths so near each other are one. More would widen the line in which
// a ball touches its pipe. Slanted planes are farther off their surface, by the tangent's square.
constexpr double kFlush = 2e-3;

}  // namespace

ExactAt exact_places(const Surface& surface) {
  if (!surface.exact()) return {};
  return [&surface](std::uint32_t face, Vec3 bary) {
    const SurfacePoint point = surface.lift({face, bary});
    return ExactPlace{point.position, surface.frame(point).normal};
  };
}

ExactDepths::ExactDepths(const Occluders& occluders)
    : proxies_(occluders.solid_proxies()), ranks_(occluders.ranks()) {
  for (const auto& surface : occluders.surfaces()) {
    places_.push_back(surface ? exact_places(*surface) : ExactAt{});
  }
  for (const ProxyMesh* proxy : proxies_) most_off_ = std::max(most_off_, proxy->tolerance);
}

double ExactDepths::off(std::int32_t part) const {
  return proxies_[static_cast<std::size_t>(part)]->tolerance;
}

double ExactDepths::cosine(FaceRef where, Vec3 direction) const {
  const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(where.part)];
  return std::max(std::abs(glm::dot(proxy.mesh.normal(where.face), direction)), kGrazing);
}

double ExactDepths::reach(FaceRef where, Vec3 direction) const {
  return (off(where.part) + most_off_) / cosine(where, direction);
}

double ExactDepths::flush(FaceRef where, Vec3 direction) const {
  const double slant = cosine(where, direction);
  return kFlush * reach(where, direction) / (slant * slant);
}

bool ExactDepths::precedes(std::int32_t part, std::int32_t other) const {
  const auto rank = [&](std::int32_t of) {
    const auto i = static_cast<std::size_t>(of);
    return i < ranks_.size() ? ranks_[i] : 0;
  };
  return rank(part) != rank(other) ? rank(part) > rank(other) : part < other;
}

double ExactDepths::depth(FaceRef where, Vec3 bary, Vec3 position, Vec3 origin,
                          Vec3 direction) const {
  const double flat = glm::dot(position - origin, direction);
  const ExactAt& exact = places(where.part);
  if (!exact) return flat;
  const ExactPlace place = exact(where.face, bary);
  const double cosine = glm::dot(place.normal, direction);
  if (std::abs(cosine) < kGrazing) return flat;
  const double farther = glm::dot(place.position - position, place.normal) / cosine;
  const double most = off(where.part) / kGrazing;
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
    const double reach = depths.reach(where, view), step = kSamePlace * solid.diagonal();
    const double flush = step + depths.flush(where, view);
    ViewHit best = *first;
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
      const bool on_each_other = std::abs(there - *least) < flush;
      if (on_each_other ? !depths.precedes(hit->where.part, best.part) : there > *least) continue;
      best.part = hit->where.part;
      best.point = {hit->where.face, hit->bary};
      best.position = position;
      least = there;
    }
    return best;
  };
}

}  // namespace burin::detail
