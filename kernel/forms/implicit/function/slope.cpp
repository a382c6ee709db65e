// Ranges of directional derivatives over boxes: forward differentiation with intervals.

#include "tape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace burin {
namespace {

constexpr Interval kZero{0, 0};

Interval times(Interval a, Interval b) { return apply(Op::Multiply, a, b, 0); }
Interval times(double a, Interval b) { return times(Interval{a, a}, b); }
Interval sum_of(Interval a, Interval b) { return apply(Op::Add, a, b, 0); }
Interval negative(Interval a) { return {-a.max, -a.min}; }
Interval over(Interval a, Interval b) { return times(a, apply(Op::Reciprocal, b, {}, 0)); }
Interval hull_of_both(Interval a, Interval b) {
  return {std::min(a.min, b.min), std::max(a.max, b.max)};
}
Interval square(Interval a) { return apply(Op::Square, a, {}, 0); }

// u / r for a component u of a vector of length r.
Interval share(Interval u, Interval r) {
  const auto quotient = [](double a, double b) { return b > 0 ? std::min(a / b, 1.0) : 1.0; };
  const double high = u.max >= 0 ? quotient(u.max, r.min) : u.max / r.max;
  const double low = u.min >= 0 ? u.min / r.max : -quotient(-u.min, r.min);
  return std::isnan(low) || std::isnan(high) ? Interval{-1, 1} : Interval{low, high};
}

// The chain rule over one box, instruction by instruction.
class SlopeRun {
 public:
  SlopeRun(const std::vector<Instruction>& code, const Box3& box, Vec3 direction)
      : code_(code), box_(box), direction_(direction), value_(memory()[0]), slope_(memory()[1]) {
    value_.resize(code.size());
    slope_.resize(code.size());
  }

  Interval run() {
    for (std::size_t k = 0; k < code_.size(); ++k) {
      const Instruction& i = code_[k];
      if (is_leaf(i.op)) {
        leaf(k);
        continue;
      }
      // A number times itself is its square, which intervals cannot know.
      value_[k] = i.op == Op::Multiply && i.a == i.b
                      ? square(value_[i.a])
                      : apply(i.op, value_[i.a], value_[i.b], i.value);
      if (!defined(i)) return {};
      slope_[k] = is_binary(i.op) ? of_two(i) : of_one(k, i);
    }
    return slope_.back();
  }

 private:
  void leaf(std::size_t k) {
    const Instruction& i = code_[k];
    const int axis = static_cast<int>(i.op) - static_cast<int>(Op::X);
    value_[k] = axis < 0 ? Interval{i.value, i.value} : Interval{box_.min[axis], box_.max[axis]};
    slope_[k] = axis < 0 ? kZero : Interval{direction_[axis], direction_[axis]};
  }

  // Where a function may be no number, its surface may end without any place of level slope.
  bool defined(const Instruction& i) const {
    const Interval a = value_[i.a];
    switch (i.op) {
      case Op::Sqrt:
        return a.min >= 0;
      case Op::Log:
        return a.min > 0;
      case Op::Asin:
      case Op::Acos:
        return a.min >= -1 && a.max <= 1;
      case Op::Reciprocal:
        return a.min > 0 || a.max < 0;
      case Op::Power:
        return a.min >= 0 && (i.value >= 0 || a.min > 0);
      default:
        return true;
    }
  }

  Interval of_one(std::size_t k, const Instruction& i) const {
    const Interval a = value_[i.a], d = slope_[i.a];
    switch (i.op) {
      case Op::Negate:
        return negative(d);
      case Op::Abs:
        return a.min >= 0 ? d : a.max <= 0 ? negative(d) : hull_of_both(d, negative(d));
      case Op::Square:
        return times(times(2, a), d);
      case Op::Sqrt:
        return of_root(k, i);
      case Op::Reciprocal:
        return negative(over(d, square(a)));
      case Op::Exp:
        return times(value_[k], d);
      case Op::Log:
        return over(d, a);
      case Op::Sin:
        return times(apply(Op::Cos, a, {}, 0), d);
      case Op::Cos:
        return negative(times(apply(Op::Sin, a, {}, 0), d));
      case Op::Tan:
        return std::isfinite(value_[k].min) && std::isfinite(value_[k].max)
                   ? times(sum_of({1, 1}, square(value_[k])), d)
                   : Interval{};
      case Op::Asin:
      case Op::Acos: {
        const Interval rest = apply(Op::Subtract, {1, 1}, square(a), 0);
        const Interval g = over(d, apply(Op::Sqrt, rest, {}, 0));
        return i.op == Op::Asin ? g : negative(g);
      }
      case Op::Atan:
        return over(d, sum_of({1, 1}, square(a)));
      case Op::Round:
        return value_[k].min == value_[k].max ? kZero : Interval{};
      case Op::Power:
        return times(times(i.value, apply(Op::Power, a, {}, i.value - 1)), d);
      default:
        return {};
    }
  }

  Interval of_two(const Instruction& i) const {
    const Interval a = value_[i.a], b = value_[i.b], da = slope_[i.a], db = slope_[i.b];
    switch (i.op) {
      case Op::Add:
        return sum_of(da, db);
      case Op::Subtract:
        return apply(Op::Subtract, da, db, 0);
      case Op::Multiply:
        return i.a == i.b ? times(times(2, a), da) : sum_of(times(a, db), times(b, da));
      case Op::Min:
        return a.max < b.min ? da : b.max < a.min ? db : hull_of_both(da, db);
      case Op::Max:
        return a.min > b.max ? da : b.min > a.max ? db : hull_of_both(da, db);
      case Op::Atan2: {
        const bool jumps = b.min <= 0 && a.min <= 0 && a.max >= 0;
        const Interval up = apply(Op::Subtract, times(b, da), times(a, db), 0);
        return jumps ? Interval{} : over(up, sum_of(square(a), square(b)));
      }
      default:
        return {};
    }
  }

  // The root of a sum of squares is the length of a vector: its slope stays bounded at zero, where
  // that of a root does not.
  Interval of_root(std::size_t k, const Instruction& i) const {
    Interval length = kZero;
    if (add_squares(i.a, value_[k], length, 0)) return length;
    return over(slope_[i.a], times(2, value_[k]));
  }
  bool add_squares(std::uint32_t at, Interval r, Interval& total, int depth) const {
    constexpr int kDeepest = 8;
    const Instruction& i = code_[at];
    if (i.op == Op::Add && depth < kDeepest) {
      return add_squares(i.a, r, total, depth + 1) && add_squares(i.b, r, total, depth + 1);
    }
    if (i.op != Op::Square && !(i.op == Op::Multiply && i.a == i.b)) return false;
    total = sum_of(total, times(share(value_[i.a], r), slope_[i.a]));
    return true;
  }

  const std::vector<Instruction>& code_;
  const Box3& box_;
  Vec3 direction_;
  // Kept from one box to the next.
  static std::array<std::vector<Interval>, 2>& memory() {
    thread_local std::array<std::vector<Interval>, 2> m;
    return m;
  }

  std::vector<Interval>&value_, &slope_;
};

}  // namespace

Interval Tape::slope(const Box3& box, Vec3 direction) const {
  return SlopeRun(code_, box, direction).run();
}

}  // namespace burin
