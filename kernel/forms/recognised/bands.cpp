#include "bands.h"

#include "balls.h"
#include "outlines.h"
#include "runs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace burin::recognised {
namespace {

// Tests of lost facets against bands.
constexpr std::size_t kMostTests = 20'000'000;

/// Makes bands and spheres of runs.
class BandFinder {
 public:
  BandFinder(const TriMesh& mesh, const Facets& facets, const RunContext& context)
      : mesh_(mesh), facets_(facets), context_(context), finder_(mesh, facets) {}

  Bands run() {
    runs_ = finder_.find(context_);
    take_spheres();
    claim();
    join();
    take_lost();
    return std::move(out_);
  }

 private:
  const Facet& facet(std::int32_t f) const { return facets_.list[static_cast<std::size_t>(f)]; }

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
      if (2 * run.facets.size() < before || !finder_.enough(run)) continue;
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
                       [&](std::int32_t f) { return finder_.holds(fit, facet(f)); });
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
        if (!finder_.holds(fits_[b], g)) continue;
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
  RunFinder finder_;
  std::vector<Run> runs_;
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
  Bands bands = walls.patches.empty() ? BandFinder(mesh, facets, context).run()
                                      : BandFinder(mesh, without(facets, walls), context).run();
  for (Band& band : bands.list) measure(mesh, facets, band);
  const auto first = static_cast<std::int32_t>(bands.spheres.size());
  for (std::size_t f = 0; f < walls.of.size(); ++f) {
    if (walls.of[f] >= 0) bands.of_sphere[f] = first + walls.of[f];
  }
  std::ranges::copy(walls.patches, std::back_inserter(bands.spheres));
  return bands;
}

}  // namespace burin::recognised
