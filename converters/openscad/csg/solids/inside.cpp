#include "inside.h"

#include "space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::csg {
namespace {

// So that samples do not fall on lines that people draw through the middle of things.
constexpr std::array<double, 3> kWeights{0.4123, 0.3311, 0.2566};
// A triangle so many times larger than its error holds its sample for sure.
constexpr double kSure = 1e3;
constexpr std::size_t kFewFacets = 24;
constexpr std::size_t kMostCells = 256;

}  // namespace

Sample::Sample(Space& space, Id p, const std::array<Id, 3>& triangle)
    : plane(p), axis(space.main_axis(p)), space_(space), triangle_(triangle) {
  double lengths = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    at += kWeights[k] * space.at(triangle[k]);
    error = std::max(error, space.error(triangle[k]));
    lengths += glm::length(space.at(triangle[k]) - space.at(triangle[(k + 1) % 3]));
  }
  error += 8 * kUlp * space.size();
  const double twice = std::abs(space.area(p, triangle[0], triangle[1], triangle[2]).first);
  thin_ = !(twice > kSure * error * lengths);
  if (thin_) error = std::numeric_limits<double>::infinity();
}

const Exact& Sample::exact() {
  if (solved_) return exact_;
  solved_ = true;
  if (thin_) {
    // A third of each corner.
    const Exact &a = space_.exact_point(triangle_[0]), &b = space_.exact_point(triangle_[1]),
                &c = space_.exact_point(triangle_[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      exact_.c[k] = a.c[k] * b.c[3] * c.c[3] + b.c[k] * a.c[3] * c.c[3] + c.c[k] * a.c[3] * b.c[3];
    }
    exact_.c[3] = 3 * a.c[3] * b.c[3] * c.c[3];
    return exact_;
  }
  // The doubles across the axis, and what the plane says along it.
  const auto i = static_cast<std::size_t>((axis + 1) % 3),
             j = static_cast<std::size_t>((axis + 2) % 3), k = static_cast<std::size_t>(axis);
  const Exact& p = space_.exact_plane(plane);
  const mpq_class x(at[(axis + 1) % 3]), y(at[(axis + 2) % 3]);
  const mpz_class w = x.get_den() * y.get_den();
  const mpz_class xn = x.get_num() * y.get_den(), yn = y.get_num() * x.get_den();
  exact_.c[i] = xn * p.c[k];
  exact_.c[j] = yn * p.c[k];
  exact_.c[k] = -(p.c[i] * xn + p.c[j] * yn + p.c[3] * w);
  exact_.c[3] = w * p.c[k];
  if (exact_.c[3] < 0) {
    for (mpz_class& v : exact_.c) v = -v;
  }
  return exact_;
}

bool Inside::odd(Sample& sample) {
  Grid& grid = grids_[static_cast<std::size_t>(sample.axis)];
  bool odd = false;
  const auto look = [&](const Facet& f) {
    if (f.plane != sample.plane && hits(f, sample)) odd = !odd;
  };
  if (mesh_.facets.size() <= kFewFacets) {
    for (const Facet& f : mesh_.facets) look(f);
    return odd;
  }
  if (!grid.made) make(grid, sample.axis);
  const auto cell = [&](double v, int c) {
    return static_cast<std::size_t>(
        std::clamp((v - grid.low[c]) / grid.step[c], 0.0, static_cast<double>(grid.n - 1)));
  };
  const std::size_t at = cell(sample.at[(sample.axis + 2) % 3], 1) * grid.n +
                         cell(sample.at[(sample.axis + 1) % 3], 0);
  for (std::uint32_t k = grid.begin[at]; k < grid.begin[at + 1]; ++k) {
    look(mesh_.facets[grid.facets[k]]);
  }
  return odd;
}

void Inside::make(Grid& grid, int axis) const {
  grid.made = true;
  grid.n = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::sqrt(static_cast<double>(mesh_.facets.size()))), 1, kMostCells);
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto n = static_cast<double>(grid.n);
  grid.low = {mesh_.box.min[i], mesh_.box.min[j]};
  grid.step = glm::max(Vec2(mesh_.box.max[i], mesh_.box.max[j]) - grid.low, Vec2(1e-300)) / n;
  // Wider than anything that rounding of a cell can do.
  const double wide = 1e-9 * space_.size();
  const auto cells_of = [&](const Facet& f, auto&& take) {
    std::array<std::size_t, 4> range{};
    for (int c = 0; c < 2; ++c) {
      const int a = c == 0 ? i : j;
      const auto cell = [&](double v) {
        return static_cast<std::size_t>(std::clamp((v - grid.low[c]) / grid.step[c], 0.0, n - 1));
      };
      range[static_cast<std::size_t>(2 * c)] = cell(f.box.min[a] - wide);
      range[static_cast<std::size_t>(2 * c + 1)] = cell(f.box.max[a] + wide);
    }
    for (std::size_t y = range[2]; y <= range[3]; ++y) {
      for (std::size_t x = range[0]; x <= range[1]; ++x) take(y * grid.n + x);
    }
  };
  grid.begin.assign(grid.n * grid.n + 1, 0);
  for (const Facet& f : mesh_.facets) cells_of(f, [&](std::size_t c) { ++grid.begin[c + 1]; });
  for (std::size_t c = 0; c + 1 < grid.begin.size(); ++c) grid.begin[c + 1] += grid.begin[c];
  grid.facets.resize(grid.begin.back());
  std::vector<std::uint32_t> next(grid.begin.begin(), grid.begin.end() - 1);
  for (std::uint32_t f = 0; f < mesh_.facets.size(); ++f) {
    cells_of(mesh_.facets[f], [&](std::size_t c) { grid.facets[next[c]++] = f; });
  }
}

