// Bounds of a spline over boxes: values lie between the least and the largest coefficient that
// takes part.

#include <burin/base/parallel.h>

#include "volume_spline.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using Size = std::array<std::int32_t, 3>;

// Coefficients along a box that are looked at one by one.
constexpr std::int32_t kFew = 16;

struct Extremes {
  float min = std::numeric_limits<float>::infinity(), max = -min;
  void add(float low, float high) {
    min = std::min(min, low);
    max = std::max(max, high);
  }
};

std::size_t index(const Size& size, std::int32_t x, std::int32_t y, std::int32_t z) {
  return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) +
          static_cast<std::size_t>(y)) *
             static_cast<std::size_t>(size[0]) +
         static_cast<std::size_t>(x);
}

// Over all places from `low` to `high`, both taken in.
template <class Body>
void for_rows(const Size& size, const Size& low, const Size& high, Body&& body) {
  for (std::int32_t z = low[2]; z <= high[2]; ++z) {
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      body(index(size, low[0], y, z), static_cast<std::size_t>(high[0] - low[0] + 1));
    }
  }
}

}  // namespace

void VolumeSpline::make_levels(const RunContext& context) {
  for (Size below = size_; below[0] > 1 || below[1] > 1 || below[2] > 1;) {
    const Level* finer = levels_.empty() ? nullptr : &levels_.back();
    Level level;
    for (std::size_t a = 0; a < 3; ++a) level.size[a] = (below[a] + kBlock - 1) / kBlock;
    level.range.resize(index(level.size, 0, 0, level.size[2]));
    parallel_for(
        static_cast<std::size_t>(level.size[2]), 1,
        [&](std::size_t begin, std::size_t) {
          const auto z = static_cast<std::int32_t>(begin);
          for (std::int32_t y = 0; y < level.size[1]; ++y) {
            for (std::int32_t x = 0; x < level.size[0]; ++x) {
              const Size low{kBlock * x, kBlock * y, kBlock * z};
              Size high = low;
              for (std::size_t a = 0; a < 3; ++a) {
                high[a] = std::min(low[a] + kBlock, below[a]) - 1;
              }
              Extremes e;
              for_rows(below, low, high, [&](std::size_t first, std::size_t n) {
                for (std::size_t i = first; i < first + n; ++i) {
                  if (finer) {
                    e.add(finer->range[i][0], finer->range[i][1]);
                  } else {
                    e.add(coefficients_[i], coefficients_[i]);
                  }
                }
              });
              level.range[index(level.size, x, y, z)] = {e.min, e.max};
            }
          }
        },
        &context);
    below = level.size;
    levels_.push_back(std::move(level));
  }
}

void VolumeSpline::taking_part(Vec3 min, Vec3 max, Size& low, Size& high) const {
  for (int a = 0; a < 3; ++a) {
    const double from = std::clamp(min[a], 0.0, last_[a]), to = std::clamp(max[a], 0.0, last_[a]);
    const double first = degree_ == 2 ? std::floor(from + 0.5) : std::floor(from);
    const double end = degree_ == 2 ? std::floor(to + 0.5) + 2 : std::floor(to) + 3;
    const auto k = static_cast<std::size_t>(a);
    low[k] = std::clamp(static_cast<std::int32_t>(first), 0, size_[k] - 1);
    high[k] = std::clamp(static_cast<std::int32_t>(end), low[k], size_[k] - 1);
  }
}

Interval VolumeSpline::range(Vec3 min, Vec3 max) const {
  Size low, high;
  taking_part(min, max, low, high);
  // Coefficients themselves in boxes up to this, else the finest level with as few.
  const auto wide = [&] {
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}) >= kFew;
  };
  std::size_t level = 0;
  for (; wide() && level < levels_.size(); ++level) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] /= kBlock;
      high[a] /= kBlock;
    }
  }
  Extremes e;
  if (level == 0) {
    for_rows(size_, low, high, [&](std::size_t first, std::size_t n) {
      for (std::size_t i = first; i < first + n; ++i) e.add(coefficients_[i], coefficients_[i]);
    });
  } else {
    const Level& l = levels_[level - 1];
    for_rows(l.size, low, high, [&](std::size_t first, std::size_t n) {
      for (std::size_t i = first; i < first + n; ++i) e.add(l.range[i][0], l.range[i][1]);
    });
  }
  return {e.min, e.max};
}

// Derivatives are splines over the differences of neighbours.
std::array<Interval, 3> VolumeSpline::slopes(Vec3 min, Vec3 max) const {
  Size low, high;
  taking_part(min, max, low, high);
  if (std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}) >= kFew) return {};
  const std::ptrdiff_t next[3] = {1, row_, slice_};
  std::array<Interval, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    Size last = high;
    last[a] = std::max(low[a], high[a] - 1);
    Extremes e;
    for_rows(size_, low, last, [&](std::size_t first, std::size_t n) {
      const float* c = coefficients_.data() + first;
      for (std::size_t i = 0; i < n; ++i) {
        const float d = c[static_cast<std::ptrdiff_t>(i) + next[a]] - c[i];
        e.add(d, d);
      }
    });
    out[a] = {e.min, e.max};
  }
  return out;
}

Interval VolumeSpline::border_range() const {
  // On a side only its own layer counts: the rim is odd about it.
  Extremes e;
  for (std::size_t a = 0; a < 3; ++a) {
    for (const std::int32_t layer : {1, size_[a] - 2}) {
      Size low{0, 0, 0}, high{size_[0] - 1, size_[1] - 1, size_[2] - 1};
      low[a] = high[a] = layer;
      for_rows(size_, low, high, [&](std::size_t first, std::size_t n) {
        for (std::size_t i = first; i < first + n; ++i) e.add(coefficients_[i], coefficients_[i]);
      });
    }
  }
  return {e.min, e.max};
}

Box3 VolumeSpline::support(double level, bool above) const {
  const auto side = [&](float c) { return above ? c > level : c < level; };
  // Layers, each a slot of its own for the threads.
  std::vector<Box3> boxes(static_cast<std::size_t>(size_[2]));
  parallel_for(boxes.size(), 1, [&](std::size_t begin, std::size_t) {
    const auto z = static_cast<std::int32_t>(begin);
    for (std::int32_t y = 0; y < size_[1]; ++y) {
      const float* row = coefficients_.data() + index(size_, 0, y, z);
      const float* end = row + size_[0];
      const float* first = std::find_if(row, end, side);
      if (first == end) continue;
      const float* last = end - 1;
      while (!side(*last)) --last;
      boxes[begin].add(Vec3(first - row, y, z) - 1.0);
      boxes[begin].add(Vec3(last - row, y, z) - 1.0);
    }
  });
  Box3 all;
  for (const Box3& b : boxes) all.add(b);
  if (all.empty()) return all;
  const double reach = 0.5 * (degree_ + 1);
  all.min = glm::max(all.min - reach, Vec3(0));
  all.max = glm::min(all.max + reach, last_);
  return all;
}

}  // namespace burin
