#include "sheet.h"

#include "facets.h"
#include "profiles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::recognised {
namespace {

// Of a span: how far beyond the ends the surface is still asked for.
constexpr double kBeyond = 0.5;
constexpr int kSheetSteps = 12;
// Of the size: after a shorter step what is left is its square.
constexpr double kStill = 1e-8;
// How often a step is halved.
constexpr int kHalves = 8;
// Square of the cosine between both directions of a cell.
constexpr double kSlanted = 0.25;

double square_distance(const Box3& box, Vec3 p) {
  const Vec3 off = glm::max(glm::max(box.min - p, p - box.max), Vec3(0));
  return glm::dot(off, off);
}

}  // namespace

SplineAxis::SplineAxis(std::vector<double> knots, std::int32_t nodes, bool closes)
    : knots_(std::move(knots)), nodes_(nodes), closes_(closes) {
  for (std::int32_t i = 0; i < nodes_; ++i) tangents_.push_back(tangent_at(i));
}

double SplineAxis::length(std::int32_t span) const {
  if (closes_) span = (span + nodes_) % nodes_;
  return knots_[at(span) + 1] - knots_[at(span)];
}

/// Of the parabola through three nodes; of the line that a long span is.
SplineAxis::Tangent SplineAxis::inner_tangent(std::int32_t node) const {
  const double before = length(node - 1), after = length(node);
  double a = after / (before + after);
  if (before > kLong * after) a = 1;
  if (after > kLong * before) a = 0;
  return {node - 1, {-a / before, a / before - (1 - a) / after, (1 - a) / after}};
}

/// At an end the profile bends on as it did.
SplineAxis::Tangent SplineAxis::tangent_at(std::int32_t node) const {
  const bool first = node == 0, last = node + 1 == nodes_;
  if (closes_ || (!first && !last)) return inner_tangent(node);
  const double h = length(first ? 0 : node - 1);
  if (nodes_ == 2) return {0, {-1 / h, 1 / h, 0}};
  Tangent t = inner_tangent(first ? 1 : node - 1);
  for (double& w : t.weight) w = -w;
  t.weight[first ? 0 : 1] -= 2 / h;
  t.weight[first ? 1 : 2] += 2 / h;
  return t;
}

std::int32_t SplineAxis::span_at(double t) const {
  if (closes_) t -= period() * std::floor((t - knots_.front()) / period());
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), t);
  return std::clamp(static_cast<std::int32_t>(after - knots_.begin()) - 1, 0, spans() - 1);
}

double SplineAxis::kept(double t, std::int32_t first, std::int32_t count) const {
  if (closes_ && count == spans()) return t;
  const std::int32_t end = first + count;
  const double low = first == 0 ? kBeyond * length(0) : 0;
  const double high = end == spans() ? kBeyond * length(end - 1) : 0;
  return std::clamp(t, knot(first) - low, knot(end) + high);
}

NodeWeights SplineAxis::weights(std::int32_t span, double t) const {
  if (closes_) t -= period() * std::round((t - 0.5 * (knot(span) + knot(span + 1))) / period());
  const double h = length(span), s = (t - knot(span)) / h;
  NodeWeights out;
  for (std::int32_t k = 0; k < 4; ++k) {
    const std::int32_t node = span - 1 + k;
    out.node[at(k)] = closes_ ? (node + nodes_) % nodes_ : std::clamp(node, 0, nodes_ - 1);
  }
  const auto add = [&](std::int32_t node, double value, double first, double second) {
    const auto k = at(node - span + 1);
    out.value[k] += value;
    out.first[k] += first;
    out.second[k] += second;
  };
  add(span, (1 + 2 * s) * (1 - s) * (1 - s), 6 * s * (s - 1) / h, (12 * s - 6) / (h * h));
  add(span + 1, s * s * (3 - 2 * s), 6 * s * (1 - s) / h, (6 - 12 * s) / (h * h));
  const double value[2] = {h * s * (1 - s) * (1 - s), h * s * s * (s - 1)};
  const double first[2] = {(1 - s) * (1 - 3 * s), s * (3 * s - 2)};
  const double second[2] = {(6 * s - 4) / h, (6 * s - 2) / h};
  for (std::int32_t end = 0; end < 2; ++end) {
    const std::int32_t node = closes_ ? (span + end) % nodes_ : span + end;
    const Tangent& tangent = tangents_[at(node)];
    const std::int32_t shift = span + end - node;  // where the nodes begin anew
    for (std::int32_t k = 0; k < 3; ++k) {
      const double w = tangent.weight[at(k)];
      if (w != 0) {
        add(tangent.first + k + shift, w * value[end], w * first[end], w * second[end]);
      }
    }
  }
  return out;
}

