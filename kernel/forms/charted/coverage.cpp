#include <burin/base/parallel.h>
#include <burin/forms/charted/coverage.h>

#include "coverage_candidates.h"
#include "dart_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace burin {
namespace {

/// A candidate's R was larger than the bound that it was held against.
struct BoundExceeded {
  double area;
};

constexpr std::size_t kCoverageGrain = 256;
constexpr double kLeastDensity = 0.01, kLargestDisc = 4;

/// Draws candidates in order, many at a time, and hands on those that Algorithm 1 keeps.
class Draw {
 public:
  Draw(const Candidates& candidates, double bound, Candidates::Stream stream,
       const RunContext& context)
      : candidates_(candidates), bound_(bound), stream_(stream), context_(context) {}

  std::size_t drawn() const { return drawn_; }

  /// Goes on for at most `block` candidates; `take` gives false to end with the one it was given.
  template <class Take>
  void go_on(std::size_t block, Take take) {
    results_.resize(block);
    parallel_for(
        block, kCoverageGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            results_[k] = candidates_.draw(drawn_ + k, bound_, stream_);
          }
        },
        &context_);
    for (const Candidates::Result& r : results_) {
      if (r.area > bound_) throw BoundExceeded{r.area};
      const std::uint64_t index = drawn_++;
      if (r.kept && !take(index, r)) return;
    }
  }

 private:
  const Candidates& candidates_;
  double bound_;
  Candidates::Stream stream_;
  const RunContext& context_;
  std::size_t drawn_ = 0;
  std::vector<Candidates::Result> results_;
};

/// Where distances between points are taken: in space, or on paper a sheet.
struct Spot {
  Vec3 key{0};
  bool front = true;
  double depth = 0;
};

Spot spot(const CoverageOptions& o, const CoveragePoint& p) {
  if (o.norm != CoverageNorm::Picture) return {p.position, true, 0};
  const Vec2 q = o.camera->to_paper(p.position);
  return {Vec3(q, 0), glm::dot(p.normal, o.camera->to_viewer(p.position)) >= 0,
          o.camera->depth(p.position) * o.camera->scale_at(p.position)};
}

class Cover {
 public:
  Cover(const Candidates& candidates, const CoverageOptions& options, double bound,
        const RunContext& context)
      : candidates_(candidates),
        options_(options),
        context_(context),
        bound_(bound),
        draw_(candidates, bound, Candidates::Points, context) {}

  Coverage run() {
    if (options_.spacing > 0) {
      discs();
    } else {
      independent();
    }
    if (options_.measure && !result_.points.empty()) measure();
    return std::move(result_);
  }

 private:
  void add(std::uint64_t candidate, const CoveragePoint& p) {
    result_.points.push_back(p);
    result_.candidates = candidate + 1;
  }

  void independent() {
    // A density that is zero nearly everywhere has to end, too.
    const std::size_t limit = 100'000 + 1000 * options_.count;
    std::size_t block = 2 * options_.count;
    while (result_.points.size() < options_.count && draw_.drawn() < limit) {
      draw_.go_on(std::clamp<std::size_t>(block, 64, 1 << 16),
                  [&](std::uint64_t i, const Candidates::Result& r) {
                    if (accepted(i, r)) add(i, r.point);
                    return result_.points.size() < options_.count;
                  });
      // As many as should do, by the share kept so far.
      const std::size_t missing = options_.count - result_.points.size();
      block = (missing + 16) * draw_.drawn() / std::max<std::size_t>(result_.points.size(), 1);
    }
    if (result_.points.size() < options_.count) result_.candidates = draw_.drawn();
  }

  bool accepted(std::uint64_t i, const Candidates::Result& r) const {
    return !options_.density || candidates_.coin(i) < r.density;
  }

  double disc(double density) const {
    return options_.spacing * std::min(kLargestDisc, 1 / std::sqrt(density));
  }

