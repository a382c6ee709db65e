#include <burin/base/parallel.h>
#include <burin/forms/charted/coverage.h>

#include "bezier_field.h"
#include "nurbs_spans.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

using Scalars = BezierField<double>;
using Vectors = BezierField<Vec3>;

constexpr auto kTimes = [](const auto& a, const auto& b) { return a * b; };
constexpr auto kCross = [](Vec3 a, Vec3 b) { return glm::cross(a, b); };
constexpr auto kDot = [](Vec3 a, Vec3 b) { return glm::dot(a, b); };

/// R^2 = numerator / weight^6 over one span or a part of it, by the span's own unit square.
struct SquaredArea {
  Scalars numerator;
  Scalars weight;  // empty where polynomial

  double upper() const {
    const double top = *std::max_element(numerator.c.begin(), numerator.c.end());
    if (weight.c.empty()) return std::max(0.0, top);
    const double w = *std::min_element(weight.c.begin(), weight.c.end());
    return std::max(0.0, top) / std::pow(w, 6);
  }
  /// The largest value in a corner, where coefficients are values.
  double attained() const {
    double best = 0;
    for (const bool i : {false, true}) {
      for (const bool j : {false, true}) {
        const auto corner = [&](const Scalars& f) {
          return f.at(i ? f.degree_u : 0, j ? f.degree_v : 0);
        };
        best = std::max(best,
                        corner(numerator) / (weight.c.empty() ? 1 : std::pow(corner(weight), 6)));
      }
    }
    return best;
  }
};

struct Cross {
  Vectors n;  // Su x Sv = n / weight^3
  Scalars weight;
};

/// Su x Sv of a span, symbolically. Rational: with S = A / w,
/// w^3 (Su x Sv) = w (Au x Av) + wv (A x Au) - wu (A x Av).
Cross cross_field(const NurbsSpans& spans, std::size_t index) {
  const auto du = static_cast<std::size_t>(spans.degree_u);
  const auto dv = static_cast<std::size_t>(spans.degree_v);
  const std::span<const Vec4> points = spans.patch(index);
  Vectors a(du, dv);
  Scalars w(du, dv);
  double largest = 0;
  for (const Vec4& p : points) largest = std::max(largest, p.w);
  // From a point of the patch: products of far coordinates would cancel.
  const Vec3 center = Vec3(points[0]) / points[0].w;
  for (std::size_t k = 0; k < points.size(); ++k) {
    w.c[k] = points[k].w / largest;
    a.c[k] = Vec3(points[k]) / largest - w.c[k] * center;
  }
  const Vectors au = derivative_u(a), av = derivative_v(a);
  Cross r{product(au, av, kCross), {}};
  if (!spans.rational) return r;
  r.n = product(w, r.n, kTimes);
  const Vectors f = product(derivative_v(w), product(a, au, kCross), kTimes);
  const Vectors g = product(derivative_u(w), product(a, av, kCross), kTimes);
  for (std::size_t k = 0; k < r.n.c.size(); ++k) r.n.c[k] += f.c[k] - g.c[k];
  r.weight = std::move(w);
  return r;
}

SquaredArea squared_area(const NurbsSpans& spans, std::size_t index) {
  Cross cross = cross_field(spans, index);
  return {product(cross.n, cross.n, kDot), std::move(cross.weight)};
}

/// A bound that costs less than the square: the longest coefficient of Su x Sv itself.
double cheap_upper(const NurbsSpans& spans, std::size_t index) {
  const Cross cross = cross_field(spans, index);
  double top = 0;
  for (const Vec3& n : cross.n.c) top = std::max(top, glm::dot(n, n));
  if (cross.weight.c.empty()) return top;
  return top / std::pow(*std::min_element(cross.weight.c.begin(), cross.weight.c.end()), 6);
}

