#pragma once
// What an expression is made of.

#include <burin/forms/implicit/expression.h>

#include <cstdint>
#include <optional>

namespace burin {

enum class Op : std::uint8_t {
  Constant,
  X,
  Y,
  Z,  // no operand
  Negate,
  Abs,
  Square,
  Sqrt,
  Reciprocal,
  Exp,
  Log,
  Sin,
  Cos,
  Tan,  // one operand
  Asin,
  Acos,
  Atan,
  Round,
  Power,  // (Power: ^ value)
  Add,
  Subtract,
  Multiply,
  Min,
  Max,
  Atan2  // two operands
};

constexpr bool is_leaf(Op op) { return op <= Op::Z; }
constexpr bool is_binary(Op op) { return op >= Op::Add; }
constexpr bool is_choice(Op op) { return op == Op::Min || op == Op::Max || op == Op::Abs; }

struct Expression::Node {
  Op op = Op::Constant;
  double value = 0;
  std::shared_ptr<const Node> a, b;
  int depth = 0;
  // Of solids, which know them.
  std::optional<Box3> bounds;
};

// The node `op(a, b)`, its value computed where all operands are constants.
Expression make_node(Op op, const Expression& a);
Expression make_node(Op op, const Expression& a, const Expression& b);
Expression make_power(const Expression& a, double exponent);
// The same formula as a solid whose bounds are known.
Expression with_bounds(const Expression& e, const Box3& bounds);

// One operation on numbers, as the tape does it.
double apply(Op op, double a, double b, double value);
Interval apply(Op op, Interval a, Interval b, double value);

}  // namespace burin
