#pragma once
// Samples of a function on a regular grid, kept only in the blocks of 8 x 8 x 8 cells that its zero
// set may pass through.

#include <burin/base/run_context.h>
#include <burin/forms/implicit/implicit_function.h>

#include "../function/work.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace burin {

using Cell = glm::ivec3;

/// One number for a cell, of coordinates from 0 to 2^21; those along x follow one another.
inline std::uint64_t name_of(Cell c) {
  const auto part = [](int v) { return static_cast<std::uint64_t>(v) & 0x1fffff; };
  return part(c.x) | (part(c.y) << 21) | (part(c.z) << 42);
}

struct GridLayout {
  Vec3 origin{0};
  double step = 1;
  Cell cells{0};

  // Corner (i, j, k) of the grid, to the bit the same for all cells around it.
  Vec3 corner(Cell c) const { return origin + step * Vec3(c); }
  Box3 box(Cell min, Cell max) const { return {corner(min), corner(max)}; }
  Cell cell_of(Vec3 p) const { return Cell(glm::floor((p - origin) / step)); }
};

// What the range of a function over a box says about the box.
enum class Verdict : std::uint8_t { Inside, Outside, Unknown };
Verdict judge(const Interval& range);

// The grid over `domain` with a cell more on each side.
GridLayout make_layout(const Box3& domain, double step);

class Grid {
 public:
  static constexpr int kSide = 8;             // cells
  static constexpr int kCorners = kSide + 1;  // a row
  static constexpr int kSamples = kCorners * kCorners * kCorners;

  struct Block {
    Cell first{0};               // its first cell, in the grid
    std::vector<double> values;  // kSamples, x fastest

    double at(Cell c) const {
      return values[static_cast<std::size_t>((c.z * kCorners + c.y) * kCorners + c.x)];
    }
  };

  // Throws TooMuchWork where the budget does not suffice. NaN counts as outside.
  Grid(const ImplicitFunction& function, const GridLayout& layout, WorkBudget& budget,
       const RunContext& context);

  const GridLayout& layout() const { return layout_; }
  // With both signs among their samples, in an order of nearby blocks.
  const std::vector<Block>& blocks() const { return blocks_; }
  // Index of the block that holds a cell; -1 = none is kept.
  std::int32_t block_of(Cell cell) const;
  // Whether any sample was not negative.
  bool any_outside() const { return any_outside_; }

 private:
  GridLayout layout_;
  std::vector<Block> blocks_;
  std::unordered_map<std::uint64_t, std::int32_t> index_;
  bool any_outside_ = false;
};

}  // namespace burin
