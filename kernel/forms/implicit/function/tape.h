#pragma once
// A formula as a list of operations, each written once, operands before their use.

#include <burin/forms/implicit/implicit_function.h>

#include "node.h"

#include <cstdint>
#include <vector>

namespace burin {

struct Instruction {
  Op op = Op::Constant;
  std::uint32_t a = 0, b = 0;  // earlier instructions
  double value = 0;

  friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// The last instruction is the result.
class Tape {
 public:
  Tape() = default;
  explicit Tape(const Expression& expression);

  const std::vector<Instruction>& code() const { return code_; }
  double value(Vec3 p, std::vector<double>& slots) const;
  Interval range(const Box3& box) const;
  // All values of the derivative along `direction` over the box.
  Interval slope(const Box3& box, Vec3 direction) const;

  // Which operand each min and max takes and which sign each abs has at a point, as one number;
  // equal numbers mean the same choices among those that matter.
  std::uint64_t choices(Vec3 p) const;
  // The tape with these choices made for good: smooth, and shorter.
  Tape chosen(Vec3 p) const;
  // The tape without the choices that are the same all over the box.
  Tape restricted(const Box3& box) const;
  bool has_choices() const;

 private:
  std::vector<Instruction> code_;
};

// The box that interval arithmetic over half spaces leaves; infinite where it finds no end.
Box3 interval_bounds(const Tape& tape);

}  // namespace burin
