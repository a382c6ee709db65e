#pragma once
// What of other annotations leaders of callouts should not pass over; internal to the module.

#include <burin/base/box.h>
#include <burin/drawing/drawing.h>

#include <span>
#include <utility>
#include <vector>

namespace burin::detail {

class KeptClear {
 public:
  /// Of the letters that a drawing has, the lines of its dimensions and notes, and others that are
  /// laid over it later.
  KeptClear(const Drawing& drawing, std::span<const std::vector<Vec2>> later);

  /// What a leader passes over (`LeaderCosts::over`).
  double passed_over(Vec2 from, Vec2 to) const;

 private:
  std::vector<Box2> letters_;
  /// Lines that leaders may cross at need, and those that they should not.
  std::vector<std::pair<Vec2, Vec2>> dimensions_, others_;
};

}  // namespace burin::detail
