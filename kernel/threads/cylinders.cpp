#include "cylinders.h"

#include <burin/surface/tangent_basis.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace burin::detail {
namespace {

/// Of the radius: what faces about one axis differ by, and what a cylinder bends by. Facets of an
/// approximated cylinder have their corners on it.
constexpr double kSame = 1e-3;
/// Degrees round the axis: rounded corners have half a turn at the most.
constexpr double kLeastTurn = 190;
/// Rays round an axis, and how many of them must find an end open: of slots and keyways some do
/// not.
constexpr int kRays = 12, kOpen = 7;
/// Of the radius: how far beyond a cylinder its chamfer ends.
constexpr double kChamfer = 1.5;

/// The radius of a face that is a cylinder.
std::optional<double> radius_of(const TurnedFace& face, const ProxyMesh& proxy) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const std::uint32_t triangle : face.triangles) {
    for (const std::uint32_t corner : proxy.mesh.triangles[triangle]) {
      const double radius = glm::length(face.axis.to(proxy.mesh.positions[corner]));
      least = std::min(least, radius);
      most = std::max(most, radius);
    }
  }
  if (!(most > 0) || most - least > kSame * most) return std::nullopt;
  return most;
}

bool same_cylinder(const Cylinder& a, const Cylinder& b) {
  const double near = kSame * a.extent.radius;
  const auto off = [&](double height) { return glm::length(a.axis.to(b.at(height))); };
  const double shift = glm::dot(b.axis.point - a.axis.point, a.axis.along);
  const double sense = glm::dot(a.axis.along, b.axis.along) < 0 ? -1 : 1;
  const double low = shift + std::min(sense * b.extent.low, sense * b.extent.high);
  const double high = shift + std::max(sense * b.extent.low, sense * b.extent.high);
  return a.hollow == b.hollow && std::abs(a.extent.radius - b.extent.radius) <= near &&
         off(b.extent.low) <= near && off(b.extent.high) <= near && low <= a.extent.high + near &&
         high >= a.extent.low - near;
}

/// Leaves no doubt which end is which: of the largest part of its direction positive.
void orient(Axis& axis) {
  const Vec3 size = glm::abs(axis.along);
  const int most = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  if (axis.along[most] < 0) axis.along = -axis.along;
}

/// The height at which the surface, not its facets, has a radius. Chamfers turn about the axis:
/// what the surface is at one place goes on in its tangent, which is exact for cones.
double exact_height(const Cylinder& cylinder, double radius, const OwnPlace& place,
                    const Surface& surface) {
  const auto triangle = static_cast<std::uint32_t>(place.triangle);
  const Frame frame = surface.frame(surface.lift({triangle, place.bary}));
  const Vec3 from_axis = cylinder.axis.to(frame.position);
  const double out = glm::length(from_axis), along = glm::dot(frame.normal, cylinder.axis.along);
  const double height = glm::dot(frame.position - cylinder.axis.point, cylinder.axis.along);
  if (!(out > 0) || std::abs(along) < kSame) return height;
  return height - (radius - out) * glm::dot(frame.normal, from_axis / out) / along;
}

}  // namespace

std::vector<Cylinder> cylinders_of(const Surface& surface, const RunContext& context) {
  const ProxyMesh& proxy = surface.proxy();
  std::vector<Cylinder> out;
  for (TurnedFace& face : turned_faces(surface, context)) {
    if (face.sphere) continue;
    const auto radius = radius_of(face, proxy);
    if (!radius) continue;
    orient(face.axis);
    Cylinder one{
        face.axis, extent_about(face.axis, proxy, face.triangles), face.hollow, {face.face}};
    one.extent.radius = *radius;
    const auto same =
        std::ranges::find_if(out, [&](const Cylinder& other) { return same_cylinder(other, one); });
    if (same == out.end()) {
      out.push_back(std::move(one));
      continue;
    }
    same->extent.add(extent_about(same->axis, proxy, face.triangles));
    same->faces.push_back(face.face);
  }
  std::erase_if(out, [](const Cylinder& one) {
    return static_cast<double>(one.extent.turn.count()) <= kLeastTurn;
  });
  return out;
}

namespace {

/// As `open_end`, by rays that begin `within` mm from the end.
std::optional<double> open_from(const Cylinder& cylinder, double thin, bool high, double within,
                                const Surface& surface, const OwnRays& rays) {
  const auto& [turn, low, top, radius] = cylinder.extent;
  const double end = high ? top : low, out = high ? 1 : -1;
  const Vec3 start = cylinder.at(end - out * within), along = out * cylinder.axis.along;
  const double far = within + kChamfer * radius;
  const TangentBasis across(cylinder.axis.along);
  int open = 0;
  double farthest = end;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / kRays;
    const Vec3 away = across.vector({std::cos(angle), std::sin(angle)});
    const auto leaves = rays.out_of(start + thin * away, along, far);
    if (!leaves) continue;
    const Vec3 before = start + thin * away + (1 - kSame) * leaves->distance * along;
    // A screw has nothing wider there, such as a head; a hole has no ground.
    const bool free = cylinder.hollow
                          ? !rays.first(start, along, leaves->distance)
                          : rays.out_of(before, away, (1 + 2 * kSame) * radius - thin).has_value();
    if (!free) continue;
    ++open;
    const double height = exact_height(cylinder, thin, *leaves, surface);
    farthest = high ? std::max(farthest, height) : std::min(farthest, height);
  }
  if (open < kOpen) return std::nullopt;
  return farthest;
}

}  // namespace

std::optional<double> open_end(const Cylinder& cylinder, double thin, bool high,
                               const Surface& surface, const OwnRays& rays) {
  const double half = 0.5 * (cylinder.extent.high - cylinder.extent.low);
  const double near = std::min(half, 0.25 * cylinder.extent.radius);
  if (const auto end = open_from(cylinder, thin, high, near, surface, rays)) return end;
  // Where the end is oblique most of these begin outside of the part.
  return open_from(cylinder, thin, high, half, surface, rays);
}

}  // namespace burin::detail
