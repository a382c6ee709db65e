#include "placement.h"

#include <burin/base/parallel.h>
#include <burin/base/rng.h>

#include "shared_progress.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

// Shares of the spacing that a new stroke keeps from all others: a neighbour set beside a stroke
// meets it to within rounding and the bend of the surface; a point of the coverage is anywhere.
constexpr double kBeside = 0.92;
constexpr double kAnywhere = 0.98;
// Between two strokes that run apart a third one fits once their gap has grown to this many
// spacings; it keeps half the gap, less rounding.
constexpr double kGap = 1.5;
constexpr double kInGap = 0.47 * kGap;
// Share of the spacing that a place beside a stroke may be off: a fraction of what is left to
// chance anyway.
constexpr double kNearEnough = 0.02;
// A stroke from edge to edge may be shorter than the style's shortest, down to this share of the
// spacing: narrow faces would stay white.
constexpr double kNarrow = 1.0;

// A smooth region of a part that is to be hatched.
struct Region {
  std::int32_t part = -1, region = -1;
  std::vector<const Seed*> seeds;
  Box2 box;  // where it is seen
};

void insert_visible(SampleGrid& grid, const TracedStroke& stroke, std::int32_t id) {
  for (const StrokeSample& s : stroke.samples) {
    if (s.visible) grid.insert(grid_sample(s, stroke.part, id));
  }
}

// Strokes keep their distance only where they are on one sheet. A region so folded, or a surface so
// broken, that no two places of it count as one sheet could be filled without end: no more than as
// many layers of the densest strokes are laid.
constexpr double kMostInk = 8;

class Placement {
 public:
  Placement(const Picture& picture, Family& out, int family, const Region& region)
      : picture_(picture),
        out_(out),
        family_(family),
        tracer_(picture, out.grid, family),
        rng_(picture.seed, static_cast<std::uint64_t>(region.part),
             2 * static_cast<std::uint64_t>(region.region) + static_cast<std::uint64_t>(family)),
        most_(kMostInk * (1 + region.box.size().x) * (1 + region.box.size().y) /
              picture.options.spacing_min) {}

  // A stroke through a point, if it keeps `share` of the spacing from all others and is long
  // enough.
  void start(std::int32_t part, const SurfacePoint& point, double share) {
    if (drawn_ > most_) return;
    StrokeSample seed;
    if (!tracer_.seed(part, point, Vec3(0), seed) || !tracer_.free(part, seed, share)) return;
    if (!picture_.seen(part, seed.face, seed.paper, seed.depth)) return;
    TracedStroke stroke = tracer_.trace(part, seed, reach());
    if (family_ == 1 && narrow(stroke)) {
      // Across a narrow strip the strokes would be a fringe: go along it.
      StrokeSample along;
      if (tracer_.seed(part, point, glm::cross(seed.normal, seed.tangent), along)) {
        TracedStroke other = tracer_.trace(part, along, reach());
        if (other.length() > 2 * stroke.length()) stroke = std::move(other);
      }
    }
    if (acceptable(stroke)) add(std::move(stroke));
  }

  // Candidates on both sides of each stroke placed since, until there are no more.
  void fill_beside(const RunContext& context) {
    for (; done_ < out_.strokes.size(); ++done_) {
      context.check();
      for (const double side : {1.0, -1.0}) {
        for (const SurfacePoint& at : widest_first(done_, side)) {
          start(out_.strokes[done_].part, at, kBeside);
        }
      }
    }
  }

  // A stroke in the middle of every gap that is too wide for the tone and too narrow for
  // `fill_beside`.
  void fill_gaps(const RunContext& context) {
    for (std::size_t stroke = 0; stroke < out_.strokes.size(); ++stroke) {
      context.check();
      const std::size_t count = out_.strokes[stroke].samples.size();
      for (std::size_t i = 1; i + 1 < count; i += 3) {
        const StrokeSample s = out_.strokes[stroke].samples[i];
        if (!s.visible) continue;
        const double d = tracer_.spacing(s);
        const auto gap = out_.grid.sides(
            grid_sample(s, out_.strokes[stroke].part, static_cast<std::int32_t>(stroke)), 2.2 * d);
        for (const double side : {1.0, -1.0}) {
          const double width = side > 0 ? gap.left : gap.right;
          if (width > kGap * d && width < 2.1 * d) {
            const auto at = offset(out_.strokes[stroke].part, s, side, 0.5 * width);
            if (at) start(out_.strokes[stroke].part, *at, kInGap);
          }
        }
      }
    }
  }

