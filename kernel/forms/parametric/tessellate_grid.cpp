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

GridPlan::GridPlan(const Chart& chart)
    : box_(chart.domain()), count_{samples(chart, 0), samples(chart, 1)} {
  for (int i = 0; i < 2; ++i) {
    bend_[i].assign(static_cast<std::size_t>(count_[i]), 0);
    turn_[i].assign(static_cast<std::size_t>(count_[i]), 0);
  }
  const Vec2 step = box_.size() / Vec2(count_[0] - 1, count_[1] - 1);
  std::vector<Vec3> normals;
  std::vector<double> along_u(bend_[1].size()), along_v(bend_[0].size());
  const auto turned = [&](std::size_t a, std::size_t b) {
    if (normals[a] == Vec3(0) || normals[b] == Vec3(0)) return 0.0;
    return 2 * std::asin(std::min(1.0, 0.5 * glm::distance(normals[a], normals[b])));
  };
  const auto raise = [](double& x, double y) { x = std::max(x, y); };
  for (std::size_t i = 0; i < bend_[0].size(); ++i) {
    for (std::size_t j = 0; j < bend_[1].size(); ++j) {
      const Vec2 uv = box_.min + step * Vec2(i, j);
      const SurfaceDerivatives d = chart.derivatives(uv);
      const Vec3 n = chart_normal(d, false, uv, box_.center());
      const std::size_t k = normals.size(), columns = bend_[1].size();
      normals.push_back(n);
      normal_.push_back({glm::dot(d.uu, n), glm::dot(d.vv, n), glm::dot(d.uv, n)});
      full_.push_back({glm::length(d.uu), glm::length(d.vv), glm::length(d.uv)});
      raise(bend_[0][i], std::max(std::abs(normal_[k].u), full_[k].u / kAlong));
      raise(bend_[1][j], std::max(std::abs(normal_[k].v), full_[k].v / kAlong));
      along_u[j] += glm::length(d.u) * step.x;
      along_v[i] += glm::length(d.v) * step.y;
      if (i > 0) {
        const double rate = turned(k, k - columns) / step.x;
        raise(turn_[0][i], rate);
        raise(turn_[0][i - 1], rate);
      }
      if (j > 0) {
        const double rate = turned(k, k - 1) / step.y;
        raise(turn_[1][j], rate);
        raise(turn_[1][j - 1], rate);
      }
    }
  }
  length_[0] = *std::max_element(along_u.begin(), along_u.end());
  length_[1] = *std::max_element(along_v.begin(), along_v.end());
}

// A chord of parameter length h is h^2 |S''| / 8 off.
std::vector<double> GridPlan::density(int direction, double distance) const {
  const std::vector<double>&bend = bend_[direction], &turn = turn_[direction];
  std::vector<double> result(bend.size());
  double mean = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::max(std::sqrt(bend[i] / (8 * distance)), turn[i] / kTurn);
    mean += result[i] / static_cast<double>(result.size());
  }
  // Neighbouring cells of very different size make thin triangles.
  for (double& d : result) d = std::max(d, 0.2 * mean);
  return result;
}

// Over a cell of both directions the distances add, those of the mixed derivative along its
// diagonal.
double GridPlan::largest_distance(const std::array<std::vector<double>, 2>& density) const {
  const auto cell = [](const Bend& b, double u, double v) {
    const double x = b.u * u * u, y = b.v * v * v, mixed = 2 * std::abs(b.mixed) * u * v;
    return 0.125 * std::max({std::abs(x), std::abs(y), std::abs(x + y) + mixed});
  };
  double largest = 0;
  for (std::size_t k = 0; k < normal_.size(); ++k) {
    const double u = density[0][k / density[1].size()], v = density[1][k % density[1].size()];
    const double hu = u > 0 ? 1 / u : box_.size().x, hv = v > 0 ? 1 / v : box_.size().y;
    largest = std::max({largest, cell(normal_[k], hu, hv), cell(full_[k], hu, hv) / kAlong});
  }
  return largest;
}

// Lines at equal shares of the integral of the density.
std::vector<double> GridPlan::places(int direction, const std::vector<double>& density,
                                     int cells) const {
  const double low = box_.min[direction], size = box_.size()[direction];
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < density.size(); ++i) {
    sums.push_back(sums.back() + 0.5 * (density[i - 1] + density[i]));
  }
  std::vector<double> lines{low};
  std::size_t k = 1;
  for (int c = 1; c < cells; ++c) {
    double x = static_cast<double>(c) / cells;
    if (sums.back() > 0) {
      const double wanted = x * sums.back();
      while (k + 1 < sums.size() && sums[k] < wanted) ++k;
      const double gap = sums[k] - sums[k - 1];
      const double part = gap > 0 ? (wanted - sums[k - 1]) / gap : 0;
      x = (static_cast<double>(k - 1) + part) / static_cast<double>(sums.size() - 1);
    }
    lines.push_back(low + x * size);
  }
  lines.push_back(box_.max[direction]);
  return lines;
}

FaceGrid GridPlan::lines(double distance, std::array<int, 2> least) const {
  std::array<std::vector<double>, 2> dense{density(0, distance), density(1, distance)};
  const double both = largest_distance(dense);
  if (both > distance) {
    const double share = distance * distance / both;
    dense = {density(0, share), density(1, share)};
  }
  double cells[2];
  for (int i = 0; i < 2; ++i) {
    double sum = 0;
    const std::vector<double>& d = dense[static_cast<std::size_t>(i)];
    for (std::size_t k = 1; k < d.size(); ++k) sum += 0.5 * (d[k - 1] + d[k]);
    sum *= box_.size()[i] / static_cast<double>(d.size() - 1);
    cells[i] =
        std::max(std::ceil(sum - 1e-9), static_cast<double>(least[static_cast<std::size_t>(i)]));
  }
  FaceGrid grid;
  for (int i = 0; i < 2; ++i) {
    const double width = length_[1 - i] / cells[1 - i];
    if (width > 0) cells[i] = std::max(cells[i], std::ceil(length_[i] / (kAspect * width)));
    cells[i] = std::min(cells[i], double{kMostCells});
    grid.lines[i] = places(i, dense[static_cast<std::size_t>(i)], static_cast<int>(cells[i]));
  }
  return grid;
}

}  // namespace burin::detail
