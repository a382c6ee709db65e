#include "program.h"

#include <algorithm>

namespace burin {
namespace {

using Mask = Program::Mask;

constexpr Mask bit(int c) { return static_cast<Mask>(1 << c); }

// Second derivatives that products of the first ones of `a` and `b` give.
Mask outer(Mask a, Mask b) {
  Mask m = 0;
  for (int h = 0; h < 6; ++h) {
    const Mask i = bit(1 + kFirstAxis[h]), j = bit(1 + kSecondAxis[h]);
    if (((a & i) && (b & j)) || ((a & j) && (b & i))) m |= bit(4 + h);
  }
  return m;
}

Mask result_mask(Op op, Mask a, Mask b) {
  switch (op) {
    case Op::Constant:
    case Op::Round:
      return 1;
    case Op::X:
      return 1 | bit(1);
    case Op::Y:
      return 1 | bit(2);
    case Op::Z:
      return 1 | bit(3);
    case Op::Negate:
    case Op::Abs:
      return a;
    case Op::Add:
    case Op::Subtract:
    case Op::Min:
    case Op::Max:
      return a | b;
    case Op::Multiply:
      return a | b | outer(a, b);
    case Op::Atan2:
      return a | b | outer(a | b, a | b);
    default:
      return a | outer(a, a);
  }
}

}  // namespace

Program::Program(const Tape& tape) {
  const std::vector<Instruction>& code = tape.code();
  const auto n = static_cast<std::uint32_t>(code.size());
  std::vector<std::uint32_t> last_use(n, 0);
  for (std::uint32_t k = 0; k < n; ++k) {
    if (!is_leaf(code[k].op)) last_use[code[k].a] = k;
    if (is_binary(code[k].op)) last_use[code[k].b] = k;
  }
  last_use[n - 1] = n;
  std::vector<std::uint32_t> place(n), free;
  std::vector<Mask> masks(n);
  for (std::uint32_t k = 0; k < n; ++k) {
    const Instruction& i = code[k];
    Step step{.op = i.op, .value = i.value};
    // An operand's register is given back only after this step has its own: no step writes over
    // what it reads.
    if (free.empty()) free.push_back(registers_++);
    std::ranges::sort(free, std::greater<>());
    step.to = place[k] = free.back();
    free.pop_back();
    if (!is_leaf(i.op)) {
      step.a = place[i.a];
      step.mask_a = masks[i.a];
      if (last_use[i.a] == k) free.push_back(place[i.a]);
    }
    if (is_binary(i.op)) {
      step.b = place[i.b];
      step.mask_b = masks[i.b];
      if (last_use[i.b] == k && i.b != i.a) free.push_back(place[i.b]);
    }
    step.mask = masks[k] = result_mask(i.op, step.mask_a, step.mask_b);
    steps_.push_back(step);
    if (last_use[k] == 0 && k + 1 < n) free.push_back(place[k]);  // used by none
  }
  result_ = place[n - 1];
  result_mask_ = masks[n - 1];
}

}  // namespace burin
