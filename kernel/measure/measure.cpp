#include <burin/base/error.h>
#include <burin/measure/measure.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Radians between directions that are one: files give them to seven digits.
constexpr double kParallel = 1e-6;
/// Share of the size of both below which there is no distance.
constexpr double kNothing = 1e-9;

enum class Shape { Point, Line, Plane };

Shape shape_of(const Feature& f) {
  if (f.kind == FeatureKind::Plane) return Shape::Plane;
  if (f.kind == FeatureKind::Line || f.has_axis()) return Shape::Line;
  if (f.kind == FeatureKind::Point || f.kind == FeatureKind::Sphere) return Shape::Point;
  throw UsageError(
      fmt::format("{} has no plane, axis or centre to measure from", to_string(f.kind)));
}

bool parallel(Vec3 a, Vec3 b) { return glm::length(glm::cross(a, b)) < kParallel; }
bool square(Vec3 a, Vec3 b) { return std::abs(glm::dot(a, b)) < kParallel; }

/// Degrees between two directions, 0 to 90.
double acute(Vec3 a, Vec3 b) {
  const double cosine = std::abs(glm::dot(a, b)), sine = glm::length(glm::cross(a, b));
  return glm::degrees(std::atan2(sine, cosine));
}

double size_of(const Feature& a, const Feature& b) {
  Box3 box;
  for (const Feature* f : {&a, &b}) {
    for (const Vec3& p : f->points) box.add(p);
    box.add(f->point);
  }
  return box.diagonal();
}

/// Where a feature lies along a direction; throws where it lies at no one place.
void check_across(const Feature& f, Vec3 along) {
  const Shape shape = shape_of(f);
  const bool fits = shape == Shape::Point ||
                    (shape == Shape::Plane ? parallel(f.along, along) : square(f.along, along));
  if (fits) return;
  throw UsageError(fmt::format(
      "{} is not at one place along the direction of the distance: leave `along` out, or give one "
      "{} it",
      to_string(f.kind), shape == Shape::Plane ? "square to" : "across"));
}

/// Along the common perpendicular of two lines, from the first to the second.
Vec3 between_lines(const Feature& a, const Feature& b) {
  const Vec3 gap = b.point - a.point;
  if (parallel(a.along, b.along)) return reject(gap, a.along);
  const Vec3 across = glm::normalize(glm::cross(a.along, b.along));
  return glm::dot(gap, across) * across;
}

/// The direction of a distance that is not asked for along one; may have any length.
Vec3 way_between(const Feature& a, const Feature& b) {
  const Shape sa = shape_of(a), sb = shape_of(b);
  const Vec3 gap = b.point - a.point;
  if (sa == Shape::Plane || sb == Shape::Plane) {
    const Feature &plane = sa == Shape::Plane ? a : b, &other = sa == Shape::Plane ? b : a;
    const Shape so = sa == Shape::Plane ? sb : sa;
    const bool fits = so == Shape::Point || (so == Shape::Plane ? parallel(plane.along, other.along)
                                                                : square(plane.along, other.along));
    if (!fits) {
      const double off = acute(plane.along, other.along);
      throw UsageError(
          fmt::format("{} and {} are not parallel (by {:.4g} degrees): they have an "
                      "angle and no distance",
                      to_string(a.kind), to_string(b.kind), so == Shape::Plane ? off : 90 - off));
    }
    return glm::dot(gap, plane.along) * plane.along;
  }
  if (sa == Shape::Line && sb == Shape::Line) return between_lines(a, b);
  if (sa == Shape::Line) return reject(gap, a.along);
  if (sb == Shape::Line) return reject(gap, b.along);
  return gap;
}

/// The point of a feature from which its distance is shown: in the middle of what there is of it.
Vec3 shown_point(const Feature& f) {
  if (shape_of(f) == Shape::Point || f.kind == FeatureKind::Circle) return f.point;
  if (f.has_axis()) return f.point + 0.5 * (f.low + f.high) * f.along;
  Box3 box;
  for (const Vec3& p : f.points) box.add(p);
  const Vec3 middle = box.center();
  if (f.kind == FeatureKind::Plane) return middle - glm::dot(middle - f.point, f.along) * f.along;
  return f.point + glm::dot(middle - f.point, f.along) * f.along;
}

