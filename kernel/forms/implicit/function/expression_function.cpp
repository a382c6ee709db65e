// A compiled formula as an implicit function.

#include "expression_function.h"

namespace burin {

namespace {

// In additions.
double cost_of(Op op) {
  switch (op) {
    case Op::Sqrt:
    case Op::Reciprocal:
      return 4;
    case Op::Exp:
    case Op::Log:
    case Op::Sin:
    case Op::Cos:
    case Op::Tan:
    case Op::Asin:
    case Op::Acos:
    case Op::Atan:
    case Op::Power:
    case Op::Atan2:
      return 15;
    default:
      return 1;
  }
}

double cost_of(const Tape& tape) {
  double cost = 0;
  for (const Instruction& i : tape.code()) cost += cost_of(i.op);
  return cost;
}

}  // namespace

ExpressionFunction::ExpressionFunction(Tape tape, const Box3& bounds)
    : tape_(std::move(tape)),
      program_(tape_),
      bounds_(bounds),
      has_pieces_(tape_.has_choices()),
      cost_(cost_of(tape_)) {}

void ExpressionFunction::values(std::span<const Vec3> points, std::span<double> out) const {
  program_.values(points, out);
}
void ExpressionFunction::gradients(std::span<const Vec3> points, std::span<Gradient1> out) const {
  program_.gradients(points, out);
}
void ExpressionFunction::hessians(std::span<const Vec3> points, std::span<Gradient2> out) const {
  program_.hessians(points, out);
}
Interval ExpressionFunction::range(const Box3& box) const { return tape_.range(box); }
Interval ExpressionFunction::slope(const Box3& box, Vec3 direction) const {
  return tape_.slope(box, direction);
}

std::uint64_t ExpressionFunction::piece(Vec3 p) const { return has_pieces_ ? tape_.choices(p) : 0; }

const ImplicitFunction& ExpressionFunction::piece_function(Vec3 p) const {
  if (!has_pieces_) return *this;
  const std::uint64_t name = tape_.choices(p);
  const std::lock_guard lock(mutex_);
  std::unique_ptr<const ImplicitFunction>& piece = pieces_[name];
  if (!piece) piece = std::make_unique<ExpressionFunction>(tape_.chosen(p), bounds_);
  return *piece;
}

std::shared_ptr<const ImplicitFunction> ExpressionFunction::restricted(const Box3& box) const {
  if (!has_pieces_) return nullptr;
  Tape shorter = tape_.restricted(box);
  if (shorter.code().size() == tape_.code().size()) return nullptr;
  return std::make_shared<ExpressionFunction>(std::move(shorter), bounds_);
}

std::shared_ptr<const ImplicitFunction> make_function(const Expression& expression) {
  return std::make_shared<ExpressionFunction>(Tape(expression), expression.bounds());
}

}  // namespace burin
