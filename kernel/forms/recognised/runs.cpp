#include "runs.h"

#include "facets.h"

#include <Eigen/Dense>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <set>
#include <utility>

namespace burin::recognised {
namespace {

// Nine facets a turn are the fewest; the rest is for rounding.
constexpr double kLargestStepOfRun = kTurn / 9 * 1.01;
// A circle of 1800 sides needs no healing.
constexpr double kLeastStep = kTurn / 1800;
// A plane may be off by this share of the sagitta of its facet: the facets of a thread, which drift
// along the axis, are off by more.
constexpr double kOffPlane = 0.005;
// How far a facet may reach out of its share of the turn.
constexpr double kSector = 0.02;
// Nearly flat cones have no axis to speak of.
constexpr double kFlattest = 0.99995;
// Sine of the angle between an edge and the axis along which it runs.
constexpr double kAlong = 0.01;
// Neighbours of a facet at which a run may begin: those with the longest edges.
constexpr std::size_t kNeighbours = 8;

bool solve(const std::vector<const Facet*>& facets, Vec3 direction, Fit& fit) {
  const Vec3 o = facets.front()->center;
  const Vec3 e1 = any_orthogonal(direction), e2 = glm::cross(direction, e1);
  Eigen::MatrixXd m(facets.size(), 3);
  Eigen::VectorXd b(facets.size());
  fit.rise = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const Facet& f = *facets[i];
    const auto row = static_cast<Eigen::Index>(i);
    m.row(row) << glm::dot(f.normal, e1), glm::dot(f.normal, e2), 1.0;
    b(row) = glm::dot(f.normal, f.center - o);
    fit.rise += glm::dot(f.normal, direction) / static_cast<double>(facets.size());
  }
  const Eigen::Vector3d x = m.colPivHouseholderQr().solve(b);
  if (!x.allFinite() || std::abs(fit.rise) > kFlattest) return false;
  fit.axis = {o + x(0) * e1 + x(1) * e2, direction};
  fit.offset = x(2);
  return true;
}

/// The phase and the side, once axis and rise are known.
bool orient(const Facet& f, Fit& fit) {
  const double h = glm::dot(f.center - fit.axis.origin, fit.axis.direction);
  fit.side = fit.offset - fit.rise * h >= 0 ? 1 : -1;
  const Vec3 across = f.normal - fit.rise * fit.axis.direction;
  const Vec3 flat = across - glm::dot(across, fit.axis.direction) * fit.axis.direction;
  if (!(glm::length(flat) > 0)) return false;
  fit.phase = fit.side * glm::normalize(flat);
  return true;
}

}  // namespace

std::vector<Run> RunFinder::find(const RunContext& context) {
  for (std::size_t f = 0; f < facets_.list.size(); ++f) {
    if (f % 64 == 0) context.check();
    begin_at(static_cast<std::int32_t>(f));
  }
  return std::move(runs_);
}

/// Runs through this facet and two of its neighbours.
void RunFinder::begin_at(std::int32_t middle) {
  std::vector<FacetLink> near;
  for (const FacetLink& l : facet(middle).links) {
    const double a = angle_between(facet(l.facet).normal, facet(middle).normal);
    if (a <= kLargestStepOfRun && facet(l.facet).area > 0) near.push_back(l);
  }
  if (near.size() > kNeighbours) {
    std::stable_sort(near.begin(), near.end(),
                     [](const FacetLink& a, const FacetLink& b) { return a.length > b.length; });
    near.resize(kNeighbours);
  }
  for (std::size_t i = 0; i < near.size(); ++i) {
    for (std::size_t j = i + 1; j < near.size(); ++j) {
      try_run(near[i].facet, middle, near[j].facet);
    }
  }
}

bool RunFinder::known(std::int32_t a, std::int32_t b, std::int32_t c) const {
  const auto& of = runs_of_;
  const auto has = [&](std::int32_t f, std::int32_t run) {
    const auto& list = of[static_cast<std::size_t>(f)];
    return std::find(list.begin(), list.end(), run) != list.end();
  };
  for (const std::int32_t run : of[static_cast<std::size_t>(b)]) {
    if (has(a, run) && has(c, run)) return true;
  }
  return false;
}

