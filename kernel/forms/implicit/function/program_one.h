#pragma once
// A program run for one point: marching asks for one at a time. All derivatives of an operation lie
// next to one another and are computed together: value, gradient, Hessian, each whole or not at
// all. That is a few vector instructions; asking which components are zero would take longer.

#include "program.h"

namespace burin {

/// Components: 1 value, 4 with the gradient, 10 with the Hessian. `mask` is the result's.
template <int Count>
void run_one(const std::vector<Program::Step>& steps, std::uint32_t registers, std::uint32_t result,
             Program::Mask mask, Vec3 p, double (&out)[Count]);

}  // namespace burin
