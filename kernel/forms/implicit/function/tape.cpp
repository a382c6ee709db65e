#include "tape.h"

#include <burin/base/error.h>

#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace burin {
namespace {

constexpr std::size_t kMaxInstructions = 200'000;

// Equal operations on equal operands become one, and those that change nothing none. Values stay
// the same to the bit: grids compare signs from several shortened tapes.
class Builder {
 public:
  explicit Builder(std::vector<Instruction>& code) : code_(code) {}

  std::uint32_t add(Instruction i) {
    if (const auto known = simplify(i)) return *known;
    const Key key{i.op, i.a, i.b, std::bit_cast<std::uint64_t>(i.value)};
    const auto [it, fresh] = known_.try_emplace(key, static_cast<std::uint32_t>(code_.size()));
    if (fresh) {
      if (code_.size() >= kMaxInstructions) {
        throw UsageError("the function has more than 200,000 operations; make it simpler");
      }
      code_.push_back(i);
      finite_.push_back(stays_finite(i));
    }
    return it->second;
  }

  // Leaves out what `result` does not need.
  void finish(std::uint32_t result) {
    std::vector<std::uint8_t> needed(result + 1, 0);
    needed[result] = 1;
    for (std::uint32_t k = result + 1; k-- > 0;) {
      if (!needed[k] || is_leaf(code_[k].op)) continue;
      needed[code_[k].a] = 1;
      if (is_binary(code_[k].op)) needed[code_[k].b] = 1;
    }
    std::vector<std::uint32_t> name(result + 1, 0);
    std::uint32_t count = 0;
    for (std::uint32_t k = 0; k <= result; ++k) {
      if (!needed[k]) continue;
      Instruction i = code_[k];
      if (!is_leaf(i.op)) i.a = name[i.a];
      if (is_binary(i.op)) i.b = name[i.b];
      name[k] = count;
      code_[count++] = i;
    }
    code_.resize(count);
  }

 private:
  using Key = std::tuple<Op, std::uint32_t, std::uint32_t, std::uint64_t>;

  bool is(std::uint32_t k, Op op) const { return code_[k].op == op; }
  bool is_number(std::uint32_t k, double v) const {
    return is(k, Op::Constant) && code_[k].value == v;
  }

  // Never infinite nor NaN for want of a definition: zero times it is zero.
  bool stays_finite(const Instruction& i) const {
    switch (i.op) {
      case Op::Constant:
        return std::isfinite(i.value);
      case Op::X:
      case Op::Y:
      case Op::Z:
        return true;
      case Op::Negate:
      case Op::Abs:
      case Op::Square:
      case Op::Sin:
      case Op::Cos:
      case Op::Atan:
        return finite_[i.a] != 0;
      case Op::Add:
      case Op::Subtract:
      case Op::Multiply:
      case Op::Min:
      case Op::Max:
        return finite_[i.a] && finite_[i.b];
      default:
        return false;
    }
  }