void RunFinder::try_run(std::int32_t a, std::int32_t b, std::int32_t c) {
  if (known(a, b, c)) return;
  const Vec3 na = facet(a).normal, nb = facet(b).normal, nc = facet(c).normal;
  const Vec3 axis = glm::cross(nb - na, nc - nb);
  const double length = glm::length(axis);
  // Normals on a great circle of steps below the least have a smaller product.
  if (!(length > kLeastStep * kLeastStep * kLeastStep)) return;
  Run run;
  if (!solve({&facet(a), &facet(b), &facet(c)}, axis / length, run.fit)) return;
  if (!orient(facet(b), run.fit)) return;
  const auto step = [&](std::int32_t from, std::int32_t to) {
    const Vec3 d = run.fit.axis.direction, m = facet(from).normal, n = facet(to).normal;
    const Vec3 u = m - glm::dot(m, d) * d, v = n - glm::dot(n, d) * d;
    return std::atan2(glm::dot(glm::cross(u, v), d), glm::dot(u, v));
  };
  const double first = step(a, b), second = step(b, c);
  const double mean = 0.5 * (first + second);
  if (std::abs(mean) > kLargestStepOfRun || std::abs(mean) < kLeastStep) return;
  if (std::abs(first - second) > kEqual * std::abs(mean)) return;
  run.fit.step = std::abs(mean);
  const double sides = std::round(kTurn / run.fit.step);
  if (std::abs(kTurn / run.fit.step - sides) < 0.1) run.fit.step = kTurn / sides;
  for (const std::int32_t f : {a, b, c}) {
    if (!holds(run.fit, facet(f))) return;
  }
  grow(run, b);
  refine(run);
  if (!enough(run)) return;
  const auto id = static_cast<std::int32_t>(runs_.size());
  for (const std::int32_t f : run.facets) runs_of_[static_cast<std::size_t>(f)].push_back(id);
  runs_.push_back(std::move(run));
}

bool RunFinder::holds(const Fit& fit, const Facet& f) const {
  if (!(f.area > 0)) return false;
  const double index = std::round(fit.angle(f.center) / fit.step);
  const Vec3 spoke = fit.spoke(index * fit.step);
  const Vec3 normal = fit.side * fit.spread() * spoke + fit.rise * fit.axis.direction;
  if (glm::dot(normal, f.normal) < std::cos(0.25 * fit.step)) return false;
  const Vec3 around = glm::cross(fit.axis.direction, spoke);
  const double half = std::tan(0.5 * fit.step * (1 + kSector));
  for (const std::uint32_t v : f.vertices) {
    const Vec3 d = mesh_.positions[v] - fit.axis.origin;
    const double h = glm::dot(d, fit.axis.direction);
    const double most = kOffPlane * fit.sagitta(h) + 3 * facets_.noise;
    if (std::abs(glm::dot(normal, d) - fit.offset) > most) return false;
    const double out = glm::dot(d, spoke), aside = std::abs(glm::dot(d, around));
    if (aside > half * out + 3 * facets_.noise) return false;
  }
  return true;
}

void RunFinder::grow(Run& run, std::int32_t seed) const {
  std::set<std::int32_t> in{seed};
  run.facets = {seed};
  for (std::size_t i = 0; i < run.facets.size(); ++i) {
    for (const FacetLink& l : facet(run.facets[i]).links) {
      if (in.contains(l.facet) || !holds(run.fit, facet(l.facet))) continue;
      in.insert(l.facet);
      run.facets.push_back(l.facet);
    }
  }
}

