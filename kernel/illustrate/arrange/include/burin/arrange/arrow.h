#pragma once
/// Arrows that show how parts move.

#include <burin/base/vec.h>

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A flat arrow in space: along a way, or about an axis. Parts hide it, and it hides parts.
struct ArrowRow {
  /// The parts that move, together; empty: `from` and `to` say where it is.
  std::vector<std::string> select = {};
  /// The way that they move, any length but 0.
  std::optional<Vec3> along = {};
  /// Or the axis that they turn about, through the middle of their box, and degrees, by the right
  /// hand; negative: the other way round.
  std::optional<Vec3> about = {};
  double degrees = 270;
  /// Whether a straight one stands behind them and ends there, instead of before them.
  bool behind = false;
  /// Model mm: from where to where, without parts.
  std::optional<Vec3> from = {}, to = {};
  /// Model mm: how long and how wide it is; absent: by the size of what is drawn.
  std::optional<double> length = {}, width = {};
  /// "#rrggbb" of its fill; empty: none, so that it is paper between its lines.
  std::string color = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

}  // namespace burin
