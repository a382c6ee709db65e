#include "grid.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin {
namespace {

constexpr std::size_t kMaxBlocks = 60'000;  // 30 million cells, 0.4 GB

// A cube of cells under way to the blocks, with the part of the function that matters in it.
struct GridCube {
  Cell first{0};
  int side = 0;
  const ImplicitFunction* function = nullptr;
  std::shared_ptr<const ImplicitFunction> own;
};

// Nanoseconds for all cubes and for the worst one.
struct Work {
  double all = 0, most = 0;
};
Work work_of(const std::vector<GridCube>& cubes, double each) {
  Work w;
  for (const GridCube& c : cubes) {
    const double one = each * c.function->cost();
    w.all += one;
    w.most = std::max(w.most, one);
  }
  return w;
}

std::vector<GridCube> halves(const GridCube& c, const Cell& cells) {
  std::vector<GridCube> out;
  const int half = c.side / 2;
  for (int k = 0; k < 8; ++k) {
    GridCube part = c;
    part.first += half * Cell(k & 1, (k >> 1) & 1, (k >> 2) & 1);
    part.side = half;
    if (part.first.x < cells.x && part.first.y < cells.y && part.first.z < cells.z) {
      out.push_back(part);
    }
  }
  return out;
}

}  // namespace

Verdict judge(const Interval& range) {
  // Rounding of the samples must not disagree: a relative 1e-12 counts as zero.
  const double slack = 1e-12 * (std::abs(range.min) + std::abs(range.max));
  if (!(std::abs(range.min) < 1e300) || !(std::abs(range.max) < 1e300)) {
    // Infinite ends: only the finite one tells.
    return range.min > 0 ? Verdict::Outside : range.max < 0 ? Verdict::Inside : Verdict::Unknown;
  }
  if (range.min > slack) return Verdict::Outside;
  if (range.max < -slack) return Verdict::Inside;
  return Verdict::Unknown;
}

GridLayout make_layout(const Box3& domain, double step) {
  GridLayout layout;
  layout.step = step;
  const Vec3 size = domain.size();
  for (int a = 0; a < 3; ++a) {
    // The outermost samples inside lie 0.05 to 0.55 of a step behind the domain's faces, which a
    // solid's own mostly are: what is thin along them is seen.
    constexpr double kBehind = 0.05;
    layout.cells[a] = 2 + static_cast<int>(std::floor(size[a] / step - 2 * kBehind));
  }
  // Centred, and off the grid by an odd share of a step, so that symmetric shapes do not pass
  // through corners: coordinate planes and the like.
  layout.origin =
      domain.center() - 0.5 * step * Vec3(layout.cells) + step * Vec3(0.0137, 0.0291, 0.0213);
  return layout;
}

Grid::Grid(const ImplicitFunction& function, const GridLayout& layout, WorkBudget& budget,
           const RunContext& context)
    : layout_(layout) {
  const int longest = std::max({layout.cells.x, layout.cells.y, layout.cells.z});
  GridCube root;
  root.function = &function;
  for (root.side = kSide; root.side < longest;) root.side *= 2;
  std::vector<GridCube> cubes{root};
  // Level by level, so that the work is shared evenly and the order never depends on it.
  for (;;) {
    const Work boxes = work_of(cubes, work::kBox);
    budget.spend(boxes.all, 1);
    std::vector<Verdict> verdicts(cubes.size());
    parallel_for(
        cubes.size(), work::grain(boxes.most, 16),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            GridCube& c = cubes[i];
            const Box3 box = layout_.box(c.first, c.first + c.side);
            verdicts[i] = judge(c.function->range(box));
            if (verdicts[i] != Verdict::Unknown) continue;
            if (auto part = c.function->restricted(box)) {
              c.own = std::move(part);
              c.function = c.own.get();
            }
          }
        },
        &context);
    std::vector<GridCube> kept;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      any_outside_ |= verdicts[i] == Verdict::Outside;
      if (verdicts[i] == Verdict::Unknown) kept.push_back(std::move(cubes[i]));
    }
    if (kept.size() > kMaxBlocks) throw TooMuchWork();
    cubes = std::move(kept);
    if (cubes.empty() || cubes.front().side == kSide) break;
    std::vector<GridCube> next;
    for (const GridCube& c : cubes) {
      for (GridCube& part : halves(c, layout_.cells)) next.push_back(std::move(part));
    }
    cubes = std::move(next);
  }

  const Work samples = work_of(cubes, kSamples * work::kValue);
  budget.spend(samples.all, 1);
  std::vector<Block> all(cubes.size());
  std::vector<std::uint8_t> signs(cubes.size());
  parallel_for(
      cubes.size(), work::grain(samples.most, 4),
      [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3> points(kSamples);
        for (std::size_t i = begin; i < end; ++i) {
          Block& b = all[i];
          b.first = cubes[i].first;
          std::size_t n = 0;
          for (int z = 0; z < kCorners; ++z) {
            for (int y = 0; y < kCorners; ++y) {
              for (int x = 0; x < kCorners; ++x)
                points[n++] = layout_.corner(b.first + Cell(x, y, z));
            }
          }
          b.values.resize(kSamples);
          cubes[i].function->values(points, b.values);
          std::size_t inside = 0;
          for (const double v : b.values) inside += v < 0;
          signs[i] = static_cast<std::uint8_t>((inside > 0 ? 1 : 0) | (inside < kSamples ? 2 : 0));
          if (signs[i] != 3) b.values = {};
        }
      },
      &context);
  for (std::size_t i = 0; i < all.size(); ++i) {
    any_outside_ |= (signs[i] & 2) != 0;
    if (signs[i] != 3) continue;
    index_.emplace(name_of(all[i].first / kSide), static_cast<std::int32_t>(blocks_.size()));
    blocks_.push_back(std::move(all[i]));
  }
}

std::int32_t Grid::block_of(Cell cell) const {
  if (cell.x < 0 || cell.y < 0 || cell.z < 0) return -1;
  const auto it = index_.find(name_of(cell / kSide));
  return it == index_.end() ? -1 : it->second;
}

}  // namespace burin
