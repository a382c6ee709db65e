#include <burin/forms/charted/nurbs.h>

#include "tessellate.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
// The same between two break lines.
constexpr int kPieceFewest = 4;
// A break line belongs to the span above it: derivatives are taken this share of the domain inside.
constexpr double kInside = 1e-11;
// A grid may have so many times the cells that its places need each by itself, and this many in
// any case: a bend along both directions is even, spots that ask for much more are not.
constexpr double kGridExcess = 6, kSmallGrid = 2000;
// Asks `breaks` for all knots.
constexpr int kAnyOrder = std::numeric_limits<int>::max();

int degree(const Chart& chart, int direction) {
  const NurbsData* data = nurbs_data(chart);
  return !data ? 3 : direction == 0 ? data->degree_u : data->degree_v;
}

int samples_between(const Chart& chart, int direction, double from, double to) {
  const std::vector<double> knots = chart.breaks(direction, kAnyOrder);
  if (knots.empty() && !nurbs_data(chart)) return kFunctionSamples;
  int spans = 1;
  for (const double k : knots) spans += k > from && k < to;
  const ParameterBox box = chart.domain();
  const bool whole = from == box.min[direction] && to == box.max[direction];
  return std::clamp(kSpanSamples * spans + degree(chart, direction), whole ? kFewest : kPieceFewest,
                    kMost);
}

void raise(double& x, double y) { x = std::max(x, y); }

}  // namespace

GridPlan::GridPlan(const Chart& chart) : box_(chart.domain()) {
  find_pieces(chart);
  sample(chart);
}

void GridPlan::find_pieces(const Chart& chart) {
  for (int i = 0; i < 2; ++i) {
    std::vector<double> ends{box_.min[i]};
    for (const double b : chart.breaks(i, 1)) ends.push_back(b);
    ends.push_back(box_.max[i]);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      Piece p{ends[k], ends[k + 1], at_[i].size(), 0};
      p.count = static_cast<std::size_t>(samples_between(chart, i, p.from, p.to));
      const double margin = kInside * box_.size()[i];
      for (std::size_t s = 0; s < p.count; ++s) {
        const double x = p.from + p.step() * static_cast<double>(s);
        at_[i].push_back(x);
        inside_[i].push_back(ends.size() > 2 ? std::clamp(x, p.from + margin, p.to - margin) : x);
        width_[i].push_back(p.step() * (s == 0 || s + 1 == p.count ? 0.5 : 1));
      }
      pieces_[i].push_back(p);
    }
    bend_[i].assign(at_[i].size(), 0);
    turn_[i].assign(at_[i].size(), 0);
  }
}

void GridPlan::sample(const Chart& chart) {
  const std::size_t columns = at_[0].size(), rows = at_[1].size();
  std::vector<Vec3> normals;
  normal_turn_.assign(columns * rows, Vec2(0));
  std::vector<double> along_u(rows), along_v(columns);
  const auto turned = [&](std::size_t a, std::size_t b) {
    if (normals[a] == Vec3(0) || normals[b] == Vec3(0)) return 0.0;
    return 2 * std::asin(std::min(1.0, 0.5 * glm::distance(normals[a], normals[b])));
  };
  // Neighbours on both sides of a break line are one place.
  const auto note = [&](int direction, std::size_t i, std::size_t k, std::size_t before) {
    const double step = at_[direction][i] - at_[direction][i - 1];
    if (!(step > 0)) return;
    const double rate = turned(k, before) / step;
    raise(turn_[direction][i], rate);
    raise(turn_[direction][i - 1], rate);
    raise(normal_turn_[k][direction], rate);
    raise(normal_turn_[before][direction], rate);
  };
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      const Vec2 uv(inside_[0][i], inside_[1][j]);
      const SurfaceDerivatives d = chart.derivatives(uv);
      const Vec3 n = chart_normal(d, false, uv, box_.center());
      const std::size_t k = normals.size();
      normals.push_back(n);
      normal_.push_back({glm::dot(d.uu, n), glm::dot(d.vv, n), glm::dot(d.uv, n)});
      full_.push_back({glm::length(d.uu), glm::length(d.vv), glm::length(d.uv)});
      raise(bend_[0][i], std::max(std::abs(normal_[k].u), full_[k].u / kAlong));
      raise(bend_[1][j], std::max(std::abs(normal_[k].v), full_[k].v / kAlong));
      along_u[j] += glm::length(d.u) * width_[0][i];
      along_v[i] += glm::length(d.v) * width_[1][j];
      if (i > 0) note(0, i, k, k - rows);
      if (j > 0) note(1, j, k, k - 1);
    }
  }
  length_[0] = *std::max_element(along_u.begin(), along_u.end());
  length_[1] = *std::max_element(along_v.begin(), along_v.end());
}

// A chord of parameter length h is h^2 |S''| / 8 off.
std::vector<double> GridPlan::density(int direction, double distance) const {
  const std::vector<double>&bend = bend_[direction], &turn = turn_[direction];
  std::vector<double> result(bend.size());
  for (const Piece& p : pieces_[direction]) {
    double mean = 0;
    for (std::size_t i = p.first; i < p.first + p.count; ++i) {
      result[i] = std::max(std::sqrt(bend[i] / (8 * distance)), turn[i] / kTurn);
      mean += result[i] / static_cast<double>(p.count);
    }
    // Neighbouring cells of very different size make thin triangles.
    for (std::size_t i = p.first; i < p.first + p.count; ++i) raise(result[i], 0.2 * mean);
  }
  return result;
}

