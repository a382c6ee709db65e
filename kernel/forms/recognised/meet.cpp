#include "meet.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace burin::recognised {
namespace {

// A point moves by the sagitta where surfaces meet at right angles, by more where they do not.
constexpr double kMeetReach = 4;
constexpr int kMeetSteps = 12;
// Of the sagitta: a point so near to a surface is on it.
constexpr double kClose = 1e-3;
// Surfaces that meet at less than this (sine) do not hold a point along their common normal.
constexpr double kTransversal = 0.03;

}  // namespace

double Meeting::distance(SurfaceRef ref, Vec3 p, Vec3& normal) const {
  if (ref < 0) {
    const Facet& f = facets_.list[static_cast<std::size_t>(~ref)];
    normal = f.normal;
    return glm::dot(f.normal, p) - f.offset;
  }
  return round_.patches[static_cast<std::size_t>(ref)].distance(p, normal);
}

Vec3 Meeting::normal(SurfaceRef ref, Vec3 p) const {
  return ref < 0 ? facets_.list[static_cast<std::size_t>(~ref)].normal
                 : round_.patches[static_cast<std::size_t>(ref)].normal_at(p);
}

double Meeting::sagitta(SurfaceRef ref) const {
  return ref < 0 ? 0 : round_.patches[static_cast<std::size_t>(ref)].sagitta;
}

bool Meeting::between(std::span<const SurfaceRef> refs, Vec3& p) const {
  constexpr double kAlike = 0.9;  // the cosine between normals of surfaces that go over smoothly
  Vec3 sum(0);
  const Vec3 first = normal(refs.front(), p);
  for (const SurfaceRef r : refs) {
    if (glm::dot(normal(r, p), first) < kAlike) return false;
    Vec3 n;
    const double d = distance(r, p, n);
    if (!(std::abs(d) <= 2 * sagitta(r) + 10 * facets_.noise) && r >= 0) return false;
    sum += p - d * n;
  }
  p = sum / static_cast<double>(refs.size());
  return true;
}

Vec3 Meeting::step_to_both(std::span<const SurfaceRef> refs, Vec3 p, double& worst) const {
  Vec3 m(0), n(0);
  const double a = -distance(refs.front(), p, m);
  const double b = refs.size() > 1 ? -distance(refs.back(), p, n) : 0;
  worst = std::max(std::abs(a), std::abs(b));
  if (refs.size() == 1) return a * m;
  const double c = glm::dot(m, n), alike = std::abs(c), sign = c < 0 ? -1 : 1;
  if (1 - alike <= kTransversal * kTransversal * (1 + alike)) {
    return (a + sign * b) / (2 * (1 + alike)) * (m + sign * n);
  }
  return ((a - c * b) * m + (b - c * a) * n) / (1 - c * c);
}

Vec3 Meeting::step_to_all(std::span<const SurfaceRef> refs, Vec3 p, double& worst) const {
  Eigen::MatrixXd m(refs.size(), 3);
  Eigen::VectorXd b(refs.size());
  for (std::size_t i = 0; i < refs.size(); ++i) {
    Vec3 n;
    const auto row = static_cast<Eigen::Index>(i);
    b(row) = -distance(refs[i], p, n);
    m.row(row) << n.x, n.y, n.z;
  }
  worst = b.cwiseAbs().maxCoeff();
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(m, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(kTransversal);
  const Eigen::Vector3d d = svd.solve(b);
  return {d(0), d(1), d(2)};
}

double Meeting::largest_sagitta(std::span<const SurfaceRef> refs) const {
  double most = 0;
  for (const SurfaceRef r : refs) most = std::max(most, sagitta(r));
  return most;
}

bool Meeting::holds(std::span<const SurfaceRef> refs, Vec3 p) const {
  const double close = 2 * facets_.noise + kClose * largest_sagitta(refs);
  return std::ranges::all_of(refs, [&](SurfaceRef r) {
    Vec3 n;
    return std::abs(distance(r, p, n)) <= close;
  });
}

bool Meeting::operator()(std::span<const SurfaceRef> refs, Vec3& p) const {
  const double sagittas = largest_sagitta(refs);
  if (refs.size() == 1 && refs.front() >= 0) {
    const Vec3 q = round_.patches[static_cast<std::size_t>(refs.front())].project(p);
    if (!(glm::length(q - p) <= kMeetReach * sagittas + 10 * facets_.noise)) return false;
    p = q;
    return true;
  }
  const double close = 2 * facets_.noise + kClose * sagittas;
  Vec3 q = p;
  for (int step = 0; step < kMeetSteps; ++step) {
    double worst = 0;
    const Vec3 d = refs.size() > 2 ? step_to_all(refs, q, worst) : step_to_both(refs, q, worst);
    // Once near, one more step squares the rest.
    const bool last = worst <= 1e-6 * close;
    if (!last || worst > 0) q += d;
    if (!(glm::length(q - p) <= kMeetReach * sagittas + 10 * facets_.noise)) return false;
    if (last) break;
  }
  if (!holds(refs, q)) return between(refs, p);
  p = q;
  return true;
}

}  // namespace burin::recognised
