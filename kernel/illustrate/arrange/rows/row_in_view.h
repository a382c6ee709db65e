#pragma once
// How a view shows what a row measures; internal to the module.

#include <burin/annotate/dimensions.h>
#include <burin/arrange/dimension_row.h>
#include <burin/base/vec.h>

#include "seen_feature.h"

#include <cstddef>
#include <optional>

namespace burin::detail {

/// A view that may show dimensions.
struct MeasuringView {
  /// Right, up and to the viewer, unit.
  Mat3 axes{1};
  /// Which of `MeasuredRow::there`.
  std::size_t scene = 0;
  /// Whether extension lines go on where centre lines end.
  bool centre_lines = false;
  /// Whether lines that parts hide are drawn.
  bool hidden_lines = false;
};

/// A dimension as a view shows it.
struct RowInView {
  Dimension dimension;
  /// 0 as one would choose, then the rest: hidden, from the other side, at a slant.
  int rank = 0;
  /// Whether no part hides all of what it measures.
  bool seen = true;
};

/// `sight`: of the view's scene. Nothing where the view does not show it as long as it is, nor
/// along the axes of space. `style`: of the sheet, which the row may change.
std::optional<RowInView> row_in_view(const MeasuredRow& row, const MeasuringView& view,
                                     const FeatureSight& sight, const DimensionOptions& style);

}  // namespace burin::detail