// Over a cell of both directions the distances add, those of the mixed derivative along its
// diagonal.
double GridPlan::largest_distance(const Density& density) const {
  const auto cell = [](const Bend& b, double u, double v) {
    const double x = b.u * u * u, y = b.v * v * v, mixed = 2 * std::abs(b.mixed) * u * v;
    return 0.125 * std::max({std::abs(x), std::abs(y), std::abs(x + y) + mixed});
  };
  // No cell is wider than its piece.
  std::array<std::vector<double>, 2> width;
  for (int i = 0; i < 2; ++i) {
    auto& w = width[static_cast<std::size_t>(i)];
    for (const Piece& p : pieces_[i]) {
      for (std::size_t k = p.first; k < p.first + p.count; ++k) {
        const double d = density[static_cast<std::size_t>(i)][k];
        const double most = pieces_[i].size() > 1 || !(d > 0)
                                ? p.to - p.from
                                : std::numeric_limits<double>::infinity();
        w.push_back(d > 0 ? std::min(1 / d, most) : most);
      }
    }
  }
  double largest = 0;
  for (std::size_t k = 0; k < normal_.size(); ++k) {
    const double hu = width[0][k / at_[1].size()], hv = width[1][k % at_[1].size()];
    largest = std::max({largest, cell(normal_[k], hu, hv), cell(full_[k], hu, hv) / kAlong});
  }
  return largest;
}

// Lines at equal shares of the integral of the density, after the one at the piece's beginning.
std::vector<double> GridPlan::places(const Piece& piece, const std::vector<double>& density,
                                     int cells) const {
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < piece.count; ++i) {
    sums.push_back(sums.back() + 0.5 * (density[piece.first + i - 1] + density[piece.first + i]));
  }
  std::vector<double> lines;
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
    lines.push_back(piece.from + x * (piece.to - piece.from));
  }
  lines.push_back(piece.to);
  return lines;
}

double GridPlan::cells(const Piece& piece, const std::vector<double>& density) const {
  double sum = 0;
  for (std::size_t k = piece.first + 1; k < piece.first + piece.count; ++k) {
    sum += 0.5 * (density[k - 1] + density[k]);
  }
  return std::max(1.0, std::ceil(sum * piece.step() - 1e-9));
}

double GridPlan::all_cells(const Density& density) const {
  double product = 1;
  for (int i = 0; i < 2; ++i) {
    double sum = 0;
    for (const Piece& p : pieces_[i]) sum += cells(p, density[static_cast<std::size_t>(i)]);
    product *= sum;
  }
  return product;
}

// The cells that there would be if each place had its own density.
double GridPlan::needed_cells(double distance) const {
  const auto own = [&](double normal, double full, double turn) {
    const double bend = std::max(std::abs(normal), full / kAlong);
    return std::max(std::sqrt(bend / (8 * distance)), turn / kTurn);
  };
  const std::size_t rows = at_[1].size();
  double sum = 0;
  for (std::size_t k = 0; k < normal_.size(); ++k) {
    const double u = own(normal_[k].u, full_[k].u, normal_turn_[k].x);
    const double v = own(normal_[k].v, full_[k].v, normal_turn_[k].y);
    const double wu = width_[0][k / rows], wv = width_[1][k % rows];
    // A direction that is straight here still takes part in the cells of the other one.
    sum += (u * wu + wu / box_.size().x) * (v * wv + wv / box_.size().y);
  }
  return sum;
}

GridPlan::Density GridPlan::densities(double distance, double share) const {
  Density dense{density(0, distance), density(1, distance)};
  const double both = largest_distance(dense);
  if (both > distance) {
    const double nearer = distance * distance / both;
    dense = {density(0, nearer), density(1, nearer)};
  }
  const double all = all_cells(dense);
  if (all > kSmallGrid) {
    const double most = std::max(kSmallGrid, kGridExcess * needed_cells(distance));
    share *= std::sqrt(std::min(1.0, most / all));
  }
  for (auto& d : dense) {
    for (double& x : d) x *= share;
  }
  return dense;
}

FaceGrid GridPlan::lines(double distance, double share, std::array<int, 2> least) const {
  const Density dense = densities(distance, share);
  std::array<std::vector<double>, 2> counts;
  std::array<double, 2> sums{0, 0}, wanted{0, 0};
  for (std::size_t i = 0; i < 2; ++i) {
    for (const Piece& p : pieces_[i]) {
      counts[i].push_back(cells(p, dense[i]));
      sums[i] += counts[i].back();
    }
    wanted[i] = std::max(sums[i], static_cast<double>(least[i]));
  }
  FaceGrid grid;
  for (std::size_t i = 0; i < 2; ++i) {
    const double width = length_[1 - i] / wanted[1 - i];
    if (width > 0) wanted[i] = std::max(wanted[i], std::ceil(length_[i] / (kAspect * width)));
    wanted[i] = std::min(wanted[i], double{kMostCells});
    grid.lines[i].push_back(box_.min[static_cast<int>(i)]);
    for (std::size_t k = 0; k < counts[i].size(); ++k) {
      const double count = std::max(1.0, std::ceil(counts[i][k] * wanted[i] / sums[i] - 1e-9));
      for (const double x : places(pieces_[i][k], dense[i], static_cast<int>(count))) {
        grid.lines[i].push_back(x);
      }
    }
  }
  return grid;
}

}  // namespace burin::detail
