#include "field.h"

#include <burin/base/bracketed_zero.h>

#include "../../function/shape_operator.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace burin {
namespace {

constexpr double kCellsAcross = 48;       // along the longest side
constexpr std::size_t kKnown = 1u << 16;  // entries of the cache
// Share of the size that crossings may be off; Newton takes them onto the surface afterwards.
constexpr double kAccuracy = 1e-8;
// Edges along curves over the radius of the triangles' balls: those of an even triangle.
constexpr double kEdge = 1.5;
// Values a vertex: ten times what a smooth surface takes.
constexpr std::size_t kValuesPerVertex = 2000, kLeastBudget = 20'000'000;
constexpr double kCrossingsPerVertex = 12;

}  // namespace

FunctionField::FunctionField(const ImplicitFunction& f, const Box3& box, const Sizing& sizing,
                             std::size_t most_vertices, RunContext& context)
    : f_(f), box_(box), sizing_(sizing), context_(context), known_(kKnown) {
  const Vec3 s = box.size();
  size_ = std::max({s.x, s.y, s.z});
  step_ = size_ / kCellsAcross;
  count_ = glm::ivec3(glm::floor(s / step_)) + 1;
  cells_.resize(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) *
                static_cast<std::size_t>(count_.z));
  budget_ = kLeastBudget + kValuesPerVertex * most_vertices;
}

void FunctionField::count() {
  context_.check();
  if (++evaluations_ > budget_) throw BudgetSpent();
}

const FunctionField::Cell& FunctionField::cell_at(Vec3 p) {
  const glm::ivec3 c =
      glm::clamp(glm::ivec3(glm::floor((p - box_.min) / step_)), glm::ivec3(0), count_ - 1);
  Cell& cell = cells_[static_cast<std::size_t>(c.x) +
                      static_cast<std::size_t>(count_.x) *
                          (static_cast<std::size_t>(c.y) +
                           static_cast<std::size_t>(count_.y) * static_cast<std::size_t>(c.z))];
  if (cell.state != Cell::Unseen) return cell;
  context_.check();
  // A hair larger, for points that rounding puts into the cell beside.
  const Vec3 corner = box_.min + step_ * Vec3(c);
  const Box3 at{corner - 1e-9 * size_, corner + step_ + 1e-9 * size_};
  const Interval range = f_.range(at);
  const double slack = 1e-12 * (std::abs(range.min) + std::abs(range.max));
  cell.state = Cell::Mixed;
  if (range.min > 0 && !(range.min <= slack)) cell.state = Cell::Outside;
  if (range.max < 0 && !(range.max >= -slack)) cell.state = Cell::Inside;
  if (cell.state == Cell::Mixed) cell.own = f_.restricted(at);
  cell.function = cell.own ? cell.own.get() : &f_;
  return cell;
}

double FunctionField::value(const Cell& cell, Vec3 p) {
  count();
  return cell.function->value(p);
}

bool FunctionField::inside(Vec3 p) {
  const Cell& cell = cell_at(p);
  if (cell.state != Cell::Mixed) return cell.state == Cell::Inside;
  std::uint64_t hash = 0;
  for (int a = 0; a < 3; ++a) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(p[a])) * 0x9e3779b97f4a7c15u;
  }
  Known& k = known_[hash >> 48];
  if (!k.known || k.p != p) k = {p, true, value(cell, p) < 0};
  return k.inside;
}

// Moves the end of a segment that lies outside the box to where the segment enters it: centres of
// flat tetrahedra are as far away as numbers reach.
void FunctionField::clip(Vec3 inner, Vec3& end) const {
  double share = 1;
  for (int k = 0; k < 3; ++k) {
    const double d = end[k] - inner[k];
    if (end[k] > box_.max[k]) share = std::min(share, (box_.max[k] - inner[k]) / d);
    if (end[k] < box_.min[k]) share = std::min(share, (box_.min[k] - inner[k]) / d);
  }
  if (share < 1) end = inner + share * (end - inner);
}

Vec3 FunctionField::crossing(Vec3 a, Vec3 b) {
  if (++crossings_ % 256 == 0) {
    const double all = kCrossingsPerVertex * sizing_.expected_vertices();
    context_.progress(std::min(0.95, static_cast<double>(crossings_) / all));
  }
  const bool first = a == glm::clamp(a, box_.min, box_.max) && inside(a);
  if (first) {
    clip(a, b);
  } else {
    clip(b, a);
  }
  const Vec3 d = b - a;
  const double length = glm::length(d), enough = kAccuracy * size_ / length;
  const auto at = [&](double share) { return a + share * d; };
  double low = 0, high = 1;
  const auto halve = [&](const auto& until) {
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings && high - low > enough && !until(); ++i) {
      const double middle = 0.5 * (low + high);
      (inside(at(middle)) == first ? low : high) = middle;
    }
  };
  // To where values count: far off they may be anything.
  halve([&] {
    return cell_at(at(low)).state == Cell::Mixed && cell_at(at(high)).state == Cell::Mixed;
  });
  const double span = high - low;
  bool numbers = true;
  const auto between = [&](double share) {
    const Vec3 p = at(low + share * span);
    const double v = value(cell_at(p), p);
    numbers = numbers && !std::isnan(v);
    return std::isnan(v) ? 0 : first ? -v : v;  // positive at the low end
  };
  const double f_low = between(0), f_high = between(1);
  if (numbers && f_low > 0 && f_high < 0) {
    const double zero = bracketed_zero(between, f_low, f_high, {enough / span, 0});
    if (numbers) return at(low + zero * span);
  }
  halve([] { return false; });
  return at(0.5 * (low + high));
}

double FunctionField::radius(Vec3 p) {
  context_.check();
  double r = sizing_.at(p);
  if (!sizing_.doubtful(p)) return r;
  count();
  const double k = largest_curvature(cell_at(p).function->hessian(p));
  if (k > 0 && std::isfinite(k)) {
    // Never much finer than the coarse mesh tells: tips have no end of curvature.
    constexpr double kFinest = 0.1;
    r = std::max(std::min(r, std::sqrt(2 * sizing_.tolerance() / k)), kFinest * r);
  }
  return r;
}

double FunctionField::edge(Vec3 p) {
  count();
  return kEdge * sizing_.at(p);
}

}  // namespace burin
