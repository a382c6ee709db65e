#include "turned_groups.h"

#include <burin/mesh/cut_faces.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace burin::detail {
namespace {

/// Degrees round an axis: rounded corners and the ends of slots have half a turn at the most.
constexpr double kLeastTurn = 190;
/// Sine of the angle to an axis up to which a section runs along it.
constexpr double kAlong = 1e-6;
/// Share of a ball that a sphere without an axis is at least.
constexpr double kLeastBall = 0.45;

/// Whether both ends of what a face takes up of its axis lie on another axis.
bool on_axis(const Axis& axis, const Axis& other, const TurnedExtent& extent, double near) {
  const auto off = [&](double height) {
    return glm::length(other.to(axis.point + height * axis.along));
  };
  // A short face knows its direction no better than its radius allows.
  const double reach = std::max(extent.high - extent.low, extent.radius);
  const double middle = 0.5 * (extent.low + extent.high);
  return off(middle - 0.5 * reach) <= near && off(middle + 0.5 * reach) <= near;
}

/// How many sections run along the axis of a group.
int cuts_along(const TurnedGroup& group, const std::vector<CutFace>& cuts, double near) {
  return static_cast<int>(std::ranges::count_if(cuts, [&](const CutFace& cut) {
    const bool through = std::abs(glm::dot(cut.normal, group.axis.point - cut.point)) < near;
    return through && (group.sphere || std::abs(glm::dot(cut.normal, group.axis.along)) < kAlong);
  }));
}

bool far_enough_round(const TurnedGroup& group, int cuts) {
  std::bitset<360> turn;
  for (const GroupFace& face : group.faces) turn |= face.extent.turn;
  // Each of them leaves half.
  return static_cast<double>(turn.count()) > std::ldexp(kLeastTurn, -cuts);
}

/// Collects faces into groups.
class Grouping {
 public:
  Grouping(const ProxyMesh& proxy, std::int32_t part, double near)
      : proxy_(proxy), part_(part), near_(near) {}

  void add(TurnedFace face) {
    GroupFace one{part_, std::move(face), {}};
    one.extent = extent_about(one.turned.axis, proxy_, one.turned.triangles);
    for (TurnedGroup& group : groups_) {
      if (!on_axis(one.turned.axis, group.axis, one.extent, near_)) continue;
      one.extent = extent_about(group.axis, proxy_, one.turned.triangles);
      group.faces.push_back(std::move(one));
      return;
    }
    groups_.push_back({one.turned.axis, false, false, {}});
    groups_.back().faces.push_back(std::move(one));
  }

  /// A sphere turns about every axis through its centre.
  void add_sphere(const TurnedFace& face) {
    bool taken = false;
    for (TurnedGroup& group : groups_) {
      if (glm::length(group.axis.to(face.axis.point)) > near_) continue;
      group.faces.push_back({part_, face, extent_about(group.axis, proxy_, face.triangles)});
      taken = true;
    }
    if (taken) return;
    groups_.push_back({face.axis, true, false, {}});
    groups_.back().faces.push_back({part_, face, extent_about(face.axis, proxy_, face.triangles)});
  }

  std::vector<TurnedGroup> take() {
    const std::vector<CutFace> cuts = cut_faces(proxy_);
    std::erase_if(groups_, [&](TurnedGroup& group) {
      const int along = cuts_along(group, cuts, near_);
      group.cut_along = along > 0;
      return group.sphere ? !is_ball(group, along) : !far_enough_round(group, along);
    });
    for (TurnedGroup& group : groups_) {
      std::ranges::sort(group.faces, {}, [](const GroupFace& f) { return f.turned.face; });
    }
    return std::move(groups_);
  }

 private:
  bool is_ball(const TurnedGroup& group, int cuts) const {
    double area = 0;
    for (const GroupFace& face : group.faces) {
      for (const std::uint32_t triangle : face.turned.triangles) area += proxy_.mesh.area(triangle);
    }
    const double radius = glm::distance(
        group.axis.point,
        proxy_.mesh.positions[proxy_.mesh.triangles[group.faces[0].turned.triangles[0]][0]]);
    return area > std::ldexp(kLeastBall, -cuts) * 4 * std::numbers::pi * radius * radius;
  }

  const ProxyMesh& proxy_;
  std::int32_t part_;
  double near_;
  std::vector<TurnedGroup> groups_;
};

}  // namespace

const GroupFace& TurnedGroup::largest() const {
  constexpr double kEqual = 1 - 1e-9;  // rounding decides nothing between faces of one radius
  const auto radius = [](const GroupFace& face) { return face.extent.radius; };
  const double most = radius(*std::ranges::max_element(faces, {}, radius));
  return *std::ranges::find_if(
      faces, [&](const GroupFace& face) { return radius(face) >= kEqual * most; });
}

Vec3 TurnedGroup::middle() const {
  const TurnedExtent& extent = faces.front().extent;
  return at(0.5 * (extent.low + extent.high));
}

std::vector<TurnedGroup> turned_groups(const Surface& surface, std::int32_t part, double near,
                                       const RunContext& context) {
  std::vector<TurnedFace> faces = turned_faces(surface, context);
  // The longest knows the axis best.
  std::ranges::stable_sort(faces, std::greater(), [&](const TurnedFace& face) {
    const TurnedExtent extent = extent_about(face.axis, surface.proxy(), face.triangles);
    return std::max(extent.high - extent.low, extent.radius);
  });
  Grouping grouping(surface.proxy(), part, near);
  for (TurnedFace& face : faces) {
    if (!face.sphere) grouping.add(std::move(face));
  }
  for (const TurnedFace& face : faces) {
    if (face.sphere) grouping.add_sphere(face);
  }
  return grouping.take();
}

std::vector<TurnedGroup> joined(std::vector<TurnedGroup> groups, double near) {
  std::vector<TurnedGroup> out;
  for (TurnedGroup& group : groups) {
    const auto same = std::ranges::find_if(out, [&](const TurnedGroup& other) {
      if (group.sphere || other.sphere) return false;
      return std::ranges::all_of(group.faces, [&](const GroupFace& face) {
        return on_axis(group.axis, other.axis, face.extent, near);
      });
    });
    if (same == out.end()) {
      out.push_back(std::move(group));
      continue;
    }
    // Heights are measured from the point of the axis that stays, in its direction.
    const double sense = glm::dot(group.axis.along, same->axis.along) < 0 ? -1 : 1;
    const double shift = glm::dot(group.axis.point - same->axis.point, same->axis.along);
    same->cut_along |= group.cut_along;
    for (GroupFace& face : group.faces) {
      const double low = shift + sense * face.extent.low, high = shift + sense * face.extent.high;
      face.extent.low = std::min(low, high);
      face.extent.high = std::max(low, high);
      same->faces.push_back(std::move(face));
    }
  }
  return out;
}

}  // namespace burin::detail
