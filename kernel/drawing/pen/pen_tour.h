#pragma once
/// One group of lines in an order that keeps the pen's travel short. Internal to the module.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace burin {

/// A line as its order sees it.
struct TourLine {
  /// Where it can begin and end; of a ring the place where it does both.
  std::array<Vec2, 2> ends{};
  /// The points of a ring, at any of which it may begin; else empty.
  std::vector<Vec2> ring = {};
  /// Drawn from its second end to its first.
  bool reversed = false;
  /// Rings: where it begins.
  std::size_t start = 0;
};

/// Says of each line how it is drawn; the numbers of the lines in their order. `from`: where the
/// pen stands before. Calls `progress` now and then with the share that is done. Throws Cancelled.
std::vector<std::uint32_t> shortest_tour(std::vector<TourLine>& lines, Vec2 from,
                                         const RunContext& context,
                                         const std::function<void(double)>& progress);

}  // namespace burin