  // The instruction that has the same values already; else `i` may become a simpler one.
  std::optional<std::uint32_t> simplify(Instruction& i) {
    if (is_leaf(i.op)) return std::nullopt;
    const bool two = is_binary(i.op);
    if (is(i.a, Op::Constant) && (!two || is(i.b, Op::Constant))) {
      const double v = apply(i.op, code_[i.a].value, two ? code_[i.b].value : 0, i.value);
      i = {.op = Op::Constant, .value = v};
      return std::nullopt;
    }
    switch (i.op) {
      case Op::Negate:
        if (is(i.a, Op::Negate)) return code_[i.a].a;
        break;
      case Op::Square:
        if (is(i.a, Op::Negate)) i.a = code_[i.a].a;
        break;
      case Op::Add:
        if (is_number(i.a, 0)) return i.b;
        if (is_number(i.b, 0)) return i.a;
        if (is(i.b, Op::Negate)) {
          i = {.op = Op::Subtract, .a = i.a, .b = code_[i.b].a};
        } else if (is(i.a, Op::Negate)) {
          i = {.op = Op::Subtract, .a = i.b, .b = code_[i.a].a};
        }
        break;
      case Op::Subtract:
        if (is_number(i.b, 0)) return i.a;
        if (is(i.b, Op::Negate)) i = {.op = Op::Add, .a = i.a, .b = code_[i.b].a};
        break;
      case Op::Multiply:
        return product(i);
      default:
        break;
    }
    return std::nullopt;
  }
  std::optional<std::uint32_t> product(Instruction& i) {
    for (const auto& [c, x] : {std::pair(i.a, i.b), std::pair(i.b, i.a)}) {
      if (is_number(c, 1)) return x;
      if (is_number(c, 0) && finite_[x]) return c;
      if (is_number(c, -1)) {
        if (is(x, Op::Negate)) return code_[x].a;
        i = {.op = Op::Negate, .a = x};
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  std::vector<Instruction>& code_;
  std::vector<std::uint8_t> finite_;
  std::map<Key, std::uint32_t> known_;
};

double side_value(const Instruction& i, double a, double b) {
  return i.op == Op::Abs ? (a < 0 ? 1 : 0) : apply(i.op, a, b, 0) == a || std::isnan(a) ? 0 : 1;
}

// What a choice becomes once it is made: kOpen = stays a choice.
enum class Side : std::uint8_t { First, Second, Open };

// The tape with the choices made; operations that are not needed any more are left out. `ranges`,
// where not empty, holds the values that each instruction may have.
std::vector<Instruction> with_choices(const std::vector<Instruction>& code,
                                      const std::vector<Side>& sides,
                                      const std::vector<Interval>& ranges) {
  const auto n = code.size();
  // Backwards: what is needed. A choice made needs its one operand alone.
  std::vector<std::uint8_t> needed(n, 0);
  needed[n - 1] = 1;
  for (std::size_t k = n; k-- > 0;) {
    if (!needed[k] || is_leaf(code[k].op)) continue;
    const Instruction& i = code[k];
    const bool choice = is_choice(i.op) && i.op != Op::Abs && sides[k] != Side::Open;
    if (!choice || sides[k] == Side::First) needed[i.a] = 1;
    if (is_binary(i.op) && (!choice || sides[k] == Side::Second)) needed[i.b] = 1;
  }
  std::vector<Instruction> out;
  Builder builder(out);
  std::vector<std::uint32_t> at(n, 0);
  std::vector<Interval> known;  // of the new instructions
  const auto emit = [&](const Instruction& i, std::size_t k) {
    const std::uint32_t made = builder.add(i);
    known.resize(out.size());
    if (!ranges.empty()) known[made] = ranges[k];
    return made;
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (!needed[k]) continue;
    Instruction i = code[k];
    if (is_choice(i.op) && sides[k] != Side::Open) {
      const std::uint32_t kept = at[sides[k] == Side::Second && i.op != Op::Abs ? i.b : i.a];
      at[k] = i.op == Op::Abs && sides[k] == Side::Second ? emit({.op = Op::Negate, .a = kept}, k)
                                                          : kept;
      continue;
    }
    if (!is_leaf(i.op)) i.a = at[i.a];
    if (is_binary(i.op)) i.b = at[i.b];
    // Rounded, the root of a square is the number without its sign, and here that is known.
    if (i.op == Op::Sqrt && out[i.a].op == Op::Square) {
      const std::uint32_t base = out[i.a].a;
      if (known[base].min >= 0) {
        at[k] = base;
        continue;
      }
      if (known[base].max <= 0) i = {.op = Op::Negate, .a = base};
    }
    at[k] = emit(i, k);
  }
  builder.finish(at[n - 1]);
  return out;
}

double leaf_value(const Instruction& i, Vec3 p) {
  return i.op == Op::X ? p.x : i.op == Op::Y ? p.y : i.op == Op::Z ? p.z : i.value;
}

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

}  // namespace

Tape::Tape(const Expression& expression) {
  Builder builder(code_);
  std::unordered_map<const Expression::Node*, std::uint32_t> done;
  const auto walk = [&](const auto& self, const Expression::Node* n) -> std::uint32_t {
    if (const auto it = done.find(n); it != done.end()) return it->second;
    Instruction i{.op = n->op, .value = n->value};
    if (n->a) i.a = self(self, n->a.get());
    if (n->b) i.b = self(self, n->b.get());
    const std::uint32_t at = builder.add(i);
    done.emplace(n, at);
    return at;
  };
  builder.finish(walk(walk, expression.node().get()));
}

bool Tape::has_choices() const {
  for (const Instruction& i : code_) {
    if (is_choice(i.op)) return true;
  }
  return false;
}

double Tape::value(Vec3 p, std::vector<double>& slots) const {
  slots.resize(code_.size());
  for (std::size_t k = 0; k < code_.size(); ++k) {
    const Instruction& i = code_[k];
    slots[k] = is_leaf(i.op) ? leaf_value(i, p) : apply(i.op, slots[i.a], slots[i.b], i.value);
  }
  return slots.back();
}

Interval Tape::range(const Box3& box) const {
  std::vector<Interval> slots(code_.size());
  for (std::size_t k = 0; k < code_.size(); ++k) {
    const Instruction& i = code_[k];
    if (is_leaf(i.op)) {
      const int axis = static_cast<int>(i.op) - static_cast<int>(Op::X);
      slots[k] = axis < 0 ? Interval{i.value, i.value} : Interval{box.min[axis], box.max[axis]};
    } else {
      slots[k] = apply(i.op, slots[i.a], slots[i.b], i.value);
    }
  }
  return slots.back();
}

std::uint64_t Tape::choices(Vec3 p) const {
  thread_local std::vector<double> slots;
  thread_local std::vector<std::uint64_t> names;
  value(p, slots);
  names.assign(code_.size(), 0);
  for (std::size_t k = 0; k < code_.size(); ++k) {
    const Instruction& i = code_[k];
    if (is_leaf(i.op)) continue;
    if (is_choice(i.op)) {
      const bool second = side_value(i, slots[i.a], slots[i.b]) != 0;
      const std::uint64_t below = names[second && i.op != Op::Abs ? i.b : i.a];
      names[k] = mix(below + 0x9e3779b97f4a7c15ull * (2 * k + second + 1));
    } else if (is_binary(i.op)) {
      // Of smooth parts nothing is to be told apart.
      const std::uint64_t a = names[i.a], b = names[i.b];
      names[k] = a == 0 ? b : b == 0 ? a : mix(a + 3 * mix(b));
    } else {
      names[k] = names[i.a];
    }
  }
  return names.back();
}

Tape Tape::chosen(Vec3 p) const {
  std::vector<double> slots;
  value(p, slots);
  std::vector<Side> sides(code_.size(), Side::Open);
  for (std::size_t k = 0; k < code_.size(); ++k) {
    const Instruction& i = code_[k];
    if (!is_choice(i.op)) continue;
    sides[k] = side_value(i, slots[i.a], slots[i.b]) != 0 ? Side::Second : Side::First;
  }
  Tape tape;
  tape.code_ = with_choices(code_, sides, {});
  return tape;
}

Tape Tape::restricted(const Box3& box) const {
  std::vector<Interval> slots(code_.size());
  std::vector<Side> sides(code_.size(), Side::Open);
  for (std::size_t k = 0; k < code_.size(); ++k) {
    const Instruction& i = code_[k];
    if (is_leaf(i.op)) {
      const int axis = static_cast<int>(i.op) - static_cast<int>(Op::X);
      slots[k] = axis < 0 ? Interval{i.value, i.value} : Interval{box.min[axis], box.max[axis]};
      continue;
    }
    const Interval a = slots[i.a], b = slots[i.b];
    slots[k] = apply(i.op, a, b, i.value);
    if (i.op == Op::Abs && a.min > 0) sides[k] = Side::First;
    if (i.op == Op::Abs && a.max < 0) sides[k] = Side::Second;
    if (i.op == Op::Min && a.max < b.min) sides[k] = Side::First;
    if (i.op == Op::Min && b.max < a.min) sides[k] = Side::Second;
    if (i.op == Op::Max && a.min > b.max) sides[k] = Side::First;
    if (i.op == Op::Max && b.min > a.max) sides[k] = Side::Second;
  }
  Tape tape;
  tape.code_ = with_choices(code_, sides, slots);
  return tape;
}

Box3 interval_bounds(const Tape& tape) {
  constexpr double kFirst = 1e-6, kLast = 1e9;  // model mm: from dust to continents
  Box3 box = ImplicitFunction::everywhere();
  const auto outside = [&](int axis, bool upper, double at) {
    Box3 half = ImplicitFunction::everywhere();
    (upper ? half.min : half.max)[axis] = at;
    return tape.range(half).min > 0;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      // Outwards by doubling until all beyond is outside, then back by halving the gap, over zero
      // where the whole shape lies on the other side.
      const double sign = upper ? 1 : -1;
      double far = kFirst;
      while (far < kLast && !outside(axis, upper, sign * far)) far *= 2;
      if (far >= kLast) continue;
      double near = -far;
      while (near > -kLast && outside(axis, upper, sign * near)) near *= 2;
      for (int i = 0; i < 60 && far - near > 1e-12 * std::abs(far); ++i) {
        const double middle = 0.5 * (near + far);
        (outside(axis, upper, sign * middle) ? far : near) = middle;
      }
      (upper ? box.max : box.min)[axis] = sign * far;
    }
  }
  return box;
}

}  // namespace burin
