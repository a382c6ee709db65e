#include "primitives.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::csg {
namespace {

// Matrices carry six digits, so that turned axes are as far off from square and from one length.
constexpr double kSixDigits = 1e-5;

Vec3 times(const Matrix& m, Vec3 v) {
  Vec3 out;
  for (int i = 0; i < 3; ++i) {
    const auto& row = m.row[static_cast<std::size_t>(i)];
    out[i] = row[0] * v.x + row[1] * v.y + row[2] * v.z;
  }
  return out;
}

bool square(Vec3 a, Vec3 b) {
  return std::abs(glm::dot(a, b)) <= kSixDigits * glm::length(a) * glm::length(b);
}
bool alike(double a, double b) { return std::abs(a - b) <= kSixDigits * std::max(a, b); }

Vec3 times_point(const Matrix& m, Vec3 p) {
  const auto q = m * std::array<double, 3>{p.x, p.y, p.z};
  return {q[0], q[1], q[2]};
}

/// Whatever the matrix does, the surface goes through the points.
Turned moved_grid(const Turned& t, const Matrix& m) {
  PointGrid grid = *t.grid;
  for (Vec3& p : grid.points) p = times_point(m, p);
  Turned out = t;
  out.grid = std::make_shared<const PointGrid>(std::move(grid));
  return out;
}

}  // namespace

std::optional<Turned> moved(const Turned& t, const Matrix& m) {
  if (t.profile == Turned::Profile::Grid) return moved_grid(t, m);
  const Vec3 u = any_orthogonal(t.axis), v = glm::cross(t.axis, u);
  const Vec3 mu = times(m, u), mv = times(m, v), axis = times(m, t.axis);
  const double across = glm::length(mu), along = glm::length(axis);
  if (!(across > 0 && along > 0)) return std::nullopt;
  if (!square(mu, mv) || !square(mu, axis) || !square(mv, axis)) return std::nullopt;
  if (!alike(across, glm::length(mv))) return std::nullopt;
  if (t.profile == Turned::Profile::Circle && !alike(across, along)) return std::nullopt;
  Turned out = t;
  out.origin = times_point(m, t.origin);
  out.axis = axis / along;
  const Vec2 scale(across, along);
  out.a *= scale;
  out.b *= scale;
  out.middle *= scale;
  out.radius *= across;
  return out;
}

Solid moved(const Solid& solid, const Matrix& m) {
  const double determinant = m.determinant();
  if (determinant == 0) return {};
  Solid out = solid;
  for (Vec3& p : out.positions) p = times_point(m, p);
  if (determinant < 0) {
    for (auto& t : out.triangles) std::swap(t[1], t[2]);
  }
  std::vector<char> lost(solid.surfaces.size(), 0);
  for (std::size_t s = 0; s < lost.size(); ++s) {
    if (const auto turned = moved(solid.surfaces[s], m))
      out.surfaces[s] = *turned;
    else
      lost[s] = 1;
  }
  for (std::int32_t& s : out.surface) {
    if (s >= 0 && lost[static_cast<std::size_t>(s)]) s = -1;
  }
  return out;
}

}  // namespace burin::csg
