#pragma once
/// The order in which a pen draws lines, so that it travels little with nothing on the paper.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace burin {

/// A line as it was given.
struct PenPath {
  /// Paper mm, finite, at least one; a closed line does not repeat its first.
  std::span<const Vec2> points;
  bool closed = false;
  /// Drawn after all lines of lower groups: the number of a pen, or of a layer.
  std::uint32_t group = 0;
  /// Joined with lines of the same group and mark alone (a width, say); negative: with none.
  std::int64_t mark = 0;
};

/// A given line inside a line that is drawn.
struct PenRun {
  std::uint32_t path = 0;
  bool reversed = false;
};

/// A line that is drawn without lifting the pen: one that was given, or several one after the
/// other.
struct PenLine {
  std::uint32_t group = 0;
  /// Of `PenOrder::runs`.
  std::uint32_t first_run = 0, runs = 0;
  bool closed = false;
  /// Closed lines: the point where the pen begins, as `points_of` counts with 0 here.
  std::size_t start = 0;
};

struct PenOrder {
  /// In the order of drawing; each given line is in one of them, once.
  std::vector<PenLine> lines;
  std::vector<PenRun> runs;
  /// Paper mm with the pen on the paper, and from the end of each line to the beginning of the
  /// next, with the way to the first.
  double drawn = 0, travel = 0;
};

struct PenOrderOptions {
  /// Paper mm: ends that lie no farther apart are joined.
  double join = 0.003;
  /// Where the pen stands first.
  Vec2 from{0};
  /// Called now and then with the share that is done.
  std::function<void(double)> progress = {};
};

/// Joins lines whose ends meet (where more than two do, those that go on the straightest; rings
/// become closed lines), then orders them group by group: the nearest end comes next, closed lines
/// begin anywhere, and lines are turned round, as are runs of up to 25,000 of them, and moved, up
/// to three at once, as long as that shortens the way (2-opt and Or-opt among the eight nearest
/// ends). The same order for any number of threads. Polls `context`, which throws Cancelled. Cost:
/// about n log n; 100,000 lines take about 2 s of processor time, a million 35 (measured in
/// tests/bench/results/writers.md). @cite Bentley1992
PenOrder pen_order(std::span<const PenPath> paths, const PenOrderOptions& options,
                   const RunContext& context);

/// The lines as they were given, group by group, for comparison.
PenOrder given_order(std::span<const PenPath> paths, Vec2 from, const RunContext& context);

/// The points of a line that is drawn, from where the pen begins; a closed one does not repeat its
/// first.
std::vector<Vec2> points_of(const PenLine& line, const PenOrder& order,
                            std::span<const PenPath> paths);

}  // namespace burin
