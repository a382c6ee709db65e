#include <burin/base/error.h>
#include <burin/camera/camera.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace burin {
namespace {

// Radians: an up vector closer to the view than this would leave the sheet's turn to rounding.
constexpr double kUpAngle = 1e-6;

Vec3 usable_up(Vec3 direction, Vec3 up) {
  for (const Vec3 candidate : {up, Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    const double length = glm::length(candidate);
    if (length > 0 && glm::length(glm::cross(candidate / length, direction)) > kUpAngle)
      return candidate;
  }
  return any_orthogonal(direction);
}

// Where a perspective view looks and from how far, so that the model touches the inner sheet and
// lies in its middle.
struct Standpoint {
  Vec2 center{0};       // along right and up
  double distance = 0;  // from the plane through the middle of the model's depth
};

// A point at (x, y, z) along right, up and direction lands inside the half width w of the sheet
// exactly where |x - cx| k / w + z <= distance, k = scale * distance being fixed by the angle of
// view. That is linear, so the model's extents along four slanted directions give the tightest view
// in closed form.
Standpoint perspective_standpoint(const Camera::ExtentFn& extent, const Camera& c, Vec2 half_sheet,
                                  double k, double middle_depth, double near_depth) {
  Standpoint out;
  double reach = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    const Vec3 side = (i == 0 ? c.right() : c.up()) * (k / half_sheet[i]);
    const Box3 b =
        extent(glm::transpose(Mat3(c.direction() + side, c.direction() - side, c.direction())));
    out.center[i] = 0.5 * (b.max.x - b.max.y) * half_sheet[i] / k;
    reach = std::max(reach, 0.5 * (b.max.x + b.max.y));
  }
  // The viewer stays a tenth of the distance before the model, so that no part of it fills the
  // sheet alone.
  out.distance = std::max(reach - middle_depth, (near_depth - middle_depth) / 0.9);
  return out;
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

  const Box3 box = extent(c.axes());
  if (box.empty()) throw GeometryError("nothing to draw: the model has no points");
  const Vec3 size = box.size();
  if (!std::isfinite(size.x + size.y + size.z)) {
    throw GeometryError("the model's extent is not finite: remove its points at infinity");
  }
  const Vec2 inner = Vec2(options.paper.width, options.paper.height) - 2 * options.margin;
  if (!(options.margin >= 0) || inner.x <= 0 || inner.y <= 0) {
    throw UsageError(fmt::format("a margin of {} mm leaves nothing of a sheet of {} x {} mm",
                                 options.margin, options.paper.width, options.paper.height));
  }
  if (options.scale && !(*options.scale > 0 && std::isfinite(*options.scale))) {
    throw UsageError("the scale must be a positive number of paper mm per model mm");
  }
  Vec3 middle = box.center();
  // What is to fit: twice the larger side where the middle is not that of the box.
  Vec3 fit = size;
  if (options.center) {
    if (options.perspective && !options.scale) {
      throw UsageError("a perspective view with a centre of its own needs a scale; give both");
    }
    const Vec3 p = *options.center;
    middle = {glm::dot(p, c.right_), glm::dot(p, c.up_), glm::dot(p, c.direction_)};
    if (!std::isfinite(middle.x + middle.y + middle.z)) {
      throw UsageError("the centre of the sheet must be finite");
    }
    fit = 2.0 * glm::max(glm::abs(box.max - middle), glm::abs(box.min - middle));
  }
  if (options.perspective) {
    if (!(*options.perspective >= 1 && *options.perspective <= 120)) {
      throw UsageError("the field of view must be between 1 and 120 degrees");
    }
    c.field_of_view_ = *options.perspective;
    const double k = inner.y / 2 / std::tan(c.field_of_view_ * std::numbers::pi / 360);
    const Standpoint at = perspective_standpoint(extent, c, 0.5 * inner, k, middle.z, box.max.z);
    if (!options.center) {
      middle.x = at.center.x;
      middle.y = at.center.y;
    }
    c.eye_distance_ = options.scale ? k / *options.scale : at.distance > 0 ? at.distance : k;
    c.scale_ = k / c.eye_distance_;
    if (c.eye_distance_ <= (options.center ? box.max.z - middle.z : 0.5 * size.z)) {
      throw UsageError(fmt::format(
          "at scale {} and {} degrees the viewer is inside the model: use a smaller scale or "
          "a smaller angle",
          c.scale_, c.field_of_view_));
    }
  } else if (options.scale) {
    c.scale_ = *options.scale;
  } else if (fit.x > 0 || fit.y > 0) {
    const double inf = std::numeric_limits<double>::infinity();
    c.scale_ = std::min(fit.x > 0 ? inner.x / fit.x : inf, fit.y > 0 ? inner.y / fit.y : inf);
  }
  c.center_ = c.right_ * middle.x + c.up_ * middle.y + c.direction_ * middle.z;
  return c;
}

Camera Camera::inside(const Placement& placement) const {
  const double by = placement.scale();
  const Mat3 back = glm::transpose(placement.linear) / by;  // turns only
  Camera camera = *this;
  camera.right_ = back * right_;
  camera.up_ = back * up_;
  camera.direction_ = back * direction_;
  camera.center_ = back * (center_ - placement.offset) / by;
  camera.scale_ *= by;
  camera.eye_distance_ /= by;
  return camera;
}

Camera Camera::on_sheet(const Paper& sheet, Vec2 corner) const {
  Camera camera = *this;
  camera.paper_ = sheet;
  camera.offset_ += corner;
  return camera;
}

Camera Camera::magnified(double factor, Vec2 from, Vec2 to) const {
  Camera camera = *this;
  camera.scale_ *= factor;
  camera.offset_ = factor * (offset_ - from) + to;
  return camera;
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

double Camera::area_scale(Vec3 p) const {
  const double s = scale_at(p);
  return perspective() ? s * s * distance_to_viewer(p) / (eye_distance_ - depth(p)) : s * s;
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
