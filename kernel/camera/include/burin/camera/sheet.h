#pragma once
/// What a user asks of the sheet, beyond a name and one margin.

#include <burin/camera/camera.h>

#include <string_view>

namespace burin {

/// Empty border of the sheet in mm, side by side.
struct Margin {
  double top = 10, right = 10, bottom = 10, left = 10;

  Margin() = default;
  explicit Margin(double all) : top(all), right(all), bottom(all), left(all) {}
  Margin(double t, double r, double b, double l) : top(t), right(r), bottom(b), left(l) {}
  bool even() const { return top == right && right == bottom && bottom == left; }
};

/// What a margin leaves of a sheet, paper mm.
inline Box2 inside(const Paper& paper, const Margin& m) {
  return {{m.left, m.bottom}, {paper.width - m.right, paper.height - m.top}};
}

/// The margin that leaves a box of a sheet.
inline Margin margin_about(const Box2& box, const Paper& paper) {
  return {paper.height - box.max.y, paper.width - box.max.x, box.min.y, box.min.x};
}

/// Sides in mm of a sheet that a user may mean; beyond, somebody mistook the unit.
inline constexpr double kLeastSheet = 5;
inline constexpr double kLargestSheet = 10000;

/// Beside `ViewOptions`: what decides about the sheet as soon as the model is known.
struct SheetOptions {
  /// That of a fitted drawing; where the scale is given the drawing stands in the middle of what
  /// the margin leaves.
  Margin margin{};
  /// The sheet is as large as the drawing at the view's scale (absent = 1) and the margin;
  /// `ViewOptions::paper` is not looked at.
  bool fits = false;
  /// Where the view has no scale of its own: the largest one of ISO 5455 at which the drawing fits
  /// on the sheet. Orthographic views of a sheet that does not fit itself.
  bool iso_scale = false;
};

/// Throws UsageError where a scale of ISO 5455 is asked for that such a view or sheet has not.
void check_iso_scale(const ViewOptions& view, const SheetOptions& sheet);

/// The view with paper, margin, scale and centre settled, so that `Camera::fit` need not know of
/// SheetOptions. Perspective: the margins must be even, and a sheet that fits has the height that
/// the field of view asks for. Throws UsageError where a sheet that fits would be larger than
/// kLargestSheet, or a scale of ISO 5455 is asked for where there is none, and as `Camera::fit`.
ViewOptions settle(const Camera::ExtentFn& extent, ViewOptions view, const SheetOptions& sheet);

}  // namespace burin
