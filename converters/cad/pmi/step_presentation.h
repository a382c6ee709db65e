#pragma once
/// How a STEP file shows annotations in space: lines and triangles; internal to the reading of PMI.

#include <burin/surface/pmi.h>

#include "step_text.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Axes of a placement in the file's unit of length.
struct StepAxes {
  Vec3 origin{0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  Vec3 point(const Vec3& p) const { return origin + p.x * x + p.y * y + p.z * z; }
};
/// Of an AXIS2_PLACEMENT_3D; what it leaves out is as ISO 10303-42 has it.
StepAxes axes_of(const StepText& text, std::int64_t number);
std::optional<Vec3> point_of(const StepText& text, std::int64_t number);

/// What an annotation is drawn with, in the file's unit of length.
struct StepShown {
  std::vector<PmiLine> lines, filled;
  /// Of the plane that it says of itself.
  std::optional<StepAxes> plane;
};

/// Follows callouts and occurrences down to curves and triangles.
class StepPresentation {
 public:
  StepPresentation(const StepText& text, std::map<std::string, std::int64_t>& unknown)
      : text_(text), unknown_(unknown) {}

  StepShown of(std::int64_t callout);

 private:
  void visit(std::int64_t number, int depth, const StepAxes& place, StepShown& shown);
  void curve_set(const StepRecord& record, const StepAxes& place, StepShown& shown) const;
  void triangles(const StepRecord& record, const StepAxes& place, StepShown& shown) const;
  std::vector<Vec3> coordinates(std::int64_t number, const StepAxes& place) const;

  const StepText& text_;
  std::map<std::string, std::int64_t>& unknown_;
};

/// A curve in space as points; absent where its type is not understood.
std::optional<PmiLine> polyline_of(const StepText& text, std::int64_t curve);

/// What triangles in a plane cover, as closed lines: edges that one of them has alone. Corners at
/// one place are one.
std::vector<PmiLine> outlines_of(const std::vector<std::array<Vec3, 3>>& triangles);

}  // namespace burin
