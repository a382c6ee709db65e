#include "fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 vec(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Of directions or points about their middle: the axes of their spread, the least first.
struct Spread {
  Vec3 middle{0}, least{0, 0, 1}, most{1, 0, 0};
  /// Root mean squares along the axes, ascending.
  Vec3 reach{0};
};

Spread spread_of(std::span<const Vec3> points, bool about_middle) {
  Spread out;
  if (about_middle) {
    for (const Vec3& p : points) out.middle += p / static_cast<double>(points.size());
  }
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) sum += eigen(p - out.middle) * eigen(p - out.middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(sum /
                                                              static_cast<double>(points.size()));
  out.least = vec(solved.eigenvectors().col(0));
  out.most = vec(solved.eigenvectors().col(2));
  for (int k = 0; k < 3; ++k) out.reach[k] = std::sqrt(std::max(0.0, solved.eigenvalues()[k]));
  return out;
}

double size_of(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box.diagonal();
}

/// A direction whose sense does not depend on rounding: its largest coordinate is positive.
Vec3 with_sense(Vec3 v) {
  constexpr double kAsLarge = 1 - 1e-9;
  int largest = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(v[k]) * kAsLarge > std::abs(v[largest])) largest = k;
  }
  return v[largest] < 0 ? -v : v;
}

std::vector<Vec3> positions_of(std::span<const Sample> samples) {
  std::vector<Vec3> out;
  for (const Sample& s : samples) out.push_back(s.position);
  return out;
}
std::vector<Vec3> normals_of(std::span<const Sample> samples) {
  std::vector<Vec3> out;
  for (const Sample& s : samples) out.push_back(s.normal);
  return out;
}

bool is_plane(std::span<const Sample> samples, double size, const FitTolerance& tolerance,
              Feature& out) {
  Vec3 sum(0);
  for (const Sample& s : samples) sum += s.normal;
  if (glm::length(sum) < 0.5 * static_cast<double>(samples.size())) return false;
  const Vec3 normal = glm::normalize(sum), at = samples.front().position;
  for (const Sample& s : samples) {
    if (glm::length(glm::cross(s.normal, normal)) > tolerance.normal) return false;
    if (std::abs(glm::dot(s.position - at, normal)) > tolerance.place * size) return false;
  }
  out.kind = FeatureKind::Plane;
  out.point = at;
  out.along = normal;
  return true;
}

/// Least squares of rows (a, b): a x = b.
class Rows {
 public:
  explicit Rows(int unknowns, std::size_t rows)
      : a_(static_cast<Eigen::Index>(rows), unknowns), b_(static_cast<Eigen::Index>(rows)) {}
  template <class... T>
  void add(double b, T... a) {
    int column = 0;
    ((a_(row_, column++) = a), ...);
    b_(row_++) = b;
  }
  Eigen::VectorXd solved() const { return a_.colPivHouseholderQr().solve(b_); }

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd b_;
  Eigen::Index row_ = 0;
};

/// p = c + r n in the plane across an axis; nothing of r where it changes along it (a cone).
bool is_cylinder(std::span<const Sample> samples, Vec3 along, double size,
                 const FitTolerance& tolerance, Feature& out) {
  const Vec3 u = any_orthogonal(along), v = glm::cross(along, u), at = samples.front().position;
  Rows rows(3, 2 * samples.size());
  for (const Sample& s : samples) {
    rows.add(glm::dot(s.position - at, u), 1.0, 0.0, glm::dot(s.normal, u));
    rows.add(glm::dot(s.position - at, v), 0.0, 1.0, glm::dot(s.normal, v));
  }
  const Eigen::VectorXd x = rows.solved();
  const Vec3 center = at + x[0] * u + x[1] * v;
  for (const Sample& s : samples) {
    const double off = glm::length(reject(s.position - center, along)) - std::abs(x[2]);
    if (!(std::abs(off) <= tolerance.place * size)) return false;
  }
  out.kind = FeatureKind::Cylinder;
  out.point = center;
  out.along = along;
  out.radius = std::abs(x[2]);
  out.hollow = x[2] < 0;
  return out.radius < 1e6 * size;
}