/// Best-first subdivision: what has the largest bound is squared or split until the bound is met.
class BoundSearch {
 public:
  BoundSearch(const NurbsSpans& spans, const RunContext& context)
      : spans_(spans), context_(context), queue_(spans.u.size() * spans.v.size()) {
    constexpr std::size_t kGrain = 64;
    parallel_for(
        queue_.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t s = begin; s < end; ++s) {
            queue_[s] = {cheap_upper(spans, s) * unit(s), s, {}};
          }
        },
        &context);
    std::make_heap(queue_.begin(), queue_.end());
  }

  AreaBound run(double tolerance) {
    // Splits halve nothing where R is constant, and a place of large R costs a few dozen: this many
    // are met only by tolerances near rounding.
    constexpr std::size_t kMaxSplits = 20'000;
    const double enough = (1 + tolerance) * (1 + tolerance);
    while (bound_.subdivisions < kMaxSplits) {
      context_.check();
      std::pop_heap(queue_.begin(), queue_.end());
      Item item = std::move(queue_.back());
      queue_.pop_back();
      if (item.field.numerator.c.empty()) {
        push(squared_area(spans_, item.span), item.span, item.upper);
        continue;
      }
      if (item.upper <= enough * attained_) {
        push_item(std::move(item));
        break;
      }
      split(std::move(item));
    }
    // A billionth for the rounding of all the products.
    bound_.value = std::sqrt(queue_.front().upper) * (1 + 1e-9);
    bound_.attained = std::sqrt(attained_);
    bound_.proved = true;
    return bound_;
  }

 private:
  struct Item {
    double upper = 0;
    std::size_t span = 0;
    SquaredArea field;
    bool operator<(const Item& o) const { return upper < o.upper; }
  };

  /// From the unit square of a span to its parameters, squared.
  double unit(std::size_t span) const {
    const double a =
        spans_.u.width(span / spans_.v.size()) * spans_.v.width(span % spans_.v.size());
    return 1 / (a * a);
  }
  void push_item(Item item) {
    queue_.push_back(std::move(item));
    std::push_heap(queue_.begin(), queue_.end());
  }
  void push(SquaredArea field, std::size_t span, double parent) {
    attained_ = std::max(attained_, field.attained() * unit(span));
    const double upper = std::min(parent, field.upper() * unit(span));
    push_item({upper, span, std::move(field)});
  }
  void split(Item item) {
    ++bound_.subdivisions;
    SquaredArea& f = item.field;
    SquaredArea high{split_u(f.numerator), {}};
    if (!f.weight.c.empty()) high.weight = split_u(f.weight);
    for (SquaredArea* half : {&f, &high}) {
      SquaredArea quarter{split_v(half->numerator), {}};
      if (!half->weight.c.empty()) quarter.weight = split_v(half->weight);
      push(std::move(*half), item.span, item.upper);
      push(std::move(quarter), item.span, item.upper);
    }
  }

  const NurbsSpans& spans_;
  const RunContext& context_;
  std::vector<Item> queue_;
  double attained_ = 0;
  AreaBound bound_;
};

double area_at(const Chart& chart, Vec2 uv) {
  const SurfaceDerivatives d = chart.derivatives(uv);
  return glm::length(glm::cross(d.u, d.v));
}

/// Samples, the best of which climb by ever smaller steps.
AreaBound sampled_bound(const Chart& chart, const RunContext& context) {
  constexpr std::size_t kSide = 64;
  const ParameterBox box = chart.domain();
  const Vec2 cell = box.size() / static_cast<double>(kSide);
  std::array<double, kSide + 1> best{};
  parallel_for(
      kSide + 1, 4,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          Vec2 at = box.min;
          for (std::size_t j = 0; j <= kSide; ++j) {
            const Vec2 uv = box.min + cell * Vec2(static_cast<double>(i), static_cast<double>(j));
            const double r = area_at(chart, uv);
            if (r > best[i]) best[i] = r, at = uv;
          }
          for (Vec2 step = 0.5 * cell; step.x > 1e-3 * cell.x; step *= 0.5) {
            for (const Vec2 sign : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
              const Vec2 uv = glm::clamp(at + sign * step, box.min, box.max);
              const double r = area_at(chart, uv);
              if (r > best[i]) best[i] = r, at = uv;
            }
          }
        }
      },
      &context);
  AreaBound bound;
  bound.attained = *std::max_element(best.begin(), best.end());
  bound.value = 1.05 * bound.attained;
  return bound;
}

}  // namespace

std::optional<AreaBound> proved_area_bound(const Chart& chart, const RunContext& context,
                                           double tolerance) {
  if (const NurbsData* data = nurbs_data(chart)) {
    const NurbsSpans spans(*data);
    return BoundSearch(spans, context).run(tolerance);
  }
  const double largest = chart.largest_area();
  if (!(largest > 0)) return std::nullopt;
  // A billionth for rounding.
  return AreaBound{.value = largest * (1 + 1e-9), .proved = true, .attained = largest};
}

AreaBound area_bound(const Chart& chart, const RunContext& context, double tolerance) {
  const auto proved = proved_area_bound(chart, context, tolerance);
  return proved ? *proved : sampled_bound(chart, context);
}

}  // namespace burin
