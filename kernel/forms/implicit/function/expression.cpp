#include <burin/base/error.h>

#include "node.h"
#include "tape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace burin {
namespace {

using NodePtr = std::shared_ptr<const Expression::Node>;

Expression leaf(Op op, double value = 0) {
  auto node = std::make_shared<Expression::Node>();
  node->op = op;
  node->value = value;
  return Expression(std::move(node));
}

bool constant(const Expression& e) { return e.node()->op == Op::Constant; }
bool constant(const Expression& e, double v) { return constant(e) && e.node()->value == v; }

Expression finish(Op op, double value, const NodePtr& a, const NodePtr& b) {
  const bool known = a->op == Op::Constant && (!b || b->op == Op::Constant);
  if (known) return leaf(Op::Constant, apply(op, a->value, b ? b->value : 0, value));
  auto node = std::make_shared<Expression::Node>();
  node->op = op;
  node->value = value;
  node->a = a;
  node->b = b;
  node->depth = 1 + std::max(a->depth, b ? b->depth : 0);
  if (node->depth > Expression::kMaxDepth) {
    throw UsageError(fmt::format(
        "the function is nested more than {} operations deep; group long sums by parentheses",
        Expression::kMaxDepth));
  }
  return Expression(std::move(node));
}

// Whole exponents as products: exact signs and tight intervals.
Expression whole_power(const Expression& a, int n) {
  if (n == 1) return a;
  if (n % 2 == 0) return implicit::square(whole_power(a, n / 2));
  return whole_power(a, n - 1) * a;
}

}  // namespace

Expression make_node(Op op, const Expression& a) { return finish(op, 0, a.node(), nullptr); }
Expression make_node(Op op, const Expression& a, const Expression& b) {
  return finish(op, 0, a.node(), b.node());
}
Expression make_power(const Expression& a, double exponent) {
  constexpr double kMostFactors = 64;
  if (exponent == 0) return 1.0;
  if (exponent == std::round(exponent) && std::abs(exponent) <= kMostFactors) {
    const Expression p = whole_power(a, static_cast<int>(std::abs(exponent)));
    return exponent > 0 ? p : make_node(Op::Reciprocal, p);
  }
  if (exponent == 0.5) return implicit::sqrt(a);
  return finish(Op::Power, exponent, a.node(), nullptr);
}

Expression with_bounds(const Expression& e, const Box3& bounds) {
  auto node = std::make_shared<Expression::Node>(*e.node());
  node->bounds = bounds;
  return Expression(std::move(node));
}

Expression::Expression(double constant) : node_(leaf(Op::Constant, constant).node_) {}
Expression Expression::x() {
  static const Expression e = leaf(Op::X);
  return e;
}
Expression Expression::y() {
  static const Expression e = leaf(Op::Y);
  return e;
}
Expression Expression::z() {
  static const Expression e = leaf(Op::Z);
  return e;
}

int Expression::depth() const { return node_->depth; }

Box3 Expression::bounds() const {
  return node_->bounds ? *node_->bounds : interval_bounds(Tape(*this));
}

Expression operator+(const Expression& a, const Expression& b) {
  if (constant(a, 0)) return b;
  if (constant(b, 0)) return a;
  return make_node(Op::Add, a, b);
}
Expression operator-(const Expression& a, const Expression& b) {
  if (constant(b, 0)) return a;
  if (constant(a, 0)) return -b;
  return make_node(Op::Subtract, a, b);
}
Expression operator*(const Expression& a, const Expression& b) {
  if (constant(a, 1)) return b;
  if (constant(b, 1)) return a;
  if (a.node() == b.node()) return implicit::square(a);
  return make_node(Op::Multiply, a, b);
}
Expression operator/(const Expression& a, const Expression& b) {
  if (constant(b)) return a * Expression(1 / b.node()->value);
  return a * make_node(Op::Reciprocal, b);
}
Expression operator-(const Expression& a) {
  if (a.node()->op == Op::Negate) return Expression(a.node()->a);
  return make_node(Op::Negate, a);
}

namespace implicit {

Expression sqrt(const Expression& a) { return make_node(Op::Sqrt, a); }
Expression exp(const Expression& a) { return make_node(Op::Exp, a); }
Expression log(const Expression& a) { return make_node(Op::Log, a); }
Expression sin(const Expression& a) { return make_node(Op::Sin, a); }
Expression cos(const Expression& a) { return make_node(Op::Cos, a); }
Expression tan(const Expression& a) { return make_node(Op::Tan, a); }
Expression asin(const Expression& a) { return make_node(Op::Asin, a); }
Expression acos(const Expression& a) { return make_node(Op::Acos, a); }
Expression atan(const Expression& a) { return make_node(Op::Atan, a); }
Expression atan2(const Expression& y, const Expression& x) { return make_node(Op::Atan2, y, x); }
Expression pow(const Expression& a, const Expression& b) {
  return constant(b) ? make_power(a, b.node()->value) : exp(b * log(a));
}
Expression min(const Expression& a, const Expression& b) { return make_node(Op::Min, a, b); }
Expression max(const Expression& a, const Expression& b) { return make_node(Op::Max, a, b); }
Expression abs(const Expression& a) { return make_node(Op::Abs, a); }
Expression round(const Expression& a) { return make_node(Op::Round, a); }
Expression square(const Expression& a) { return make_node(Op::Square, a); }

Expression substitute(const Expression& f, const Expression& x, const Expression& y,
                      const Expression& z) {
  std::unordered_map<const Expression::Node*, NodePtr> done;
  const auto walk = [&](const auto& self, const NodePtr& n) -> NodePtr {
    if (n->op == Op::Constant) return n;
    if (n->op == Op::X) return x.node();
    if (n->op == Op::Y) return y.node();
    if (n->op == Op::Z) return z.node();
    if (const auto it = done.find(n.get()); it != done.end()) return it->second;
    const NodePtr a = self(self, n->a), b = n->b ? self(self, n->b) : nullptr;
    NodePtr out = finish(n->op, n->value, a, b).node();
    done.emplace(n.get(), out);
    return out;
  };
  return Expression(walk(walk, f.node()));
}

}  // namespace implicit
}  // namespace burin
