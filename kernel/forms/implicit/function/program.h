#pragma once
// A tape made ready to run over blocks of points: a small set of registers, and for each operation
// which derivatives are not zero for certain.

#include "tape.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Axes of the second derivatives 4 .. 9.
constexpr int kFirstAxis[6] = {0, 1, 2, 0, 0, 1}, kSecondAxis[6] = {0, 1, 2, 1, 2, 2};

class Program {
 public:
  explicit Program(const Tape& tape);

  void values(std::span<const Vec3> points, std::span<double> out) const;
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const;
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const;

  // Components of a derivative: 0 value, 1-3 gradient, 4-9 xx yy zz xy xz yz.
  using Mask = std::uint16_t;
  struct Step {
    Op op = Op::Constant;
    std::uint32_t to = 0, a = 0, b = 0;  // registers
    double value = 0;
    Mask mask = 1, mask_a = 0, mask_b = 0;
  };

 private:
  std::vector<Step> steps_;
  std::uint32_t registers_ = 0;
  std::uint32_t result_ = 0;
  Mask result_mask_ = 1;
};

}  // namespace burin
