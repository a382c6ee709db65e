#pragma once
// A program run for one point: marching asks for one at a time. All derivatives of an operation lie
// next to one another, and all are computed, whether they are zero or not: that is a few vector
// instructions, where asking which of them matter takes longer.

#include "program.h"

namespace burin {

/// Components: 1 value, 4 with the gradient, 10 with the Hessian.
template <int Count>
void run_one(const std::vector<Program::Step>& steps, std::uint32_t registers, std::uint32_t result,
             Vec3 p, double (&out)[Count]);

}  // namespace burin
