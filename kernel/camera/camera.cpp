#include <burin/base/error.h>
#include <burin/camera/camera.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace burin {
namespace {

// Radians: an up vector closer to the view than this would leave the sheet's turn to rounding.
constexpr double kUpAngle = 1e-6;

std::array<Vec3, 8> corners(const Box3& box) {
  std::array<Vec3, 8> out;
  for (std::size_t i = 0; i < 8; ++i) {
    out[i] = {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
              i & 4 ? box.max.z : box.min.z};
  }
  return out;
}

Vec3 usable_up(Vec3 direction, Vec3 up) {
  for (const Vec3 candidate : {up, Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    const double length = glm::length(candidate);
    if (length > 0 && glm::length(glm::cross(candidate / length, direction)) > kUpAngle)
      return candidate;
  }
  return any_orthogonal(direction);
}

// The largest scale at which the corners of `box` (axes: right, up, to the viewer; relative to its
// centre), seen from distance inner_height / scale / (2 tan), project into the inner sheet. Scale
// grows the picture steadily, so bisection on its logarithm finds it.
double perspective_scale(const Box3& box, double inner_width, double inner_height,
                         double half_tan) {
  const Vec3 c = box.center();
  const auto fits = [&](double scale) {
    const double distance = inner_height / scale / (2 * half_tan);
    return std::ranges::all_of(corners(box), [&](Vec3 p) {
      const Vec3 q = p - c;
      const double away = distance - q.z;
      // The viewer stays outside the box by a tenth of the distance, so that no part of it fills
      // the sheet alone.
      if (away < 0.1 * distance) return false;
      const double s = scale * distance / away;
      return std::abs(q.x) * s <= inner_width / 2 && std::abs(q.y) * s <= inner_height / 2;
    });
  };
  double low = inner_height / (box.diagonal() * 1e3), high = inner_height / box.diagonal() * 1e3;
  for (int i = 0; i < 80; ++i) {
    const double middle = std::sqrt(low * high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

Camera Camera::fit(const ExtentFn& extent, const ViewOptions& options) {
  const double length = glm::length(options.direction);
  if (!(length > 0) || !std::isfinite(length)) {
    throw UsageError(
        "the view direction is zero or not finite: give X,Y,Z from the model to the viewer");
  }
  Camera c;
  c.paper_ = options.paper;
  c.direction_ = options.direction / length;
  c.right_ = glm::normalize(glm::cross(usable_up(c.direction_, options.up), c.direction_));
  c.up_ = glm::cross(c.direction_, c.right_);
  c.offset_ = 0.5 * Vec2(options.paper.width, options.paper.height);

  const Box3 box = extent(glm::transpose(Mat3(c.right_, c.up_, c.direction_)));
  if (box.empty()) throw GeometryError("nothing to draw: the model has no points");
  const Vec3 size = box.size();
  if (!std::isfinite(size.x + size.y + size.z)) {
    throw GeometryError("the model's extent is not finite: remove its points at infinity");
  }
  const Vec3 middle = box.center();
  c.center_ = c.right_ * middle.x + c.up_ * middle.y + c.direction_ * middle.z;

  const double inner_width = options.paper.width - 2 * options.margin;
  const double inner_height = options.paper.height - 2 * options.margin;
  if (!(options.margin >= 0) || inner_width <= 0 || inner_height <= 0) {
    throw UsageError(fmt::format("a margin of {} mm leaves nothing of a sheet of {} x {} mm",
                                 options.margin, options.paper.width, options.paper.height));
  }
  double half_tan = 0;
  if (options.perspective) {
    if (!(*options.perspective >= 1 && *options.perspective <= 120)) {
      throw UsageError("the field of view must be between 1 and 120 degrees");
    }
    c.field_of_view_ = *options.perspective;
    half_tan = std::tan(c.field_of_view_ * std::numbers::pi / 360);
  }
  if (options.scale) {
    if (!(*options.scale > 0) || !std::isfinite(*options.scale)) {
      throw UsageError("the scale must be a positive number of paper mm per model mm");
    }
    c.scale_ = *options.scale;
  } else if (half_tan > 0 && box.diagonal() > 0) {
    c.scale_ = perspective_scale(box, inner_width, inner_height, half_tan);
  } else if (size.x > 0 || size.y > 0) {
    const double inf = std::numeric_limits<double>::infinity();
    c.scale_ =
        std::min(size.x > 0 ? inner_width / size.x : inf, size.y > 0 ? inner_height / size.y : inf);
  }
  if (half_tan > 0) {
    c.eye_distance_ = inner_height / c.scale_ / (2 * half_tan);
    if (c.eye_distance_ <= 0.5 * size.z) {
      throw UsageError(
          fmt::format("at scale {} and {} degrees the viewer stands inside the model: "
                      "use a smaller scale or a smaller angle",
                      c.scale_, c.field_of_view_));
    }
  }
  return c;
}

Vec2 Camera::to_paper(Vec3 p) const {
  const Vec3 q = p - center_;
  double s = scale_;
  if (perspective()) s *= eye_distance_ / (eye_distance_ - glm::dot(q, direction_));
  return s * Vec2(glm::dot(q, right_), glm::dot(q, up_)) + offset_;
}

Vec3 Camera::to_viewer(Vec3 p) const {
  return perspective() ? normalize_or(eye() - p, direction_) : direction_;
}

double Camera::distance_to_viewer(Vec3 p) const {
  return perspective() ? glm::length(eye() - p) : std::numeric_limits<double>::infinity();
}

double Camera::scale_at(Vec3 p) const {
  return perspective() ? scale_ * eye_distance_ / (eye_distance_ - depth(p)) : scale_;
}

Vec2 Camera::velocity(Vec3 p, Vec3 t) const {
  const Vec2 flat(glm::dot(t, right_), glm::dot(t, up_));
  if (!perspective()) return scale_ * flat;
  const double s = scale_at(p);
  return s * flat +
         (to_paper(p) - offset_) * (glm::dot(t, direction_) / (eye_distance_ - depth(p)));
}

ViewRay Camera::ray(Vec2 paper) const {
  const Vec2 q = (paper - offset_) / scale_;
  const Vec3 on_plane = center_ + right_ * q.x + up_ * q.y;
  if (!perspective()) return {on_plane, -direction_};
  return {eye(), glm::normalize(on_plane - eye())};
}

}  // namespace burin
