#include "bands.h"

#include "balls.h"
#include "outlines.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

namespace burin::recognised {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
// Nine facets a turn are the fewest; the rest is for rounding.
constexpr double kLargestStep = kTurn / 9 * 1.01;
// A circle of 1800 sides needs no healing.
constexpr double kLeastStep = kTurn / 1800;
// How unequal the first two steps may be.
constexpr double kEqual = 0.02;
// A plane may be off by this share of the sagitta of its facet: the facets of a thread, which drift
// along the axis, are off by more.
constexpr double kOfSagitta = 0.005;
// How far a facet may reach out of its share of the turn.
constexpr double kSector = 0.02;
// Nearly flat cones have no axis to speak of.
constexpr double kFlattest = 0.99995;
constexpr std::size_t kLeastFacets = 3;
// Facets of which one bends no more than so many times as much as the next are those of one curve.
constexpr double kOtherCircle = 1.5;
// Sine of the angle between an edge and the axis along which it runs.
constexpr double kAlong = 0.01;
// Neighbours of a facet at which a run may begin: those with the longest edges.
constexpr std::size_t kNeighbours = 8;
// Tests of lost facets against bands.
constexpr std::size_t kMostTests = 20'000'000;

/// A cone or cylinder by the planes that touch it: (n_i - rise direction) of equal length.
struct Fit {
  Axis axis;
  double rise = 0, offset = 0;  // n . direction; n . (x - origin) of all facets
  double step = 0;
  double side = 1;  // 1: facets look away from the axis
  Vec3 phase{1, 0, 0};

  double spread() const { return std::sqrt(1 - rise * rise); }
  /// Radius of the circle through the vertices at a height.
  double radius(double h) const {
    return side * (offset - rise * h) / spread() / std::cos(0.5 * step);
  }
  double sagitta(double h) const { return std::abs(radius(h)) * (1 - std::cos(0.5 * step)); }
  /// The angle of a point around the axis, from the phase.
  double angle(Vec3 p) const {
    const Vec3 d = p - axis.origin;
    return std::atan2(glm::dot(glm::cross(phase, d), axis.direction), glm::dot(phase, d));
  }
  Vec3 spoke(double angle) const {
    return std::cos(angle) * phase + std::sin(angle) * glm::cross(axis.direction, phase);
  }
};

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

class Finder {
 public:
  Finder(const TriMesh& mesh, const Facets& facets, const RunContext& context)
      : mesh_(mesh), facets_(facets), context_(context), runs_of_(facets.list.size()) {}

  Bands run() {
    for (std::size_t f = 0; f < facets_.list.size(); ++f) {
      if (f % 64 == 0) context_.check();
      begin_at(static_cast<std::int32_t>(f));
    }
    take_spheres();
    claim();
    join();
    take_lost();
    return std::move(out_);
  }

 private:
  struct Run {
    Fit fit;
    std::vector<std::int32_t> facets;
  };

  const Facet& facet(std::int32_t f) const { return facets_.list[static_cast<std::size_t>(f)]; }