Sheet::Sheet(PointGrid grid)
    : grid_(std::move(grid)),
      u_(grid_.column_knots, grid_.columns, grid_.columns_close),
      v_(grid_.row_knots, grid_.rows, grid_.rows_close) {
  Box3 box;
  for (const Vec3& p : grid_.points) box.add(p);
  size_ = box.diagonal();
  measure();
  build({{}, {0, grid_.cell_rows(), 0, grid_.cell_columns()}});
}

SurfaceDerivatives Sheet::at(std::int32_t column, std::int32_t row, Vec2 uv) const {
  const NodeWeights a = u_.weights(column, uv.x), b = v_.weights(row, uv.y);
  SurfaceDerivatives d;
  for (std::size_t j = 0; j < 4; ++j) {
    if (b.value[j] == 0 && b.first[j] == 0 && b.second[j] == 0) continue;
    Vec3 value(0), first(0), second(0);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 p = grid_.point(b.node[j], a.node[i]);
      value += a.value[i] * p;
      first += a.first[i] * p;
      second += a.second[i] * p;
    }
    d.p += b.value[j] * value;
    d.u += b.value[j] * first;
    d.uu += b.value[j] * second;
    d.v += b.first[j] * value;
    d.uv += b.first[j] * first;
    d.vv += b.second[j] * value;
  }
  return d;
}

SurfaceDerivatives Sheet::derivatives(Vec2 uv) const {
  const std::int32_t column = u_.span_at(uv.x), row = v_.span_at(uv.y);
  uv = {u_.kept(uv.x, 0, u_.spans()), v_.kept(uv.y, 0, v_.spans())};
  return at(column, row, uv);
}

void Sheet::measure() {
  const auto normal = [&](std::int32_t j, std::int32_t i) {
    return glm::cross(grid_.point(j + 1, i + 1) - grid_.point(j, i),
                      grid_.point(j + 1, i) - grid_.point(j, i + 1));
  };
  const bool wrap_u = grid_.columns_close, wrap_v = grid_.rows_close;
  for (std::int32_t j = 0; j < grid_.cell_rows(); ++j) {
    for (std::int32_t i = 0; i < grid_.cell_columns(); ++i) {
      const Vec3 a = grid_.point(j, i), b = grid_.point(j, i + 1), c = grid_.point(j + 1, i + 1),
                 d = grid_.point(j + 1, i), n = normal(j, i);
      const double u = 0.5 * (u_.knot(i) + u_.knot(i + 1)), v = 0.5 * (v_.knot(j) + v_.knot(j + 1));
      const auto off = [&](Vec2 uv, Vec3 facet) {
        sagitta_ = std::max(sagitta_, glm::distance(at(i, j, uv).p, facet));
      };
      const bool over_ac = glm::distance(a, c) <= glm::distance(b, d);
      off({u, v}, over_ac ? 0.5 * (a + c) : 0.5 * (b + d));
      off({u, v_.knot(j)}, 0.5 * (a + b));
      off({u_.knot(i), v}, 0.5 * (a + d));
      turn_ = std::max(turn_,
                       over_ac ? angle_between(glm::cross(b - a, c - a), glm::cross(c - a, d - a))
                               : angle_between(glm::cross(b - a, d - a), glm::cross(c - b, d - b)));
      if (wrap_u || i + 1 < grid_.cell_columns()) {
        turn_ = std::max(turn_, angle_between(n, normal(j, (i + 1) % grid_.columns)));
      }
      if (wrap_v || j + 1 < grid_.cell_rows()) {
        turn_ = std::max(turn_, angle_between(n, normal((j + 1) % grid_.rows, i)));
      }
    }
  }
}

bool Sheet::goes_through(const PointGrid& grid) const {
  return grid.rows_close == grid_.rows_close && grid.columns_close == grid_.columns_close &&
         grid.columns == grid_.columns && grid.points == grid_.points;
}

std::int32_t Sheet::build(Block block) {
  const auto id = static_cast<std::int32_t>(blocks_.size());
  blocks_.push_back(block);
  const GridWindow& c = block.cells;
  if (c.rows == 1 && c.columns == 1) {
    for (const auto& [j, i] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
      block.box.add(grid_.point(c.row + j, c.column + i));
    }
  } else {
    Block low = block, high = block;
    if (c.rows > c.columns) {
      low.cells.rows = c.rows / 2;
      high.cells.row += low.cells.rows;
      high.cells.rows -= low.cells.rows;
    } else {
      low.cells.columns = c.columns / 2;
      high.cells.column += low.cells.columns;
      high.cells.columns -= low.cells.columns;
    }
    block.low = build(low);
    block.high = build(high);
    block.box = blocks_[recognised::at(block.low)].box;
    block.box.add(blocks_[recognised::at(block.high)].box);
  }
  blocks_[recognised::at(id)] = block;
  return id;
}