/// p = c + (a + b h) m across an axis, m being the way of the normal across it.
bool is_cone(std::span<const Sample> samples, Vec3 along, double size,
             const FitTolerance& tolerance, Feature& out) {
  const Vec3 u = any_orthogonal(along), v = glm::cross(along, u), at = samples.front().position;
  Rows rows(4, 2 * samples.size());
  for (const Sample& s : samples) {
    const Vec3 across = reject(s.normal, along);
    if (!(glm::length(across) > tolerance.normal)) return false;
    const Vec3 m = glm::normalize(across);
    const double h = glm::dot(s.position - at, along);
    rows.add(glm::dot(s.position - at, u), 1.0, 0.0, glm::dot(m, u), h * glm::dot(m, u));
    rows.add(glm::dot(s.position - at, v), 0.0, 1.0, glm::dot(m, v), h * glm::dot(m, v));
  }
  const Eigen::VectorXd x = rows.solved();
  const Vec3 center = at + x[0] * u + x[1] * v;
  double most = 0;
  for (const Sample& s : samples) {
    const double radius = std::abs(x[2] + x[3] * glm::dot(s.position - at, along));
    const double off = glm::length(reject(s.position - center, along)) - radius;
    if (!(std::abs(off) <= tolerance.place * size)) return false;
    most = std::max(most, radius);
  }
  out.kind = FeatureKind::Cone;
  out.point = center;
  out.along = along;
  out.radius = most;
  out.opening = 2 * glm::degrees(std::atan(std::abs(x[3])));
  out.hollow = x[2] < 0;
  return true;
}

bool is_sphere(std::span<const Sample> samples, double size, const FitTolerance& tolerance,
               Feature& out) {
  const Vec3 at = samples.front().position;
  Rows rows(4, 3 * samples.size());
  for (const Sample& s : samples) {
    const Vec3 p = s.position - at;
    rows.add(p.x, 1.0, 0.0, 0.0, s.normal.x);
    rows.add(p.y, 0.0, 1.0, 0.0, s.normal.y);
    rows.add(p.z, 0.0, 0.0, 1.0, s.normal.z);
  }
  const Eigen::VectorXd x = rows.solved();
  const Vec3 center = at + Vec3(x[0], x[1], x[2]);
  for (const Sample& s : samples) {
    const double off = glm::distance(s.position, center) - std::abs(x[3]);
    if (!(std::abs(off) <= tolerance.place * size)) return false;
  }
  out.kind = FeatureKind::Sphere;
  out.point = center;
  out.radius = std::abs(x[3]);
  out.hollow = x[3] < 0;
  return out.radius < 1e6 * size;
}

/// The circle through points of a plane (u, v): center and radius.
std::optional<Vec3> circle_through(const std::vector<Vec2>& points, double size, double place) {
  Rows rows(3, points.size());
  for (const Vec2& p : points) rows.add(glm::dot(p, p), 2 * p.x, 2 * p.y, 1.0);
  const Eigen::VectorXd x = rows.solved();
  const Vec2 center(x[0], x[1]);
  const double radius = std::sqrt(std::max(0.0, x[2] + glm::dot(center, center)));
  if (!(radius > 0 && radius < 1e6 * size)) return std::nullopt;
  for (const Vec2& p : points) {
    if (!(std::abs(glm::distance(p, center) - radius) <= place * size)) return std::nullopt;
  }
  return Vec3(center, radius);
}

std::vector<Vec2> flat(std::span<const Vec3> points, Vec3 at, Vec3 u, Vec3 v) {
  std::vector<Vec2> out;
  for (const Vec3& p : points) out.emplace_back(glm::dot(p - at, u), glm::dot(p - at, v));
  return out;
}

}  // namespace

Feature fit_surface(std::span<const Sample> samples, const FitTolerance& tolerance) {
  Feature out;
  if (samples.size() < 3) return out;
  const double size = size_of(positions_of(samples));
  if (!(size > 0) || is_plane(samples, size, tolerance, out)) return out;
  const std::vector<Vec3> normals = normals_of(samples);
  const Spread about_origin = spread_of(normals, false);
  if (about_origin.reach.x <= tolerance.normal) {
    if (is_cylinder(samples, with_sense(about_origin.least), size, tolerance, out)) return out;
    return Feature{};
  }
  const Spread about_middle = spread_of(normals, true);
  if (about_middle.reach.x <= tolerance.normal) {
    if (is_cone(samples, with_sense(about_middle.least), size, tolerance, out)) return out;
    return Feature{};
  }
  Feature sphere;
  return is_sphere(samples, size, tolerance, sphere) ? sphere : Feature{};
}

