#include <burin/forms/parametric/nurbs.h>

#include "tessellate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

// Radians between the normals of neighbouring grid points: tone and fields are interpolated over
// the triangles.
constexpr double kTurn = 12 * std::numbers::pi / 180;
// A cell is at most this many times longer than wide: fields are solved on the triangles.
constexpr double kAspect = 8;
constexpr int kMostCells = 1500;
// Samples a direction: a few a span of a spline, more where nothing is known of the function.
constexpr int kSpanSamples = 3, kFunctionSamples = 48, kFewest = 8, kMost = 160;

int samples(const Chart& chart, int direction) {
  const NurbsData* data = nurbs_data(chart);
  if (!data) return kFunctionSamples;
  const int count = direction == 0 ? data->count_u : data->count_v;
  const int degree = direction == 0 ? data->degree_u : data->degree_v;
  return std::clamp(kSpanSamples * (count - degree + 1) + degree, kFewest, kMost);
}

}  // namespace

GridPlan::GridPlan(const Chart& chart) : box_(chart.domain()) {
  const int n[2] = {samples(chart, 0), samples(chart, 1)};
  for (int i = 0; i < 2; ++i) {
    bend_[i].assign(static_cast<std::size_t>(n[i]), 0);
    turn_[i].assign(static_cast<std::size_t>(n[i]), 0);
  }
  std::vector<Vec3> normals(static_cast<std::size_t>(n[0] * n[1]));
  std::vector<double> along[2] = {std::vector<double>(static_cast<std::size_t>(n[1])),
                                  std::vector<double>(static_cast<std::size_t>(n[0]))};
  for (int i = 0; i < n[0]; ++i) {
    for (int j = 0; j < n[1]; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Vec2 uv = box_.min + box_.size() * Vec2(i / (n[0] - 1.0), j / (n[1] - 1.0));
      const SurfaceDerivatives d = chart.derivatives(uv);
      bend_[0][a] = std::max(bend_[0][a], glm::length(d.uu));
      bend_[1][b] = std::max(bend_[1][b], glm::length(d.vv));
      along[0][b] += glm::length(d.u) * box_.size().x / n[0];
      along[1][a] += glm::length(d.v) * box_.size().y / n[1];
      const Vec3 normal = chart_normal(d, false, uv, box_.center());
      normals[static_cast<std::size_t>(i * n[1] + j)] = normal;
      const auto turned = [&](int k) {
        const Vec3 other = normals[static_cast<std::size_t>(k)];
        if (other == Vec3(0) || normal == Vec3(0)) return 0.0;
        return 2 * std::asin(std::min(1.0, 0.5 * glm::distance(normal, other)));
      };
      if (i > 0) {
        const double rate = turned((i - 1) * n[1] + j) * (n[0] - 1) / box_.size().x;
        for (const std::size_t k : {a - 1, a}) turn_[0][k] = std::max(turn_[0][k], rate);
      }
      if (j > 0) {
        const double rate = turned(i * n[1] + j - 1) * (n[1] - 1) / box_.size().y;
        for (const std::size_t k : {b - 1, b}) turn_[1][k] = std::max(turn_[1][k], rate);
      }
    }
  }
  for (int i = 0; i < 2; ++i) length_[i] = *std::max_element(along[i].begin(), along[i].end());
}

// The number of cells up to each sample: the integral of their density.
std::vector<double> GridPlan::cumulative(int direction, double distance) const {
  const std::vector<double>&bend = bend_[direction], &turn = turn_[direction];
  std::vector<double> density(bend.size());
  double mean = 0;
  for (std::size_t i = 0; i < density.size(); ++i) {
    // A chord of parameter length h is h^2 |S''| / 8 off; half of the distance for each direction.
    density[i] = std::max(std::sqrt(bend[i] / (4 * distance)), turn[i] / kTurn);
    mean += density[i] / static_cast<double>(density.size());
  }
  const double step = box_.size()[direction] / static_cast<double>(density.size() - 1);
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < density.size(); ++i) {
    // Neighbouring cells of very different size make thin triangles.
    const double here = std::max(0.5 * (density[i - 1] + density[i]), 0.2 * mean);
    sums.push_back(sums.back() + step * here);
  }
  return sums;
}

FaceGrid GridPlan::lines(double distance, std::array<int, 2> least) const {
  FaceGrid grid;
  std::vector<double> sums[2];
  double cells[2];
  for (int i = 0; i < 2; ++i) {
    sums[i] = cumulative(i, distance);
    cells[i] = std::max(std::ceil(sums[i].back() - 1e-9),
                        static_cast<double>(least[static_cast<std::size_t>(i)]));
  }
  for (int i = 0; i < 2; ++i) {
    const double width = length_[1 - i] / cells[1 - i];
    if (width > 0) cells[i] = std::max(cells[i], std::ceil(length_[i] / (kAspect * width)));
    cells[i] = std::min(cells[i], double{kMostCells});
  }
  for (int i = 0; i < 2; ++i) {
    const auto n = static_cast<int>(cells[i]);
    const double low = box_.min[i], size = box_.size()[i];
    std::size_t k = 1;
    for (int c = 0; c <= n; ++c) {
      const double share = static_cast<double>(c) / n;
      double x = share;
      if (sums[i].back() > 0) {
        const double wanted = share * sums[i].back();
        while (k + 1 < sums[i].size() && sums[i][k] < wanted) ++k;
        const double gap = sums[i][k] - sums[i][k - 1];
        const double part = gap > 0 ? (wanted - sums[i][k - 1]) / gap : 0;
        x = (static_cast<double>(k - 1) + part) / static_cast<double>(sums[i].size() - 1);
      }
      grid.lines[i].push_back(c == 0 ? low : c == n ? box_.max[i] : low + x * size);
    }
  }
  return grid;
}

}  // namespace burin::detail
