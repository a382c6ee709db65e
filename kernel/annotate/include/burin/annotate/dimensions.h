#pragma once
/// Dimensions: how long something is, on a line beside it.

#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/options/row.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burin {

struct DimensionOptions {
  /// Paper mm, of the numbers.
  double height = 3.5;
  /// Paper mm of the lines: narrow, after ISO 128-2.
  double line = 0.18;
  /// Places after the point; zeros at the end are left out.
  std::uint64_t decimals = 2;
  enum class Sign { Point, Comma };
  /// Between units and decimals.
  Sign sign = Sign::Point;

  bool operator==(const DimensionOptions&) const = default;
};

/// "height", "line", "decimals", "sign".
std::vector<OptionRow<DimensionOptions>> dimension_option_rows();

/// A length as it is written: "80", "12.5".
std::string dimension_text(double length, const DimensionOptions& style);

/// The length from one point of the model to another.
struct Dimension {
  /// Model mm.
  Vec3 from{0}, to{0};
  /// Unit, across the length: from these points to the line of the dimension.
  Vec3 outwards{0};
  /// Paper mm from the points to that line, across it.
  double distance = 0;
  std::string text;
};

/// Paper mm across a dimension: from what it measures to its line, and from there to its end.
struct DimensionReach {
  double line = 0, end = 0;
};
DimensionReach dimension_reach(const DimensionOptions& style);

/// Lays dimensions over a drawing, layer "dimensions": lines with arrows, extension lines that
/// begin at the ink that is nearest on them, and numbers along the lines, to be read from below or
/// from the right. Where arrows or the number have no room within, they stand outside. @cite ISO129
void lay_dimensions(Drawing& drawing, const Camera& camera, std::span<const Dimension> dimensions,
                    const DimensionOptions& style);

}  // namespace burin
