#pragma once
// Width, depth and height of what a sheet shows; internal to the module.

#include <burin/annotate/dimensions.h>
#include <burin/arrange/illustration.h>
#include <burin/base/box.h>
#include <burin/camera/sheet.h>
#include <burin/surface/scene.h>

#include <array>
#include <cstddef>
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

/// What views measure of width, depth and height; they keep room for it.
class Overall {
 public:
  /// Gives each of the three to the first view of the lowest rank that shows it square to the
  /// sheet, else to the first that shows it at all. Tells of those that no view shows, and of those
  /// that cuts or parts that came apart have made another one.
  Overall(Scene& scene, const Illustration& illustration, std::vector<OverallView> views);
  /// Those of a view, beyond the room that is taken beside it; adds theirs.
  std::vector<Dimension> of_view(std::size_t i, Margin& room) const;

 private:
  void share(Scene& scene, const Box3& whole, bool apart);

  const DimensionOptions& style_;
  Box3 drawn_;
  std::vector<OverallView> views_;
};

}  // namespace burin::detail