 private:
  // Half the longest stroke, drawn anew for each by a third either way: ends of equal strokes would
  // line up to a white band.
  double reach() const {
    const double dice = rng_.uniform(out_.strokes.size());
    return 0.5 * picture_.options.length_max * (2.0 / 3 + 2.0 / 3 * dice);
  }

  bool narrow(const TracedStroke& s) const {
    return s.begin_reason == StrokeEnd::Edge && s.end_reason == StrokeEnd::Edge &&
           s.length() < 1.2 * picture_.options.length_min;
  }

  bool acceptable(const TracedStroke& s) const {
    const double length = s.length();
    if (s.samples.size() < 3) return false;
    if (length >= picture_.options.length_min) return true;
    const auto bounded = [](StrokeEnd e) { return e == StrokeEnd::Edge || e == StrokeEnd::Away; };
    return bounded(s.begin_reason) && bounded(s.end_reason) &&
           length >= kNarrow * picture_.options.spacing_max;
  }

  void add(TracedStroke stroke) {
    insert_visible(out_.grid, stroke, static_cast<std::int32_t>(out_.strokes.size()));
    drawn_ += stroke.length();
    out_.strokes.push_back(std::move(stroke));
  }

  // The places beside every second visible sample, from where the lines of the field run widest
  // apart to where they run closest: a neighbour set at the widest place keeps no more than the
  // spacing everywhere, and ends where it comes too close. Set elsewhere, it would leave gaps of up
  // to twice the spacing.
  std::vector<SurfacePoint> widest_first(std::size_t stroke, double side) const {
    const TracedStroke& line = out_.strokes[stroke];
    struct Place {
      double width;
      std::size_t order;
      SurfacePoint point;
    };
    std::vector<Place> places;
    double log_width = 0;  // of the strip between this line of the field and a close one
    for (std::size_t i = 0; i < line.samples.size(); i += 2) {
      const StrokeSample& s = line.samples[i];
      if (!s.visible) continue;
      const double d = tracer_.spacing(s);
      const auto at = offset(line.part, s, side, d);
      if (!at) continue;
      if (const auto there = tracer_.direction(line.part, *at, s.tangent)) {
        const double step = i > 1 ? glm::length(s.paper - line.samples[i - 2].paper) : 0;
        log_width += step * side * cross2(s.direction, *there) / d;
      }
      places.push_back({-log_width, i, *at});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return std::pair(a.width, a.order) < std::pair(b.width, b.order);
    });
    std::vector<SurfacePoint> points;
    points.reserve(places.size());
    for (const Place& p : places) points.push_back(p.point);
    return points;
  }

  // The surface point `d` paper mm across a sample to the left (side = 1) or right (-1).
  std::optional<SurfacePoint> offset(std::int32_t part, const StrokeSample& s, double side,
                                     double d) const {
    if (s.facing < 0.1) return std::nullopt;
    const Surface& surface = picture_.surface(part);
    Vec3 across = glm::cross(s.normal, s.tangent);
    double speed = cross2(s.direction, picture_.camera.velocity(s.point.position, across));
    if (speed < 0) {
      across = -across;
      speed = -speed;
    }
    if (speed < 0.1 * picture_.camera.scale_at(s.point.position)) return std::nullopt;
    double length = d / speed;
    MarchStep step = surface.march(s.point, side * across, length);
    if (step.stop != MarchStop::Completed) return std::nullopt;
    const double reached =
        side * cross2(s.direction, picture_.camera.to_paper(step.end.position) - s.paper);
    if (reached < 0.5 * d) return std::nullopt;  // bent away from the viewer
    if (std::abs(reached - d) < kNearEnough * d) return step.end;
    length *= d / reached;
    step = surface.march(s.point, side * across, length);
    if (step.stop != MarchStop::Completed) return std::nullopt;
    return step.end;
  }

  const Picture& picture_;
  Family& out_;
  int family_;
  Tracer tracer_;
  Rng rng_;
  std::size_t done_ = 0;
  // Paper mm of strokes so far, and at the most.
  double drawn_ = 0, most_ = 0;
};

