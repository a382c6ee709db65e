#include "nurbs_spans.h"

#include <burin/base/box.h>
#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace {

// Basis functions live on the stack; degrees above 25 are unknown to CAD systems.
constexpr int kMaxDegree = 60;

void check_direction(const char* name, int degree, int count, const std::vector<double>& knots) {
  if (degree < 1 || degree > kMaxDegree) {
    throw GeometryError(
        fmt::format("surface of degree {} in {}: it must be 1 to {}", degree, name, kMaxDegree));
  }
  if (count <= degree) {
    throw GeometryError(
        fmt::format("surface with {} control points in {}: degree {} needs at least {}", count,
                    name, degree, degree + 1));
  }
  const auto expected = static_cast<std::size_t>(count + degree + 1);
  if (knots.size() != expected) {
    throw GeometryError(
        fmt::format("surface with {} knots in {}: {} are needed", knots.size(), name, expected));
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) {
      throw GeometryError(fmt::format("knot {} in {} is not a finite number", i, name));
    }
    if (i > 0 && knots[i] < knots[i - 1]) {
      throw GeometryError(fmt::format("knot {} in {} is smaller than the one before", i, name));
    }
  }
  if (!(knots[static_cast<std::size_t>(count)] > knots[static_cast<std::size_t>(degree)])) {
    throw GeometryError(fmt::format("surface whose knots in {} leave no domain", name));
  }
}

void check_points(const NurbsData& data) {
  const auto expected =
      static_cast<std::size_t>(data.count_u) * static_cast<std::size_t>(data.count_v);
  if (data.points.size() != expected) {
    throw GeometryError(fmt::format("surface with {} control points: {} x {} are needed",
                                    data.points.size(), data.count_u, data.count_v));
  }
  if (!data.weights.empty() && data.weights.size() != expected) {
    throw GeometryError(fmt::format("surface with {} weights for {} control points",
                                    data.weights.size(), expected));
  }
  for (std::size_t i = 0; i < expected; ++i) {
    const Vec3 p = data.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw GeometryError(fmt::format("control point {} is not finite", i));
    }
  }
  for (std::size_t i = 0; i < data.weights.size(); ++i) {
    if (!(data.weights[i] > 0) || !std::isfinite(data.weights[i])) {
      throw GeometryError(fmt::format("weight {} of control point {} is not a positive number",
                                      data.weights[i], i));
    }
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A point farther from the others than this many times their usual distance, or a weight as far
// from the others, is damage (repair.cpp has the same for meshes): the rest of the surface would be
// smaller on paper than an atom.
constexpr double kWildRatio = 1e9;

void check_wild(const NurbsData& data) {
  std::vector<double> values(data.points.size());
  Vec3 center(0);
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = data.points[i][k];
    center[k] = median(values);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = glm::length(data.points[i] - center);
  }
  double usual = median(values);
  if (!(usual > 0)) {  // half of the points in one place
    usual = std::numeric_limits<double>::infinity();
    for (const double d : values) usual = d > 0 ? std::min(usual, d) : usual;
  }
  const auto farthest = std::max_element(values.begin(), values.end());
  if (*farthest > kWildRatio * usual) {
    throw GeometryError(fmt::format(
        "control point {} lies a billion times farther out than the others; the data is damaged",
        farthest - values.begin()));
  }
  if (data.weights.empty()) return;
  const auto [least, most] = std::minmax_element(data.weights.begin(), data.weights.end());
  if (*most > kWildRatio * *least) {
    throw GeometryError(
        fmt::format("weights of control points from {} to {}; the data is damaged", *least, *most));
  }
}

/// All control points as (w (P - origin), w).
std::vector<Vec4> homogeneous(const NurbsData& data, Vec3 origin, bool rational) {
  double largest = 1;
  if (rational) largest = *std::max_element(data.weights.begin(), data.weights.end());
  std::vector<Vec4> result(data.points.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double w = rational ? data.weights[i] / largest : 1;
    result[i] = Vec4(w * (data.points[i] - origin), w);
  }
  return result;
}

bool has_unequal_weights(const NurbsData& data) {
  return std::any_of(data.weights.begin(), data.weights.end(),
                     [&](double w) { return w != data.weights.front(); });
}

}  // namespace

void check_nurbs(const NurbsData& data) {
  check_direction("u", data.degree_u, data.count_u, data.knots_u);
  check_direction("v", data.degree_v, data.count_v, data.knots_v);
  check_points(data);
  check_wild(data);
}

NurbsSpans::NurbsSpans(const NurbsData& data)
    : u(data.knots_u, data.degree_u, data.count_u, data.periodic_u),
      v(data.knots_v, data.degree_v, data.count_v, data.periodic_v),
      degree_u(data.degree_u),
      degree_v(data.degree_v),
      rational(has_unequal_weights(data)) {
  Box3 box;
  for (const Vec3& p : data.points) box.add(p);
  origin = box.center();
  const std::vector<Vec4> control = homogeneous(data, origin, rational);
  const auto ou = static_cast<std::size_t>(degree_u) + 1,
             ov = static_cast<std::size_t>(degree_v) + 1;
  const auto stride = static_cast<std::size_t>(data.count_v);
  per_patch = ou * ov;
  points.assign(u.size() * v.size() * per_patch, Vec4(0));
  std::vector<std::vector<double>> ev(v.size());
  for (std::size_t s = 0; s < v.size(); ++s) ev[s] = v.extraction(s);
  std::vector<Vec4> rows(ou * stride);
  for (std::size_t su = 0; su < u.size(); ++su) {
    const std::vector<double> eu = u.extraction(su);
    const auto first_u = static_cast<std::size_t>(u.first_control(su));
    std::fill(rows.begin(), rows.end(), Vec4(0));
    for (std::size_t j = 0; j < ou; ++j) {
      for (std::size_t i = 0; i < ou; ++i) {
        for (std::size_t c = 0; c < stride; ++c) {
          rows[j * stride + c] += eu[j * ou + i] * control[(first_u + i) * stride + c];
        }
      }
    }
    for (std::size_t sv = 0; sv < v.size(); ++sv) {
      const auto first_v = static_cast<std::size_t>(v.first_control(sv));
      Vec4* patch_points = &points[(su * v.size() + sv) * per_patch];
      for (std::size_t j = 0; j < ou; ++j) {
        for (std::size_t k = 0; k < ov; ++k) {
          for (std::size_t i = 0; i < ov; ++i) {
            patch_points[j * ov + k] += ev[sv][k * ov + i] * rows[j * stride + first_v + i];
          }
        }
      }
    }
  }
}

}  // namespace burin
