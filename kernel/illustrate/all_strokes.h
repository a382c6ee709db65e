#pragma once
// The strokes of all kinds as one list; internal to the module.

#include <burin/base/curve.h>

#include "hatch_parts.h"

#include <span>
#include <vector>

namespace burin::detail {

/// Strokes of all hatchings in a row, with no copy where there is one alone.
class AllStrokes {
 public:
  explicit AllStrokes(const HatchedParts::Hatchings& hatchings) {
    if (hatchings.size() == 1) {
      strokes_ = hatchings.front()->strokes.strokes;
      return;
    }
    for (const auto& one : hatchings) {
      const std::vector<Curve3>& strokes = one->strokes.strokes;
      joined_.insert(joined_.end(), strokes.begin(), strokes.end());
    }
    strokes_ = joined_;
  }

  std::span<const Curve3> strokes() const { return strokes_; }

 private:
  std::vector<Curve3> joined_;
  std::span<const Curve3> strokes_;
};

}  // namespace burin::detail
