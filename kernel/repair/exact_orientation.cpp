#include "exact_orientation.h"

#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// A number as an unevaluated sum of doubles that do not overlap, the smallest first.
class ExactSum {
 public:
  void add(double x) {
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = x + parts_[i], y = sum - x;
      parts_[i] = (x - (sum - y)) + (parts_[i] - y);
      x = sum;
    }
    parts_[size_++] = x;
  }
  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }
  int sign() const {
    for (std::size_t i = size_; i-- > 0;) {
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  std::array<double, 12> parts_{};
  std::size_t size_ = 0;
};

}  // namespace

int orientation(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // The rounding of the three subtractions and products above: bound A of Shewchuk, section 4.
  constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kBound = (3 + 16 * kHalfUlp) * kHalfUlp;
  const double error = kBound * (std::abs(left) + std::abs(right));
  if (det > error) return 1;
  if (det < -error) return -1;
  ExactSum sum;
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.add_product(-c.y, a.x);
  return sum.sign();
}

}  // namespace burin
