#include <burin/base/error.h>
#include <burin/camera/sheet.h>
#include <burin/camera/view_grid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace burin {
namespace {

/// The model's box along right, up and towards the viewer; the point that is to be in the middle of
/// the drawing, and how far the drawing reaches from it, twice.
struct Seen {
  Mat3 axes;  // columns: right, up, direction
  Box3 box;
  Vec3 middle;
  Vec3 size;
};

Seen look(const Camera::ExtentFn& extent, const ViewOptions& view) {
  // Any camera of that direction: it alone decides about the axes.
  const Camera c =
      Camera::fit(extent, {.direction = view.direction, .up = view.up, .scale = 1.0, .margin = 0});
  Seen s{Mat3(c.right(), c.up(), c.direction()), {}, {}, {}};
  s.box = extent(glm::transpose(s.axes));
  s.middle = s.box.center();
  s.size = s.box.size();
  if (view.center) {
    s.middle = glm::transpose(s.axes) * *view.center;
    s.size = 2.0 * glm::max(glm::abs(s.box.max - s.middle), glm::abs(s.box.min - s.middle));
  }
  return s;
}

Paper sheet_around(Vec2 drawing, const Margin& m, double scale) {
  const Vec2 border(m.left + m.right, m.bottom + m.top);
  const Vec2 sheet = glm::max(drawing + border, Vec2(kLeastSheet));
  if (std::max(sheet.x, sheet.y) > kLargestSheet) {
    const Vec2 room = Vec2(kLargestSheet) - border;
    throw UsageError(fmt::format(
        "at scale {:.4g} the drawing needs a sheet of {:.0f} x {:.0f} mm, {} mm a side are the "
        "most; give a scale of {:.2g} or less, or name a paper",
        scale, sheet.x, sheet.y, kLargestSheet,
        // Rounded down, so that two digits of it fit.
        0.95 * scale * std::min(room.x / drawing.x, room.y / drawing.y)));
  }
  return {sheet.x, sheet.y};
}

/// Where a perspective drawing whose height is given by the angle of view lies along one axis, in
/// mm of the plane through `depth`: its middle and half its length. A point fits where |x - middle|
/// * distance / half + z - depth <= distance, so that extents along slanted directions tell.
struct Stretch {
  double middle = 0, half = 0;
};
struct PerspectiveView {
  const Camera::ExtentFn& extent;
  Vec3 direction;
  double depth;

  /// How far before the plane the viewer must stand, for a half of `slope` times that distance.
  double reach(Vec3 axis, double slope, std::optional<double> fixed, double& middle) const {
    const Vec3 side = axis / slope;
    const Box3 b = extent(glm::transpose(Mat3(direction + side, direction - side, direction)));
    middle = fixed.value_or(0.5 * (b.max.x - b.max.y) * slope);
    return std::max(b.max.x - middle / slope, b.max.y + middle / slope) - depth;
  }

  /// The least half that holds all from `distance`, at most `most`, found by halving.
  Stretch stretch(Vec3 axis, double distance, double most, std::optional<double> fixed) const {
    constexpr int kHalvings = 24;  // to a ten-millionth of the sheet
    Stretch out{fixed.value_or(0), most};
    double low = 0;
    for (int step = 0; step < kHalvings && out.half > 0; ++step) {
      const double half = 0.5 * (low + out.half);
      double middle = 0;
      (reach(axis, half / distance, fixed, middle) <= distance ? out.half : low) = half;
    }
    if (out.half > 0) reach(axis, out.half / distance, fixed, out.middle);
    return out;
  }
};

ViewOptions settle_perspective(const Camera::ExtentFn& extent, ViewOptions view,
                               const Margin& margin) {
  if (view.center && !view.scale) {
    throw UsageError("a perspective view with a centre of its own needs a scale; give both");
  }
  const Seen seen = look(extent, view);
  const auto fixed = [&](int i) {
    return view.center ? std::optional(seen.middle[i]) : std::nullopt;
  };
  const PerspectiveView how{extent, seen.axes[2], seen.middle.z};
  const double slope = std::tan(*view.perspective * std::numbers::pi / 360);
  const double scale = view.scale.value_or(1);
  double up = 0;
  const double front = seen.box.max.z - seen.middle.z;
  // The viewer stays a tenth of the distance before the model, as in Camera::fit.
  double distance = std::max(how.reach(seen.axes[1], slope, fixed(1), up), front / 0.9);
  if (!(distance > 0)) distance = 1;
  const double most = seen.size.x * distance / (distance - std::max(front, 0.0));
  const Stretch across = how.stretch(seen.axes[0], distance, most, fixed(0));
  view.paper = sheet_around(2 * scale * Vec2(across.half, slope * distance), margin, scale);
  view.margin = margin.top;
  view.scale = scale;
  view.center = seen.axes * Vec3(across.middle, up, seen.middle.z);
  return view;
}

/// The scale at which what is seen fills a box, or the next smaller one of ISO 5455.
double fitted_scale(Vec2 inner, const Seen& seen, bool iso_scale) {
  const double inf = std::numeric_limits<double>::infinity();
  const Vec2 ratio(seen.size.x > 0 ? inner.x / seen.size.x : inf,
                   seen.size.y > 0 ? inner.y / seen.size.y : inf);
  const double most = std::min(ratio.x, ratio.y);
  if (!std::isfinite(most)) return 1;
  return iso_scale && most > 0 ? standard_scale(most) : most;
}

}  // namespace

void check_iso_scale(const ViewOptions& view, const SheetOptions& sheet) {
  if (!sheet.iso_scale) return;
  if (sheet.fits) {
    throw UsageError(
        "`scale` iso is the largest of ISO 5455 that fits on a sheet, and any scale fits on one "
        "that grows: name a `paper`, or give a scale such as 1:2");
  }
  if (view.perspective) {
    throw UsageError("a perspective view has no scale of ISO 5455: leave `scale` iso out");
  }
}

ViewOptions settle(const Camera::ExtentFn& extent, ViewOptions view, const SheetOptions& sheet) {
  const Margin& m = sheet.margin;
  check_iso_scale(view, sheet);
  if (view.perspective && !m.even()) {
    throw UsageError("a perspective view keeps the same margin on all sides; give one number");
  }
  view.margin = m.top;
  const bool finds_scale = sheet.iso_scale && !view.scale;
  if (!sheet.fits && m.even() && !finds_scale) return view;
  if (view.perspective) return settle_perspective(extent, view, m);
  const Seen seen = look(extent, view);
  if (sheet.fits) {
    view.scale = view.scale.value_or(1);
    view.paper = sheet_around(*view.scale * Vec2(seen.size), m, *view.scale);
  }
  const Vec2 inner(view.paper.width - m.left - m.right, view.paper.height - m.bottom - m.top);
  if (!view.scale) view.scale = fitted_scale(inner, seen, sheet.iso_scale);
  // The middle of what the margin leaves lies beside that of the sheet.
  const Vec2 beside = 0.5 * Vec2(m.left - m.right, m.bottom - m.top) / *view.scale;
  view.center = seen.axes * (seen.middle - Vec3(beside, 0));
  view.margin = 0;
  return view;
}

}  // namespace burin