bool Inside::hits(const Facet& facet, Sample& sample) {
  const int i = (sample.axis + 1) % 3, j = (sample.axis + 2) % 3;
  const double x = sample.at[i], y = sample.at[j];
  if (std::isinf(sample.error)) return hits_exactly(facet, sample);
  const double e = sample.error;
  if (x < facet.box.min[i] - e || x > facet.box.max[i] + e || y < facet.box.min[j] - e ||
      y > facet.box.max[j] + e || sample.at[sample.axis] > facet.box.max[sample.axis] + e) {
    return false;
  }
  bool odd = false;
  for (const Edge& edge : facet.edges) {
    const Vec3 u = space_.at(edge.a), v = space_.at(edge.b);
    const double tol = 2 * (e + space_.error(edge.a) + space_.error(edge.b));
    if ((u[j] > y + tol && v[j] > y + tol) || (u[j] < y - tol && v[j] < y - tol)) continue;
    if (u[i] < x - tol && v[i] < x - tol) continue;
    if (std::abs(u[j] - y) <= tol || std::abs(v[j] - y) <= tol) return hits_exactly(facet, sample);
    if (u[i] > x + tol && v[i] > x + tol) {
      odd = !odd;
      continue;
    }
    const double turn = (v[i] - u[i]) * (y - u[j]) - (v[j] - u[j]) * (x - u[i]);
    const double sizes =
        std::abs(v[i] - u[i]) + std::abs(v[j] - u[j]) + std::abs(y - u[j]) + std::abs(x - u[i]);
    if (std::abs(turn) <= 4 * sizes * (tol + kUlp * sizes)) return hits_exactly(facet, sample);
    if ((turn > 0) == (v[j] > u[j])) odd = !odd;
  }
  if (!odd) return false;
  const auto [s, bound] = space_.distance(facet.plane, sample.at);
  const double n = space_.normal(facet.plane)[sample.axis];
  if (std::abs(s) <= bound + 4 * e || std::abs(n) < 1e-9) return hits_exactly(facet, sample);
  return (s < 0) == (n > 0);
}

bool Inside::hits_exactly(const Facet& facet, Sample& sample) {
  ++space_.exact_count;
  const auto axis = static_cast<std::size_t>(sample.axis), i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Exact& p = sample.exact();
  bool odd = false;
  for (const Edge& edge : facet.edges) {
    const Exact &u = space_.exact_point(edge.a), &v = space_.exact_point(edge.b);
    const bool u_below = compare(u, p, j) <= 0, v_below = compare(v, p, j) <= 0;
    if (u_below == v_below) continue;
    const int t = turn(u, v, p, i, j);
    if (t != 0 && (t > 0) == u_below) odd = !odd;
  }
  if (!odd) return false;
  const Exact& plane = space_.exact_plane(facet.plane);
  return side(p, plane) * sgn(plane.c[axis]) < 0;
}

}  // namespace burin::csg
