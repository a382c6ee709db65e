#pragma once
// What the views of a sheet measure, and the room for it; internal to the module.

#include <burin/annotate/dimensions.h>
#include <burin/arrange/illustration.h>
#include <burin/base/box.h>
#include <burin/camera/sheet.h>
#include <burin/surface/scene.h>

#include "broken_view.h"
#include "rows/row_in_view.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace burin::detail {

/// A view that may show dimensions.
struct SheetView {
  MeasuringView as{};
  std::string name = {};
  /// Those of a lower rank come before: a view with the line of a section, and a section itself.
  int rank = 0;
  BrokenAs broken = {};
  /// Whether what is left of the parts reaches both ends along x, y and z.
  std::array<bool, 3> reaches{true, true, true};
};

/// Deals dimensions to the views of a sheet: each to the first that shows it best.
class SheetDimensions {
 public:
  /// Tells of dimensions that no view shows. Throws UsageError where a row names a view that is
  /// not there.
  SheetDimensions(Scene& scene, const Illustration& illustration, std::vector<SheetView> views);

  /// Those of a view. `taken`: paper mm beside it that something else takes.
  ViewDimensions of_view(std::size_t i, const Margin& taken) const;
  /// Paper mm beside a view that its dimensions take at a scale, `taken` among them; not more than
  /// leaves something of the sheet to the view. `extent`: what
  /// the view shows, along its axes.
  Margin room(std::size_t i, const ViewDimensions& dimensions, const Box3& extent,
              double scale) const;

 private:
  void deal(Scene& scene, const Illustration& illustration);
  void keep_clear_of_annotations(const Scene& scene, const Illustration& illustration);
  void deal_row(Scene& scene, const MeasuredRow& row);
  /// What stands at the end of its leader.
  void write_note(const MeasuredRow& row, Dimension& note, Scene& scene) const;

  const DimensionOptions& style_;
  const std::vector<std::shared_ptr<const FeatureSight>>& sights_;
  /// Paper mm that dimensions may take beside a view, right and up; infinite of sheets that grow.
  Vec2 most_;
  Box3 drawn_;
  std::vector<SheetView> views_;
  std::vector<std::vector<Dimension>> lists_;
  /// Of each view the annotations that stand beside its parts.
  std::vector<std::vector<std::vector<Vec3>>> beside_;
};

/// Each side as large as the larger one.
Margin larger(const Margin& a, const Margin& b);
/// Whether all sides of `a` are at least as large, but for rounding.
bool holds(const Margin& a, const Margin& b);

}  // namespace burin::detail