std::optional<Feature> fit_torus(std::span<const Sample> samples, Vec3 point, Vec3 along,
                                 const FitTolerance& tolerance) {
  const double size = size_of(positions_of(samples));
  Rows rows(3, 2 * samples.size());
  for (const Sample& s : samples) {
    const Vec3 across = reject(s.position - point, along);
    const double rho = glm::length(across);
    if (!(rho > 0)) return std::nullopt;
    rows.add(rho, 1.0, 0.0, glm::dot(s.normal, across / rho));
    rows.add(glm::dot(s.position - point, along), 0.0, 1.0, glm::dot(s.normal, along));
  }
  const Eigen::VectorXd x = rows.solved();
  for (const Sample& s : samples) {
    const double rho = glm::length(reject(s.position - point, along)),
                 z = glm::dot(s.position - point, along);
    const double off = std::hypot(rho - x[0], z - x[1]) - std::abs(x[2]);
    if (!(std::abs(off) <= tolerance.place * size)) return std::nullopt;
  }
  Feature out;
  out.kind = FeatureKind::Torus;
  out.point = point + x[1] * along;
  out.along = with_sense(along);
  out.ring = std::abs(x[0]);
  out.radius = std::abs(x[2]);
  out.hollow = x[2] < 0;
  return out.radius < 1e6 * size ? std::optional(out) : std::nullopt;
}

Feature fit_facets(std::span<const Vec3> corners, std::span<const Vec3> normals) {
  Feature out;
  const double size = size_of(corners);
  if (corners.size() < 4 || !(size > 0)) return out;
  const Spread spread = spread_of(normals, false);
  if (spread.reach.x <= kFacetFit.normal) {
    const Vec3 along = with_sense(spread.least), u = any_orthogonal(along),
               v = glm::cross(along, u), at = corners.front();
    const auto circle = circle_through(flat(corners, at, u, v), size, kFacetFit.place);
    if (!circle) return out;
    out.kind = FeatureKind::Cylinder;
    out.point = at + circle->x * u + circle->y * v;
    out.along = along;
    out.radius = circle->z;
    return out;
  }
  Rows rows(4, corners.size());
  const Vec3 at = corners.front();
  for (const Vec3& corner : corners) {
    const Vec3 p = corner - at;
    rows.add(glm::dot(p, p), 2 * p.x, 2 * p.y, 2 * p.z, 1.0);
  }
  const Eigen::VectorXd x = rows.solved();
  const Vec3 center(x[0], x[1], x[2]);
  const double radius = std::sqrt(std::max(0.0, x[3] + glm::dot(center, center)));
  for (const Vec3& corner : corners) {
    if (!(std::abs(glm::distance(corner - at, center) - radius) <= kFacetFit.place * size))
      return out;
  }
  out.kind = FeatureKind::Sphere;
  out.point = at + center;
  out.radius = radius;
  return out;
}

Feature fit_edge(std::span<const Vec3> points) {
  Feature out;
  if (points.size() < 2) return out;
  const Spread spread = spread_of(points, true);
  const double size = size_of(points);
  if (!(size > 0)) return out;
  if (spread.reach.y <= kExactFit.place * size) {
    // The two that are farthest apart know the way best.
    const auto [first, last] = std::ranges::minmax_element(
        points, {}, [&](const Vec3& p) { return glm::dot(p, spread.most); });
    out.kind = FeatureKind::Line;
    out.point = *first;
    out.along = with_sense(glm::normalize(*last - *first));
    return out;
  }
  if (points.size() < 4 || spread.reach.x > kExactFit.place * size) return out;
  const Vec3 along = with_sense(spread.least), u = any_orthogonal(along), v = glm::cross(along, u);
  const auto circle = circle_through(flat(points, spread.middle, u, v), size, kExactFit.place);
  if (!circle) return out;
  out.kind = FeatureKind::Circle;
  out.point = spread.middle + circle->x * u + circle->y * v;
  out.along = along;
  out.radius = circle->z;
  return out;
}

}  // namespace burin::detail
