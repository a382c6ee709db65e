#pragma once
/// The sheet under the lines as regions: each place belongs to one, and their borders are the
/// lines.

#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/base/vec.h>

#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace burin {

/// What is seen at a place of the sheet. Places of equal labels that hang together are one region.
struct AreaLabel {
  /// -1: the bare sheet.
  std::int32_t part = -1;
  /// Face of the input; -1 where faces do not count.
  std::int32_t face = -1;
  /// Which colour its face has of those of the part; -1: that of the part itself.
  std::int32_t color = -1;
  /// Step of tone, from 0, the darkest.
  std::int32_t tone = 0;
  auto operator<=>(const AreaLabel&) const = default;
};

/// The label of a place (paper mm). Called by several threads at once.
using LabelAt = std::function<AreaLabel(Vec2)>;

/// A line that regions may end at.
struct BorderLine {
  /// Paper mm.
  std::span<const Vec2> points;
  bool closed = false;
  /// What the sides that lie on it say; -1: nothing is drawn there.
  std::int32_t line = -1;
};

struct PartitionOptions {
  /// Paper mm: points so near each other become one, lines so near a point pass through it.
  double weld = 0.005;
  /// Paper mm: a line that ends so near another one is continued up to it.
  double gap = 0.25;
  /// Paper mm: a region narrower than this (twice its area by its border) goes to the neighbour
  /// with the longest common border.
  double least_width = 0.03;
  /// Paper mm: a speck beside regions of its own part and face, which differ in tone alone, goes to
  /// one of these where no disc of this diameter has room in it, and its area is less than two
  /// squares of that width. Long bands stay: fillets are made of them.
  double least_tone_width = 0;
  /// Paper mm: how far from the sides of a triangle its label is looked for. Where lines and labels
  /// know the same border by different approximations, triangles beside it are not divided.
  double slack = 0;
  /// Times that triangles with labels of two kinds are divided along the border between them.
  int rounds = 3;
};

/// A closed border of a region, with the region to the left of each side.
struct AreaRing {
  /// Indices of `Partition::points`; side `i` goes from corner `i` to the next one.
  std::vector<std::uint32_t> corners;
  /// For each side the region beyond it; -1: the edge of the sheet.
  std::vector<std::int32_t> beyond;
  /// For each side `BorderLine::line` of the line that it lies on, else -1.
  std::vector<std::int32_t> lines;
};

struct AreaRegion {
  AreaLabel label;
  /// mm^2 of paper.
  double area = 0;
  /// The outer one first, counterclockwise; then holes, clockwise.
  std::vector<AreaRing> rings;
};

struct Partition {
  /// Paper mm. Regions side by side share the points of their common border.
  std::vector<Vec2> points;
  /// By the lowest triangle; those of the bare sheet are among them. They cover the sheet once.
  std::vector<AreaRegion> regions;
  /// Triangles that still had labels of two kinds after the last round, and their mm^2.
  std::size_t mixed = 0;
  double mixed_area = 0;

  std::vector<Vec2> polygon(const AreaRing& ring) const;
  /// The rings round several regions, given by their numbers, as if they were one; paper mm.
  std::vector<std::vector<Vec2>> outline(std::span<const std::uint32_t> of) const;
};

/// Parts the sheet along the lines. What is off the sheet is left out. A gap in a line does not
/// join what lies on both its sides: each triangle of a constrained triangulation has a label of
/// its own. Throws Cancelled. Cost: n log n in the points of the lines, and seven labels a
/// triangle.
/// @cite CGAL
Partition partition(const Box2& sheet, std::span<const BorderLine> lines, const LabelAt& label_at,
                    const PartitionOptions& options, const RunContext& context);

}  // namespace burin
