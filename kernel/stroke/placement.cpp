#include "placement.h"

#include <burin/base/rng.h>

#include <algorithm>
#include <cmath>
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
// A stroke from edge to edge may be shorter than the style's shortest, down to this share of the
// spacing: narrow faces would stay white.
constexpr double kNarrow = 1.0;

class Placement {
 public:
  Placement(const Picture& picture, Family& out, int family)
      : picture_(picture),
        out_(out),
        family_(family),
        tracer_(picture, out.grid, family),
        rng_(picture.options.seed, 0, static_cast<std::uint64_t>(family)) {}

  // A stroke through a point, if it keeps `share` of the spacing from all others and is long
  // enough.
  void start(std::int32_t part, const SurfacePoint& point, double share) {
    StrokeSample seed;
    if (!tracer_.seed(part, point, Vec3(0), seed) || !tracer_.free(part, seed, share)) return;
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
    const auto id = static_cast<std::int32_t>(out_.strokes.size());
    for (const StrokeSample& s : stroke.samples) {
      if (s.visible) out_.grid.insert(grid_sample(s, stroke.part, id));
    }
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
};

}  // namespace

Family place_family(const Picture& picture, const ViewRaster& raster,
                    const std::vector<Seed>& seeds, int family, const RunContext& context,
                    const std::function<void(double)>& progress) {
  Family out{{},
             SampleGrid(raster.origin, raster.pitch * Vec2(raster.nx, raster.ny),
                        picture.options.spacing_max)};
  Placement placement(picture, out, family);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (i % 16 == 0) {
      context.check();
      progress(static_cast<double>(i) / static_cast<double>(seeds.size()));
    }
    placement.start(seeds[i].part, seeds[i].point, kAnywhere);
    placement.fill_beside(context);
  }
  placement.fill_gaps(context);
  return out;
}

}  // namespace burin::detail
