#include <burin/base/placement.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>
#include <numbers>

namespace burin {
namespace {

/// The factors by which lengths grow along three directions at right angles, ascending.
Vec3 principal_stretches(const Mat3& m) {
  const Mat3 gram = glm::transpose(m) * m;
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) matrix(i, k) = gram[k][i];
  }
  const Eigen::Vector3d squares =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  return glm::sqrt(glm::max(Vec3(squares(0), squares(1), squares(2)), Vec3(0)));
}

}  // namespace

bool Placement::is_similar() const {
  constexpr double kSingle = 1e-5;
  const double all = scale();
  return all > 0 && off_rotation(linear / all) <= kSingle;
}

bool Placement::is_invertible() const {
  // Of the largest one: flatter than that is flat, but for rounding.
  constexpr double kFlat = 1e-14;
  double sum = offset.x + offset.y + offset.z;
  for (int i = 0; i < 3; ++i) sum += linear[i].x + linear[i].y + linear[i].z;
  if (!std::isfinite(sum)) return false;
  const double volume = std::abs(glm::determinant(linear)), most = principal_stretches(linear).z;
  return volume > 0 && volume > kFlat * most * most * most && std::isfinite(most);
}

double Placement::stretch() const { return is_similar() ? scale() : principal_stretches(linear).z; }

double Placement::area_stretch() const {
  if (is_similar()) return scale() * scale();
  const Vec3 by = principal_stretches(linear);
  return by.y * by.z;
}

Placement Placement::inverse() const {
  const Mat3 back = glm::inverse(linear);
  return {back, -(back * offset)};
}

Vec3 placed_normal(const Placement& placement, Vec3 n) {
  return glm::normalize(glm::transpose(glm::inverse(placement.linear)) * n);
}

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
