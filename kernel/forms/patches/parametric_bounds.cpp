// The box of a form of patches: samples, climbed up to the extremes between them.

#include <burin/base/parallel.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/patches/parametric_form.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

int samples(const Chart& chart, int direction) {
  const NurbsData* data = nurbs_data(chart);
  if (!data) return 48;
  const int count = direction == 0 ? data->count_u : data->count_v;
  return std::clamp(4 * count, 9, 200);
}

// The largest dot(axis, S) near `uv`: steps of a shrinking pattern, which no border and no kink
// disturbs. `step` is the distance of the samples.
double climb(const Chart& chart, Vec3 axis, Vec2 uv, Vec2 step) {
  const ParameterBox box = chart.domain();
  double best = glm::dot(axis, chart.position(uv));
  for (int i = 0; i < 60; ++i) {
    Vec2 at = uv;
    for (int a = -1; a <= 1; ++a) {
      for (int b = -1; b <= 1; ++b) {
        const Vec2 q = glm::clamp(uv + step * Vec2(a, b), box.min, box.max);
        const double value = glm::dot(axis, chart.position(q));
        if (value <= best) continue;
        best = value;
        at = q;
      }
    }
    if (at == uv) step *= 0.5;
    uv = at;
    // The function is flat at its top: a thousandth of a sample is 1e-6 of what it still gains.
    if (step.x < 1e-5 * box.size().x && step.y < 1e-5 * box.size().y) break;
  }
  return best;
}

Box3 patch_bounds(const Chart& chart, const std::array<Vec3, 3>& axes) {
  const int n[2] = {samples(chart, 0), samples(chart, 1)};
  const ParameterBox box = chart.domain();
  const Vec2 step = box.size() / Vec2(n[0] - 1, n[1] - 1);
  Box3 result;
  std::array<Vec2, 3> low, high;
  for (int i = 0; i < n[0]; ++i) {
    for (int j = 0; j < n[1]; ++j) {
      const Vec2 uv = box.min + step * Vec2(i, j);
      const Vec3 p = chart.position(uv);
      for (int k = 0; k < 3; ++k) {
        const double x = glm::dot(axes[static_cast<std::size_t>(k)], p);
        if (x < result.min[k]) {
          result.min[k] = x;
          low[static_cast<std::size_t>(k)] = uv;
        }
        if (x > result.max[k]) {
          result.max[k] = x;
          high[static_cast<std::size_t>(k)] = uv;
        }
      }
    }
  }
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    result.min[k] = -climb(chart, -axes[i], low[i], step);
    result.max[k] = climb(chart, axes[i], high[i], step);
  }
  return result;
}

}  // namespace

Box3 ParametricForm::bounds(const Mat3& axes) const {
  // GLM stores columns: the rows of `axes` are the columns of its transpose.
  const Mat3 rows = glm::transpose(axes * placement_.linear);
  std::vector<Box3> boxes(patches_.size());
  parallel_for(patches_.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      boxes[i] = patch_bounds(*patches_[i], {rows[0], rows[1], rows[2]});
    }
  });
  Box3 result;
  for (const Box3& b : boxes) result.add(b);
  const Vec3 shift = axes * placement_.offset;
  result.min += shift, result.max += shift;
  return result;
}

}  // namespace burin