// The seeds of each region that has any, in their order; regions by part and number.
std::vector<Region> regions_of(const Picture& picture, const ViewRaster& raster,
                               const std::vector<Seed>& seeds) {
  std::map<std::pair<std::int32_t, std::int32_t>, Region> found;
  for (const Seed& seed : seeds) {
    const Surface& surface = picture.surface(seed.part);
    const std::int32_t region = surface.proxy().face_region[surface.to_proxy(seed.point).face];
    Region& r = found[{seed.part, region}];
    r.part = seed.part;
    r.region = region;
    r.seeds.push_back(&seed);
  }
  for (std::int32_t y = 0; y < raster.ny; ++y) {
    for (std::int32_t x = 0; x < raster.nx; ++x) {
      const RasterCell& cell = raster.at(x, y);
      if (cell.part < 0) continue;
      const auto it = found.find({cell.part, cell.region});
      if (it != found.end()) it->second.box.add(raster.center(x, y));
    }
  }
  std::vector<Region> regions;
  for (auto& [key, region] : found) {
    if (region.box.empty()) {  // seen between the cells of the raster only
      for (const Seed* seed : region.seeds) {
        region.box.add(picture.camera.to_paper(seed->point.position));
      }
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

Family place_region(const Picture& picture, const Region& region, int family,
                    const RunContext& context, const std::function<void(std::size_t)>& done) {
  constexpr std::size_t kReportEvery = 16;  // seeds
  Family out{{}, SampleGrid(region.box.min, region.box.size(), picture.options.spacing_max)};
  Placement placement(picture, out, family, region);
  for (std::size_t i = 0; i < region.seeds.size(); ++i) {
    if (i % kReportEvery == 0) {
      context.check();
      done(std::min(kReportEvery, region.seeds.size() - i));
    }
    placement.start(region.part, region.seeds[i]->point, kAnywhere);
    placement.fill_beside(context);
  }
  placement.fill_gaps(context);
  return out;
}

}  // namespace

std::vector<Family> place_families(const Picture& picture, const ViewRaster& raster,
                                   const std::vector<Seed>& seeds, int families,
                                   const RunContext& context,
                                   const std::function<void(double)>& progress) {
  const std::vector<Region> regions = regions_of(picture, raster, seeds);
  struct Task {
    std::size_t family, region;
  };
  std::vector<Task> tasks;
  for (std::size_t f = 0; f < static_cast<std::size_t>(families); ++f) {
    for (std::size_t r = 0; r < regions.size(); ++r) tasks.push_back({f, r});
  }
  // The longest first: none is left over when the other cores have nothing more to do.
  std::ranges::stable_sort(tasks, std::greater(),
                           [&](const Task& t) { return regions[t.region].seeds.size(); });
  const SampleGrid none({0, 0}, {0, 0}, 1);
  std::vector<Family> placed(tasks.size(), Family{{}, none});
  SharedProgress done(static_cast<double>(seeds.size()) * families, progress);
  const auto report = [&](std::size_t count) { done.add(count); };
  parallel_for(
      tasks.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          placed[t] = place_region(picture, regions[tasks[t].region],
                                   static_cast<int>(tasks[t].family) + 1, context, report);
        }
      },
      &context);
  // One family each again, in the order of the regions, with a grid of all of its strokes.
  std::vector<std::size_t> order(tasks.size());
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    order[tasks[t].family * regions.size() + tasks[t].region] = t;
  }
  std::vector<Family> out;
  for (std::size_t f = 0; f < static_cast<std::size_t>(families); ++f) {
    out.push_back({{},
                   SampleGrid(raster.origin, raster.pitch * Vec2(raster.nx, raster.ny),
                              picture.options.spacing_max)});
    for (std::size_t r = 0; r < regions.size(); ++r) {
      for (TracedStroke& stroke : placed[order[f * regions.size() + r]].strokes) {
        const auto id = static_cast<std::int32_t>(out[f].strokes.size());
        insert_visible(out[f].grid, stroke, id);
        out[f].strokes.push_back(std::move(stroke));
      }
    }
  }
  return out;
}

}  // namespace burin::detail
