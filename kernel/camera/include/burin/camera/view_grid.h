#pragma once
/// Where several views stand on a sheet.

#include <burin/base/box.h>
#include <burin/camera/sheet.h>
#include <burin/camera/standards.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Where the view from the left goes: to the right of the front view (first angle, Europe) or to
/// its left (third angle, America). ISO 5456-2.
enum class ProjectionMethod { FirstAngle, ThirdAngle };

/// A view of several: its extent, and room beside it that does not grow with the scale.
struct GridView {
  /// "front", "top", ... stand about the front view; any other name is a pictorial view, which
  /// stands in the corner between top and side, or in the row of the front view where there is none
  /// from above.
  std::string name;
  /// Model mm, right and up on the sheet.
  Vec2 size{0};
  /// Paper mm.
  Margin room{0};
};

struct ViewGrid {
  /// Paper mm a model mm, of all views.
  double scale = 1;
  /// Paper mm, in the order of the views: of each what it may take, and where the middle of what it
  /// shows is. The middles of a row or a column are on one line.
  std::vector<Box2> boxes;
  std::vector<Vec2> middles;
  /// All of it.
  Box2 box;
};

/// The largest grid that stands in the middle of the frame, or the one of that scale, which may be
/// larger than the frame. `gap`: paper mm between views. Throws UsageError where the frame has no
/// room for the gaps, GeometryError where no view has an extent.
ViewGrid arrange_views(std::span<const GridView> views, ProjectionMethod method, const Box2& frame,
                       double gap, std::optional<double> scale);

/// The view of a name as it stands beside a front view: from below, the front is at the top. Throws
/// as `named_view`.
NamedView view_in_grid(std::string_view name);

/// The numbers of ISO 5455, 1, 2 and 5 times a power of ten: the largest that is not larger.
double standard_scale(double most);

/// A scale as drawings have it: "5:1", "1:2", "1.37:1".
std::string scale_text(double scale);

}  // namespace burin