  void discs() {
    DartGrid grid(options_.spacing, 1024);
    std::size_t tried = 0, round = 1024, before = 0;
    const auto enough = [&] { return result_.points.size() >= options_.count; };
    // Rounds of four darts a disc; done when one adds no more than two in a thousand.
    const std::size_t limit = 100'000 + 1000 * options_.count;
    while (!enough() && draw_.drawn() < limit) {
      draw_.go_on(std::min<std::size_t>(2 * round, 1 << 15),
                  [&](std::uint64_t i, const Candidates::Result& r) {
                    ++tried;
                    if (r.density >= kLeastDensity) throw_dart(grid, i, r);
                    return !enough();
                  });
      if (tried < round) continue;
      const std::size_t points = result_.points.size();
      if (points - before <= points / 500) break;
      before = points;
      tried = 0;
      round = std::max<std::size_t>(1024, 4 * points);
    }
    if (!enough()) result_.candidates = draw_.drawn();
  }

  void throw_dart(DartGrid& grid, std::uint64_t i, const Candidates::Result& r) {
    const Spot here = spot(options_, r.point);
    const double radius = disc(r.density);
    const bool taken = grid.any_within(here.key, radius, [&](std::int32_t other, double) {
      const Spot& there = spots_[static_cast<std::size_t>(other)];
      return same_sheet(here, there, options_.spacing);
    });
    if (taken) return;
    grid.add(here.key);
    spots_.push_back(here);
    add(i, r.point);
  }

  /// Depths of a sheet differ little between neighbours: 16 spacings leave room for slopes of 86
  /// degrees against the paper.
  static bool same_sheet(const Spot& a, const Spot& b, double spacing) {
    return a.front == b.front && std::abs(a.depth - b.depth) <= 16 * spacing;
  }

  void measure() {
    const std::size_t n = result_.points.size();
    const double cell =
        std::sqrt(candidates_.mean_measure() * candidates_.domain_area() / static_cast<double>(n));
    DartGrid grid(cell > 0 ? cell : 1, n);
    spots_.clear();
    for (const CoveragePoint& p : result_.points) {
      spots_.push_back(spot(options_, p));
      grid.add(spots_.back().key);
    }
    std::vector<CoveragePoint> places;
    const std::size_t wanted = std::max<std::size_t>(512, 8 * n), limit = 1000 * wanted;
    Draw draw(candidates_, bound_, Candidates::Checks, context_);
    while (places.size() < wanted && draw.drawn() < limit) {
      draw.go_on(std::min<std::size_t>(2 * wanted, 1 << 16),
                 [&](std::uint64_t, const Candidates::Result& r) {
                   if (r.density >= kLeastDensity) places.push_back(r.point);
                   return places.size() < wanted;
                 });
    }
    result_.measured_at = places.size();
    result_.covering_radius = farthest(grid, places);
  }

  double farthest(const DartGrid& grid, const std::vector<CoveragePoint>& places) const {
    std::vector<double> far((places.size() + kCoverageGrain - 1) / kCoverageGrain, 0.0);
    parallel_for(
        places.size(), kCoverageGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            const Spot here = spot(options_, places[k]);
            const double d = grid.nearest(here.key, [&](std::int32_t i) {
              return spots_[static_cast<std::size_t>(i)].front == here.front;
            });
            far[begin / kCoverageGrain] = std::max(far[begin / kCoverageGrain], d);
          }
        },
        &context_);
    return far.empty() ? 0 : *std::max_element(far.begin(), far.end());
  }

  const Candidates& candidates_;
  const CoverageOptions& options_;
  const RunContext& context_;
  double bound_;
  Draw draw_;
  std::vector<Spot> spots_;
  Coverage result_;
};

}  // namespace

Coverage cover_chart(const Chart& chart, const CoverageOptions& options,
                     const RunContext& context) {
  const Candidates candidates(chart, options);
  AreaBound bound;
  if (options.norm != CoverageNorm::Parameters) {
    bound = area_bound(chart, context);
    // Nothing to cover: every place is degenerate.
    if (!(bound.value > 0) || !std::isfinite(bound.value)) {
      Coverage nothing;
      nothing.bound = bound;
      return nothing;
    }
  } else {
    bound.value = std::numeric_limits<double>::infinity();
    bound.proved = true;
  }
  while (true) {
    try {
      Coverage result = Cover(candidates, options, bound.value, context).run();
      result.bound = bound;
      return result;
    } catch (const BoundExceeded& more) {
      bound.attained = more.area;
      bound.value = 1.05 * more.area;
      bound.proved = false;
    }
  }
}

}  // namespace burin
