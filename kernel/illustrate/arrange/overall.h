#pragma once
// Width, depth and height of what a sheet shows; internal to the module.

#include <burin/annotate/dimensions.h>
#include <burin/arrange/illustration.h>
#include <burin/base/box.h>
#include <burin/camera/sheet.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/scene.h>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace burin::detail {

/// A view that may show them, and what of them it does.
struct OverallView {
  /// Right, up and to the viewer, unit.
  Mat3 axes{1};
  /// Those of a lower rank come before: a view with the line of a section, and a section itself.
  int rank = 0;
  /// Of width, depth and height.
  std::array<bool, 3> shows{};
};

/// Gives each of width, depth and height to the first view that shows it square to the sheet, else
/// to the first that shows it at all. Tells of those that no view shows, and of those that cuts or
/// parts that came apart have made another one.
void share_overall(Scene& scene, const Illustration& illustration, std::span<OverallView> views);

/// The dimensions that a view shows of a box, beyond the room that is taken beside it; adds theirs.
std::vector<Dimension> overall_dimensions(const Box3& box, const OverallView& view,
                                          const DimensionOptions& style, Margin& room);

/// What views measure of width, depth and height; they keep room for it.
class Overall {
 public:
  Overall(Scene& scene, const Illustration& illustration, std::vector<OverallView> views)
      : illustration_(illustration), views_(std::move(views)) {
    if (illustration.overall_dimensions)
      drawn_ = drawn_bounds(scene, illustration.illustrate.part_styles);
    share_overall(scene, illustration, views_);
  }
  /// Those of a view, beyond the room that is taken beside it; adds theirs.
  std::vector<Dimension> of_view(std::size_t i, Margin& room) const {
    if (!illustration_.whole) return {};
    return overall_dimensions(drawn_, views_[i], illustration_.style.dimension, room);
  }

 private:
  const Illustration& illustration_;
  Box3 drawn_;
  std::vector<OverallView> views_;
};

}  // namespace burin::detail
