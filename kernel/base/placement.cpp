#include <burin/base/placement.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace burin {

Mat3 rotation(Vec3 degrees) {
  // Whole quarter turns are exact.
  const auto sine = [](double d) {
    const double r = std::fmod(std::fmod(d, 360) + 360, 360);
    return r == 0 || r == 180 ? 0
           : r == 90          ? 1
           : r == 270         ? -1
                              : std::sin(r * std::numbers::pi / 180);
  };
  const Vec3 s(sine(degrees.x), sine(degrees.y), sine(degrees.z));
  const Vec3 c(sine(degrees.x + 90), sine(degrees.y + 90), sine(degrees.z + 90));
  const Mat3 x(1, 0, 0, 0, c.x, s.x, 0, -s.x, c.x), y(c.y, 0, -s.y, 0, 1, 0, s.y, 0, c.y),
      z(c.z, s.z, 0, -s.z, c.z, 0, 0, 0, 1);
  return z * y * x;
}

double off_rotation(const Mat3& m) {
  const Mat3 unit = glm::transpose(m) * m;
  double off = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double here = std::abs(unit[column][row] - (row == column ? 1 : 0));
      if (std::isnan(here)) return std::numeric_limits<double>::infinity();
      off = std::max(off, here);
    }
  }
  return off;
}

}  // namespace burin
