#include <burin/base/affine.h>

#include <Eigen/Eigenvalues>

#include <cmath>

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

bool is_similar(const Placement& placement) {
  constexpr double kSingle = 1e-5;
  const double all = placement.scale();
  return all > 0 && off_rotation(placement.linear / all) <= kSingle;
}

bool is_invertible(const Placement& placement) {
  // Of the largest one: flatter than that is flat, but for rounding.
  constexpr double kFlat = 1e-14;
  const auto& [m, offset] = placement;
  double sum = offset.x + offset.y + offset.z;
  for (int i = 0; i < 3; ++i) sum += m[i].x + m[i].y + m[i].z;
  if (!std::isfinite(sum)) return false;
  const double volume = std::abs(glm::determinant(m)), most = principal_stretches(m).z;
  return volume > 0 && volume > kFlat * most * most * most && std::isfinite(most);
}

double stretch(const Placement& placement) {
  return is_similar(placement) ? placement.scale() : principal_stretches(placement.linear).z;
}

double area_stretch(const Placement& placement) {
  if (is_similar(placement)) return placement.scale() * placement.scale();
  const Vec3 by = principal_stretches(placement.linear);
  return by.y * by.z;
}

Placement inverse(const Placement& placement) {
  const Mat3 back = glm::inverse(placement.linear);
  return {back, -(back * placement.offset)};
}

Vec3 placed_normal(const Placement& placement, Vec3 n) {
  return glm::normalize(glm::transpose(glm::inverse(placement.linear)) * n);
}

}  // namespace burin