/// A point of `f` that is as near to `target` across `along` as it allows.
Vec3 facing_point(const Feature& f, Vec3 target, Vec3 along) {
  const Vec3 at = shown_point(f), off = reject(target - at, along);
  switch (shape_of(f)) {
    case Shape::Plane:
      return at + off;
    case Shape::Line:
      return at + glm::dot(off, f.along) * f.along;
    case Shape::Point:
      break;
  }
  return at;
}

}  // namespace

MeasuredDistance distance_between(const Feature& a, const Feature& b,
                                  const std::optional<Vec3>& along) {
  MeasuredDistance out;
  const double nothing = kNothing * size_of(a, b);
  if (along) {
    out.along = glm::normalize(*along);
    check_across(a, out.along);
    check_across(b, out.along);
    out.length = glm::dot(b.point - a.point, out.along);
  } else {
    const Vec3 way = way_between(a, b);
    out.length = glm::length(way);
    if (out.length > nothing) out.along = way / out.length;
  }
  if (!(std::abs(out.length) > nothing)) {
    throw UsageError(along ? "both are at one place along that direction"
                           : "both are at one place: their distance is 0");
  }
  if (out.length < 0) {
    out.length = -out.length;
    out.along = -out.along;
  }
  out.from = facing_point(a, shown_point(b), out.along);
  out.to = facing_point(b, out.from, out.along);
  return out;
}

MeasuredAngle angle_between(const Feature& a, const Feature& b) {
  const auto direction_of = [](const Feature& f) {
    if (shape_of(f) == Shape::Point) {
      throw UsageError(
          fmt::format("{} has no direction to measure an angle from", to_string(f.kind)));
    }
    return f.along;
  };
  const Vec3 da = direction_of(a), db = direction_of(b);
  const bool plane_a = shape_of(a) == Shape::Plane, plane_b = shape_of(b) == Shape::Plane;
  if (plane_a == plane_b ? parallel(da, db) : square(da, db)) {
    throw UsageError(fmt::format("{} and {} are parallel: they have a distance and no angle",
                                 to_string(a.kind), to_string(b.kind)));
  }
  // All is seen along this direction: the traces of planes, and lines as they are.
  Vec3 sight = glm::cross(da, db);
  if (plane_a != plane_b && glm::length(sight) < kParallel) sight = any_orthogonal(da);
  sight = glm::normalize(sight);
  const auto trace = [&](const Feature& f, bool plane) {
    return plane ? glm::normalize(glm::cross(sight, f.along)) : f.along;
  };
  MeasuredAngle out;
  out.first = trace(a, plane_a);
  out.second = trace(b, plane_b);
  const Vec3 pa = shown_point(a), pb = shown_point(b);
  const double apart = glm::dot(pb - pa, sight);
  const bool lines = !plane_a && !plane_b;
  if (lines && std::abs(apart) > kParallel * size_of(a, b)) {
    throw UsageError(fmt::format("{} and {} do not meet: they pass each other at {:.6g} mm",
                                 to_string(a.kind), to_string(b.kind), std::abs(apart)));
  }
  // pa + s first meets pb + t second in the plane across `sight`.
  const Vec3 gap = reject(pb - pa, sight), across = glm::cross(sight, out.second);
  out.vertex = pa + glm::dot(gap, across) / glm::dot(out.first, across) * out.first;
  if (glm::dot(pa - out.vertex, out.first) < 0) out.first = -out.first;
  if (glm::dot(reject(pb - out.vertex, sight), out.second) < 0) out.second = -out.second;
  out.degrees = glm::degrees(
      std::atan2(glm::length(glm::cross(out.first, out.second)), glm::dot(out.first, out.second)));
  return out;
}

Vec3 apex_of(const Feature& cone) {
  const auto width = [&](const Vec3& p) { return glm::length(reject(p - cone.point, cone.along)); };
  const auto [narrow, wide] = std::ranges::minmax_element(cone.points, {}, width);
  const double sense = glm::dot(*wide - *narrow, cone.along) < 0 ? -1 : 1;
  const double back = width(*wide) / std::tan(glm::radians(0.5 * cone.opening));
  return cone.point + (glm::dot(*wide - cone.point, cone.along) - sense * back) * cone.along;
}

}  // namespace burin
