#pragma once
// A function cut off by planes.

#include <burin/forms/implicit/implicit_function.h>

#include <memory>
#include <vector>

namespace burin {

/// dot(normal, p) <= at; the normal's length says how steep the face is as a function.
struct HalfSpace {
  Vec3 normal{0};
  double at = 0;
};

/// max(function, planes): the part inside all half spaces, closed by their faces. `bounds` holds
/// that part. What is not a number stays so.
std::shared_ptr<const ImplicitFunction> clip(std::shared_ptr<const ImplicitFunction> function,
                                             const std::vector<HalfSpace>& planes,
                                             const Box3& bounds);

}  // namespace burin