/// The nearest point of the facet over a cell, near enough to begin with. Cells of twisted walls
/// may be so slanted that what lies beside one in both directions is nearest to another.
Sheet::Found Sheet::on_cell(std::int32_t row, std::int32_t column, Vec3 p) const {
  const Vec3 a = grid_.point(row, column), b = grid_.point(row, column + 1),
             c = grid_.point(row + 1, column + 1), d = grid_.point(row + 1, column);
  const Vec3 u = 0.5 * (b + c - a - d), v = 0.5 * (c + d - a - b), off = p - 0.25 * (a + b + c + d);
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
  const double det = uu * vv - uv * uv, x = glm::dot(u, off), y = glm::dot(v, off);
  Found found{1e300, row, column, {}};
  const auto look_at = [&](Vec2 share) {
    const Vec3 q = glm::mix(glm::mix(a, b, share.x), glm::mix(d, c, share.x), share.y);
    const double square = glm::dot(p - q, p - q);
    if (square < found.square) found.square = square, found.share = share;
  };
  Vec2 share(0.5);
  if (det > 0) share += Vec2(vv * x - uv * y, uu * y - uv * x) / det;
  const Vec2 inside = glm::clamp(share, 0.0, 1.0);
  look_at(inside);
  if (inside == share || !(uv * uv > kSlanted * uu * vv)) return found;
  for (const double end : {0.0, 1.0}) {
    look_at({end, std::clamp(0.5 + (y - (end - 0.5) * uv) / vv, 0.0, 1.0)});
    look_at({std::clamp(0.5 + (x - (end - 0.5) * uv) / uu, 0.0, 1.0), end});
  }
  return found;
}

Vec2 Sheet::foot(Vec3 p, Vec2 uv, const GridWindow& window) const {
  const bool all = window.rows == 0;
  const auto kept = [&](Vec2 next) {
    return Vec2(u_.kept(next.x, all ? 0 : window.column, all ? u_.spans() : window.columns),
                v_.kept(next.y, all ? 0 : window.row, all ? v_.spans() : window.rows));
  };
  const double still = kStill * size_;
  SurfaceDerivatives d = derivatives(uv);
  for (int step = 0; step < kSheetSteps; ++step) {
    const Vec3 off = p - d.p;
    const double uu = glm::dot(d.u, d.u), vv = glm::dot(d.v, d.v);
    double a = uu - glm::dot(d.uu, off), b = glm::dot(d.u, d.v) - glm::dot(d.uv, off),
           c = vv - glm::dot(d.vv, off);
    // Far off, where the middle of curvature is near, the first order alone leads down.
    if (!(a > 0 && a * c - b * b > 1e-3 * uu * vv)) a = uu, b = glm::dot(d.u, d.v), c = vv;
    const double det = a * c - b * b;
    if (!(det > 1e-24 * uu * vv)) break;
    const double x = glm::dot(d.u, off), y = glm::dot(d.v, off);
    Vec2 move = kept(uv + Vec2(c * x - b * y, a * y - b * x) / det) - uv;
    const double length = std::abs(move.x) * std::sqrt(uu) + std::abs(move.y) * std::sqrt(vv);
    if (length <= still) return uv + move;
    // A step that leads away was too long.
    const double most = glm::dot(off, off) + still * still;
    for (int half = 0;; ++half, move *= 0.5) {
      d = derivatives(uv + move);
      if (half == kHalves || glm::dot(p - d.p, p - d.p) <= most) break;
    }
    uv += move;
  }
  return uv;
}

void Sheet::search(std::int32_t block, double square, Vec3 p, const GridWindow& window,
                   Found& found) const {
  const Block& b = blocks_[recognised::at(block)];
  if (square >= found.square || !window.overlaps(b.cells)) return;
  if (b.low < 0) {
    const Found here = on_cell(b.cells.row, b.cells.column, p);
    if (here.square < found.square) found = here;
    return;
  }
  const double low = square_distance(blocks_[recognised::at(b.low)].box, p),
               high = square_distance(blocks_[recognised::at(b.high)].box, p);
  const bool low_first = low <= high;
  search(low_first ? b.low : b.high, low_first ? low : high, p, window, found);
  search(low_first ? b.high : b.low, low_first ? high : low, p, window, found);
}

Vec2 Sheet::locate(Vec3 p, const GridWindow& window) const {
  Found found;
  search(0, 0, p, window, found);
  const Vec2 uv(glm::mix(u_.knot(found.column), u_.knot(found.column + 1), found.share.x),
                glm::mix(v_.knot(found.row), v_.knot(found.row + 1), found.share.y));
  return foot(p, uv, window);
}

}  // namespace burin::recognised