  /// Runs through this facet and two of its neighbours.
  void begin_at(std::int32_t middle) {
    std::vector<FacetLink> near;
    for (const FacetLink& l : facet(middle).links) {
      const double a = angle_between(facet(l.facet).normal, facet(middle).normal);
      if (a <= kLargestStep && facet(l.facet).area > 0) near.push_back(l);
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

  bool known(std::int32_t a, std::int32_t b, std::int32_t c) const {
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

  void try_run(std::int32_t a, std::int32_t b, std::int32_t c) {
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
    if (std::abs(mean) > kLargestStep || std::abs(mean) < kLeastStep) return;
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

  /// Whether a facet lies in one of the planes of the run, within its share of the turn.
  bool holds(const Fit& fit, const Facet& f) const {
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
      const double most = kOfSagitta * fit.sagitta(h) + 3 * facets_.noise;
      if (std::abs(glm::dot(normal, d) - fit.offset) > most) return false;
      const double out = glm::dot(d, spoke), aside = std::abs(glm::dot(d, around));
      if (aside > half * out + 3 * facets_.noise) return false;
    }
    return true;
  }

  void grow(Run& run, std::int32_t seed) const {
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
  void refine(Run& run) const {
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
    if (!solve(all, direction, better.fit) || !orient(facet(run.facets.front()), better.fit))
      return;
    grow(better, run.facets.front());
    if (better.facets.size() >= run.facets.size()) run = std::move(better);
  }

  std::size_t steps(const Run& run) const {
    std::set<long> indices;
    const long sides = std::lround(kTurn / run.fit.step);
    for (const std::int32_t f : run.facets) {
      const long i = std::lround(run.fit.angle(facet(f).center) / run.fit.step);
      indices.insert(((i % sides) + sides) % sides);
    }
    return indices.size();
  }

  /// Three planes at equal angles always touch some circle: of so few each facet must fill its
  /// share of the turn, too.
  bool enough(const Run& run) const {
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
  bool goes_on_alike(const Run& run) const {
    const auto near = [](double a, double b) {
      return a < kOtherCircle * b && b < kOtherCircle * a;
    };
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
  double width(const Facet& f, Vec3 axis) const {
    const Vec3 across = normalize_or(glm::cross(axis, f.normal), Vec3(0));
    double low = 1e300, high = -1e300;
    for (const std::uint32_t v : f.vertices) {
      low = std::min(low, glm::dot(mesh_.positions[v], across));
      high = std::max(high, glm::dot(mesh_.positions[v], across));
    }
    return high - low;
  }
  /// Whether the corners that two facets share lie on a line along an axis.
  bool meet_along(const Facet& a, const Facet& b, Vec3 axis) const {
    std::vector<std::uint32_t> common;
    std::ranges::set_intersection(a.vertices, b.vertices, std::back_inserter(common));
    if (common.size() < 2) return false;
    const Vec3 first = mesh_.positions[common.front()];
    return std::ranges::all_of(common, [&](std::uint32_t v) {
      const Vec3 off = mesh_.positions[v] - first;
      return glm::length(glm::cross(off, axis)) <= kAlong * glm::length(off) + 3 * facets_.noise;
    });
  }

  Band band_of(const Run& run) const {
    Band band;
    const Fit& fit = run.fit;
    Patch& p = band.patch;
    p.axis = fit.axis;
    p.step = fit.step;
    Vec2 n(fit.side * fit.spread() * std::cos(0.5 * fit.step), fit.rise);
    const double length = glm::length(n);
    p.normal = n / length;
    p.offset = fit.offset / length;
    band.phase = fit.phase;
    return band;
  }

  /// A ball is a globe where rings around one axis through its middle hold a good part of its
  /// facets; other polyhedra with their corners on a sphere are what they are.
  void take_spheres() {
    constexpr double kShare = 0.3, kParallel = 1e-4;
    out_.of_sphere.assign(facets_.list.size(), -1);
    for (const Ball& ball : find_balls(mesh_, facets_, context_)) {
      std::vector<std::uint8_t> in(facets_.list.size(), 0);
      for (const std::int32_t f : ball.facets) in[static_cast<std::size_t>(f)] = 1;
      std::vector<const Run*> rings;
      for (const Run& run : runs_) {
        const double aside = run.fit.axis.profile(ball.center).x;
        if (aside > 0.1 * ball.sagitta + 10 * facets_.noise) continue;
        const auto held = static_cast<std::size_t>(
            std::count_if(run.facets.begin(), run.facets.end(),
                          [&](std::int32_t f) { return in[static_cast<std::size_t>(f)] != 0; }));
        if (10 * held >= 9 * run.facets.size()) rings.push_back(&run);
      }
      const Run* best = nullptr;
      std::size_t most = 0;
      for (const Run* ring : rings) {
        std::vector<std::uint8_t> held(facets_.list.size(), 0);
        std::size_t count = 0;
        std::set<long> latitudes;
        const double gap = std::abs(ball.radius) - distance(ring->fit, ball.center);
        for (const Run* other : rings) {
          const Vec3 across = glm::cross(ring->fit.axis.direction, other->fit.axis.direction);
          if (glm::length(across) > kParallel) continue;
          // Rings at equal steps of latitude touch one smaller sphere.
          const double deeper = std::abs(ball.radius) - distance(other->fit, ball.center) - gap;
          if (std::abs(deeper) > 0.1 * gap + 3 * facets_.noise) continue;
          const double up = glm::dot(ring->fit.axis.direction, other->fit.axis.direction);
          latitudes.insert(std::lround(1000 * up * other->fit.rise));
          for (const std::int32_t f : other->facets) {
            count += held[static_cast<std::size_t>(f)] == 0 && in[static_cast<std::size_t>(f)] != 0;
            held[static_cast<std::size_t>(f)] = 1;
          }
        }
        if (count > most && latitudes.size() >= kLeastFacets) {
          most = count;
          best = ring;
        }
      }
      if (!best || static_cast<double>(most) < kShare * static_cast<double>(ball.facets.size())) {
        continue;
      }
      add_sphere(ball, best->fit);
    }
  }

  /// From a point on the axis to the cone of a run.
  static double distance(const Fit& fit, Vec3 center) {
    const double c = fit.spread() * std::cos(0.5 * fit.step);
    const double h = glm::dot(center - fit.axis.origin, fit.axis.direction);
    return std::abs(fit.offset - fit.rise * h) / std::sqrt(c * c + fit.rise * fit.rise);
  }

  void add_sphere(const Ball& ball, const Fit& ring) {
    Patch p;
    p.axis = {ball.center, ring.axis.direction};
    p.step = ring.step;
    p.sagitta = ball.sagitta;
    p.turn = ring.step;
    p.profile = Patch::Profile::Circle;
    p.radius = ball.radius;
    p.kind = FaceKind::Sphere;
    for (const std::int32_t f : ball.facets) {
      out_.of_sphere[static_cast<std::size_t>(f)] = static_cast<std::int32_t>(out_.spheres.size());
    }
    out_.spheres.push_back(p);
  }

  /// The largest runs take their facets.
  void claim() {
    std::vector<std::size_t> order(runs_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return runs_[a].facets.size() > runs_[b].facets.size();
    });
    out_.of.assign(facets_.list.size(), -1);
    for (const std::size_t i : order) {
      Run& run = runs_[i];
      // A meridian of a sphere looks like a cylinder; what its rings leave of it is none.
      const std::size_t before = run.facets.size();
      std::erase_if(run.facets, [&](std::int32_t f) {
        const auto k = static_cast<std::size_t>(f);
        return out_.of[k] >= 0 || out_.of_sphere[k] >= 0;
      });
      if (2 * run.facets.size() < before || !enough(run)) continue;
      Band band = band_of(run);
      for (const std::int32_t f : run.facets) {
        out_.of[static_cast<std::size_t>(f)] = static_cast<std::int32_t>(out_.list.size());
      }
      band.facets = run.facets;
      fits_.push_back(run.fit);
      out_.list.push_back(std::move(band));
    }
  }

  /// Bands that a cut has parted become one again.
  void join() {
    if (out_.list.size() > 4000) return;
    for (std::size_t a = 0; a < out_.list.size(); ++a) {
      if (a % 16 == 0) context_.check();
      for (std::size_t b = a + 1; b < out_.list.size(); ++b) {
        Band& from = out_.list[b];
        if (from.facets.empty() || !all_hold(fits_[a], from.facets)) continue;
        for (const std::int32_t f : from.facets) give(f, a);
        from.facets.clear();
      }
    }
    std::vector<std::int32_t> number(out_.list.size(), -1);
    std::size_t n = 0;
    for (std::size_t i = 0; i < out_.list.size(); ++i) {
      if (out_.list[i].facets.empty()) continue;
      number[i] = static_cast<std::int32_t>(n);
      if (n != i) {
        out_.list[n] = std::move(out_.list[i]);
        fits_[n] = fits_[i];
      }
      ++n;
    }
    out_.list.resize(n);
    fits_.resize(n);
    for (std::int32_t& f : out_.of) {
      if (f >= 0) f = number[static_cast<std::size_t>(f)];
    }
  }

  bool all_hold(const Fit& fit, const std::vector<std::int32_t>& list) const {
    return std::all_of(list.begin(), list.end(),
                       [&](std::int32_t f) { return holds(fit, facet(f)); });
  }

  void give(std::int32_t f, std::size_t band) {
    out_.of[static_cast<std::size_t>(f)] = static_cast<std::int32_t>(band);
    out_.list[band].facets.push_back(f);
  }

  /// Facets that stand alone between cuts, and slivers whose planes are noise.
  void take_lost() {
    std::size_t tests = 0;
    for (std::size_t f = 0; f < facets_.list.size(); ++f) {
      if (out_.of[f] >= 0 || out_.of_sphere[f] >= 0) continue;
      if (f % 64 == 0) context_.check();
      const Facet& g = facets_.list[f];
      if (thin(g)) {
        take_sliver(static_cast<std::int32_t>(f));
        continue;
      }
      for (std::size_t b = 0; b < fits_.size() && tests < kMostTests; ++b) {
        ++tests;
        if (!holds(fits_[b], g)) continue;
        give(static_cast<std::int32_t>(f), b);
        break;
      }
    }
  }

  bool thin(const Facet& f) const {
    double longest = 0;
    for (const std::uint32_t v : f.vertices) {
      longest = std::max(longest, glm::length(mesh_.positions[v] - f.center));
    }
    return f.area <= 8 * facets_.noise * longest;
  }

  void take_sliver(std::int32_t f) {
    const FacetLink* best = nullptr;
    for (const FacetLink& l : facet(f).links) {
      if (out_.of[static_cast<std::size_t>(l.facet)] < 0) continue;
      if (!best || l.length > best->length) best = &l;
    }
    if (best) give(f, static_cast<std::size_t>(out_.of[static_cast<std::size_t>(best->facet)]));
  }

  const TriMesh& mesh_;
  const Facets& facets_;
  const RunContext& context_;
  std::vector<Run> runs_;
  std::vector<std::vector<std::int32_t>> runs_of_;
  std::vector<Fit> fits_;
  Bands out_;
};

/// The facets that are no walls of outlines: the others have no area and no neighbours.
Facets without(const Facets& facets, const OutlineWalls& walls) {
  Facets left = facets;
  for (std::size_t f = 0; f < left.list.size(); ++f) {
    if (walls.of[f] < 0) continue;
    left.list[f].area = 0;
    left.list[f].links.clear();
  }
  return left;
}

/// What depends on all facets of a band.
void measure(const TriMesh& mesh, const Facets& facets, Band& band) {
  Patch& p = band.patch;
  double largest = 0;
  for (const std::int32_t f : band.facets) {
    for (const std::uint32_t v : facets.list[static_cast<std::size_t>(f)].vertices) {
      largest = std::max(largest, p.axis.profile(mesh.positions[v]).x);
    }
  }
  p.sagitta = largest * (1 - std::cos(0.5 * p.step));
  p.turn = 2 * std::asin(std::min(1.0, std::abs(p.normal.x) * std::sin(0.5 * p.step)));
  // A cone of less than a hundredth of a degree is a cylinder that was rounded.
  constexpr double kUpright = 1e-4;
  p.kind = std::abs(p.normal.y) < kUpright ? FaceKind::Cylinder : FaceKind::Cone;
}

}  // namespace

Bands find_bands(const TriMesh& mesh, const Facets& facets, const RunContext& context) {
  const OutlineWalls walls = find_outline_walls(mesh, facets, context);
  Bands bands = walls.patches.empty() ? Finder(mesh, facets, context).run()
                                      : Finder(mesh, without(facets, walls), context).run();
  for (Band& band : bands.list) measure(mesh, facets, band);
  const auto first = static_cast<std::int32_t>(bands.spheres.size());
  for (std::size_t f = 0; f < walls.of.size(); ++f) {
    if (walls.of[f] >= 0) bands.of_sphere[f] = first + walls.of[f];
  }
  std::ranges::copy(walls.patches, std::back_inserter(bands.spheres));
  return bands;
}

}  // namespace burin::recognised