/// The axis by all facets; the run as it was where that fits fewer.
void RunFinder::refine(Run& run) const {
  if (run.facets.size() < 5) return;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::int32_t f : run.facets) {
    const Vec3 n = facet(f).normal;
    mean += Eigen::Vector3d(n.x, n.y, n.z);
  }
  mean /= static_cast<double>(run.facets.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  std::vector<const Facet*> all;
  for (const std::int32_t f : run.facets) {
    const Vec3 n = facet(f).normal;
    const Eigen::Vector3d d = Eigen::Vector3d(n.x, n.y, n.z) - mean;
    spread += d * d.transpose();
    all.push_back(&facet(f));
  }
  const Eigen::Vector3d a =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  Vec3 direction(a(0), a(1), a(2));
  if (glm::dot(direction, run.fit.axis.direction) < 0) direction = -direction;
  Run better;
  better.fit.step = run.fit.step;
  if (!solve(all, direction, better.fit) || !orient(facet(run.facets.front()), better.fit)) return;
  grow(better, run.facets.front());
  if (better.facets.size() >= run.facets.size()) run = std::move(better);
}

std::size_t RunFinder::steps(const Run& run) const {
  std::set<long> indices;
  const long sides = std::lround(kTurn / run.fit.step);
  for (const std::int32_t f : run.facets) {
    const long i = std::lround(run.fit.angle(facet(f).center) / run.fit.step);
    indices.insert(((i % sides) + sides) % sides);
  }
  return indices.size();
}

bool RunFinder::enough(const Run& run) const {
  const std::size_t n = steps(run);
  // A short piece of a thread looks like a cone.
  constexpr double kUpright = 0.01, kLeastCone = 1.4;  // sine of the slope; radians around
  if (std::abs(run.fit.rise) > kUpright && static_cast<double>(n) * run.fit.step < kLeastCone) {
    return false;
  }
  if (n != kLeastFacets) return n > kLeastFacets;
  if (goes_on_alike(run)) return false;
  return std::all_of(run.facets.begin(), run.facets.end(), [&](std::int32_t f) {
    const double index = std::round(run.fit.angle(facet(f).center) / run.fit.step);
    double low = 0, high = 0;
    for (const std::uint32_t v : facet(f).vertices) {
      const double a = run.fit.angle(mesh_.positions[v]) - index * run.fit.step;
      low = std::min(low, std::remainder(a, kTurn));
      high = std::max(high, std::remainder(a, kTurn));
    }
    return std::min(-low, high) >= 0.5 * run.fit.step * (1 - 2 * kSector);
  });
}

/// Whether beyond an edge along the axis follows a facet about as wide, at about the angle of a
/// step, that is none of the run: it bends on nearly alike and is no circle. A zone of a
/// zonohedron, whose middle facets mirror each other, is such a one.
bool RunFinder::goes_on_alike(const Run& run) const {
  const auto near = [](double a, double b) { return a < kOtherCircle * b && b < kOtherCircle * a; };
  const Vec3 axis = run.fit.axis.direction;
  return std::ranges::any_of(run.facets, [&](std::int32_t f) {
    return std::ranges::any_of(facet(f).links, [&](const FacetLink& l) {
      const Facet &one = facet(f), &other = facet(l.facet);
      return std::ranges::find(run.facets, l.facet) == run.facets.end() &&
             near(angle_between(one.normal, other.normal), run.fit.step) &&
             near(width(one, axis), width(other, axis)) && meet_along(one, other, axis);
    });
  });
}

/// mm across an axis.
double RunFinder::width(const Facet& f, Vec3 axis) const {
  const Vec3 across = normalize_or(glm::cross(axis, f.normal), Vec3(0));
  double low = 1e300, high = -1e300;
  for (const std::uint32_t v : f.vertices) {
    low = std::min(low, glm::dot(mesh_.positions[v], across));
    high = std::max(high, glm::dot(mesh_.positions[v], across));
  }
  return high - low;
}

/// Whether the corners that two facets share lie on a line along an axis.
bool RunFinder::meet_along(const Facet& a, const Facet& b, Vec3 axis) const {
  std::vector<std::uint32_t> common;
  std::ranges::set_intersection(a.vertices, b.vertices, std::back_inserter(common));
  if (common.size() < 2) return false;
  const Vec3 first = mesh_.positions[common.front()];
  return std::ranges::all_of(common, [&](std::uint32_t v) {
    const Vec3 off = mesh_.positions[v] - first;
    return glm::length(glm::cross(off, axis)) <= kAlong * glm::length(off) + 3 * facets_.noise;
  });
}

}  // namespace burin::recognised
