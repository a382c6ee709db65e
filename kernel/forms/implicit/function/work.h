#pragma once
// A bound on the work that a function may make, whatever it is.

#include <burin/base/error.h>

#include <algorithm>
#include <cstddef>

namespace burin {

/// Thrown where a budget does not hold what is to be done next.
class TooMuchWork : public GeometryError {
 public:
  TooMuchWork() : GeometryError("the surface takes too much work") {}
};

/// Nanoseconds of one core, estimated from counts before the work is begun and never measured, so
/// that results do not depend on the machine.
class WorkBudget {
 public:
  explicit WorkBudget(double nanoseconds) : left_(nanoseconds) {}

  /// Takes off `count` things of `each` nanoseconds; throws TooMuchWork where that is not there.
  void spend(double count, double each) {
    left_ -= count * each;
    if (!(left_ >= 0)) throw TooMuchWork();
  }
  double left() const { return left_; }

 private:
  double left_;
};

/// Nanoseconds for an operation of ImplicitFunction::cost: in batches, alone, with gradient, with
/// Hessian; the name of a piece; intervals and what is left of a function in a box.
namespace work {
constexpr double kValue = 1, kOneValue = 5, kGradient = 3, kHessian = 8, kPiece = 10, kBox = 60;

/// Things of `each` nanoseconds in a range of a parallel loop: some 5 ms, so that a cancelled run
/// ends at once.
inline std::size_t grain(double each, std::size_t most) {
  return std::clamp<std::size_t>(static_cast<std::size_t>(5e6 / std::max(each, 1.0)), 1, most);
}
}  // namespace work

}  // namespace burin
