#pragma once
/// The wires of a face as polygons in (u,v).

#include "model_parts.h"

#include <vector>

namespace burin {

/// Samples of all coedges of a face; good enough to tell inside from outside away from the wires.
class TrimPolygon {
 public:
  TrimPolygon(const ModelParts& parts, std::int32_t face);

  bool empty() const { return sides_.empty(); }
  const Box2& box() const { return box_; }
  /// Where the line v = const enters and leaves the face: u, ascending, in pairs.
  std::vector<double> crossings(double v) const;

  struct Side {
    Vec2 a, b;
  };
  const std::vector<Side>& sides() const { return sides_; }

 private:
  std::vector<Side> sides_;
  Box2 box_;
};

}  // namespace burin
