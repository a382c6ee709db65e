#include "axis_sight.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

/// Sine of the angle between an axis and the view up to which a face is seen along it.
constexpr double kEndOn = 0.02;
/// Rays that ask whether a face is seen, and the share of them that must meet nothing.
constexpr std::size_t kRays = 40;
constexpr double kSeen = 0.05;
/// Paper mm: rays begin so far over a surface.
constexpr double kLift = 0.05;

/// A ray to the viewer from a point of an axis, in the solid that turns about it.
struct Way {
  Vec3 from, along;
  double height, cosine, sine;
  /// How far it has come, model mm.
  double out = 0;
};

/// Beyond the far end of the solid a ray meets that end first: to where it enters.
void enter(const TurnedGroup& group, double most, Way& way) {
  for (const GroupFace& face : group.faces) {
    const double before =
        way.cosine > 0 ? face.extent.low - way.height : way.height - face.extent.high;
    const double to = before / std::max(std::abs(way.cosine), 1e-9);
    const bool meets = before > 0 && before <= most && to * way.sine < face.extent.radius;
    if (!face.turned.hollow && meets) way.out = std::max(way.out, to);
  }
}

/// Through the solid to where the ray leaves it, each face once at the most.
void leave(const TurnedGroup& group, double slack, Way& way) {
  for (std::size_t round = 0; round < group.faces.size(); ++round) {
    const double before = way.out, reached = way.height + way.out * way.cosine;
    for (const GroupFace& face : group.faces) {
      const auto& [turn, low, high, radius] = face.extent;
      const bool within =
          reached >= low - slack && reached <= high + slack && way.out * way.sine <= radius;
      if (face.turned.hollow || !within) continue;
      const double end = way.cosine > 0 ? high - way.height : way.height - low;
      way.out = std::max(way.out, std::min(radius / std::max(way.sine, kEndOn),
                                           end / std::max(std::abs(way.cosine), 1e-9)));
    }
    if (way.out <= before) break;
  }
}

}  // namespace

bool AxisSight::seen_along(const TurnedGroup& group) const {
  const Vec3 view = camera_.to_viewer(group.middle());
  return glm::length(glm::cross(view, group.axis.along)) < kEndOn;
}

bool AxisSight::free(Vec3 from) const {
  return !occluder_.occluded(from, camera_.to_viewer(from), 2 * occluder_.resolution(),
                             camera_.distance_to_viewer(from));
}

double AxisSight::lift(Vec3 at) const { return kLift / camera_.scale_at(at); }

void AxisSight::keep_seen(TurnedGroup& group) const {
  const bool along = !group.sphere && seen_along(group);
  std::vector<GroupFace> seen;
  for (const GroupFace& face : group.faces) {
    const bool wall = !along && wall_seen(face);
    // Of a deep hole a sliver of its wall is seen, and all of its rim.
    const bool rim = !wall && (along || face.turned.hollow) && rim_seen(group, face);
    if (wall || rim || (group.cut_along && on_cut(group, face))) seen.push_back(face);
  }
  group.faces = std::move(seen);
}

/// Whether enough of some places meet nothing on their way to the viewer.
template <class Place>
bool AxisSight::enough_free(std::size_t count, const Place& place) const {
  const std::size_t step = std::max<std::size_t>(1, count / kRays);
  std::size_t asked = 0, met_nothing = 0;
  for (std::size_t i = 0; i < count; i += step) {
    const std::optional<Vec3> from = place(i);
    ++asked;
    met_nothing += from && free(*from) ? 1 : 0;
  }
  return static_cast<double>(met_nothing) > kSeen * static_cast<double>(asked);
}

const ProxyMesh& AxisSight::proxy_of(const GroupFace& face) const {
  return surfaces_[static_cast<std::size_t>(face.part)]->proxy();
}

bool AxisSight::wall_seen(const GroupFace& face) const {
  const ProxyMesh& proxy = proxy_of(face);
  const auto& triangles = face.turned.triangles;
  return enough_free(triangles.size(), [&](std::size_t i) -> std::optional<Vec3> {
    const Vec3 at = proxy.position(triangles[i], Vec3(1.0 / 3));
    const Vec3 normal = proxy.mesh.normal(triangles[i]);
    if (glm::dot(normal, camera_.to_viewer(at)) <= 0) return std::nullopt;
    return at + lift(at) * normal;
  });
}

bool AxisSight::on_cut(const TurnedGroup& group, const GroupFace& face) const {
  constexpr std::size_t kPlaces = 8;
  return enough_free(kPlaces, [&](std::size_t i) -> std::optional<Vec3> {
    const double share = (static_cast<double>(i) + 0.5) / kPlaces;
    const Vec3 at = group.at(face.extent.low + share * (face.extent.high - face.extent.low));
    return at + lift(at) * camera_.to_viewer(at);
  });
}

bool AxisSight::rim_seen(const TurnedGroup& group, const GroupFace& face) const {
  const ProxyMesh& proxy = proxy_of(face);
  const bool up = glm::dot(group.axis.along, camera_.to_viewer(group.middle())) > 0;
  const double near_end = up ? face.extent.high : face.extent.low;
  const double near =
      std::max(1e-3 * (face.extent.high - face.extent.low), 0.1 * lift(group.middle()));
  std::vector<Vec3> rim;
  for (const std::uint32_t triangle : face.turned.triangles) {
    for (const std::uint32_t corner : proxy.mesh.triangles[triangle]) {
      const Vec3 p = proxy.mesh.positions[corner];
      const double height = glm::dot(p - group.axis.point, group.axis.along);
      if (std::abs(height - near_end) <= near) rim.push_back(p);
    }
  }
  return enough_free(rim.size(), [&](std::size_t i) -> std::optional<Vec3> {
    return rim[i] + lift(rim[i]) * camera_.to_viewer(rim[i]);
  });
}

bool AxisSight::seen_at(const TurnedGroup& group, double height, double reach) const {
  const Vec3 from = group.at(height);
  Way way{from, camera_.to_viewer(from), height, 0, 0};
  way.cosine = glm::dot(way.along, group.axis.along);
  way.sine = std::sqrt(std::max(0.0, 1 - way.cosine * way.cosine));
  enter(group, reach, way);
  leave(group, lift(from), way);
  return free(from + (way.out + lift(from)) * way.along);
}

}  // namespace burin::detail
