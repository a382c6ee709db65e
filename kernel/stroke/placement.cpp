#include "placement.h"

#include <cmath>

namespace burin::detail {
namespace {

// Shares of the spacing that a new stroke keeps from all others: a neighbour set beside a stroke
// meets it to within rounding and the bend of the surface; a point of the coverage is anywhere.
constexpr double kBeside = 0.92;
constexpr double kAnywhere = 0.98;
// A stroke from edge to edge may be shorter than the style's shortest, down to this share of the
// spacing: narrow faces would stay white.
constexpr double kNarrow = 1.0;

class Placement {
 public:
  Placement(const Picture& picture, Family& out, int family)
      : picture_(picture), out_(out), family_(family), tracer_(picture, out.grid, family) {}

  void start(std::int32_t part, const SurfacePoint& point, double share) {
    StrokeSample seed;
    if (!tracer_.seed(part, point, family_, seed) || !tracer_.free(part, seed, share)) return;
    TracedStroke stroke = tracer_.trace(part, seed);
    if (family_ == 1 && narrow(stroke)) {
      // Across a narrow strip the strokes would be a fringe: go along it.
      StrokeSample along;
      if (tracer_.seed(part, point, 2, along)) {
        TracedStroke other = tracer_.trace(part, along);
        if (other.length() > 2 * stroke.length()) stroke = std::move(other);
      }
    }
    if (acceptable(stroke)) add(std::move(stroke));
  }

  // Candidates on both sides of each stroke placed since, until there are no more.
  void fill_beside(const RunContext& context) {
    for (; done_ < out_.strokes.size(); ++done_) {
      context.check();
      const std::size_t count = out_.strokes[done_].samples.size();
      for (std::size_t i = 0; i < count; i += 2) {
        for (const double side : {1.0, -1.0}) beside(done_, i, side);
      }
    }
  }

 private:
  bool narrow(const TracedStroke& s) const {
    return s.begin_reason == StrokeEnd::Edge && s.end_reason == StrokeEnd::Edge &&
           s.length() < 1.2 * picture_.options.length_min;
  }

  bool acceptable(const TracedStroke& s) const {
    const double length = s.length();
    if (s.samples.size() < 3) return false;
    if (length >= picture_.options.length_min) return true;
    return s.begin_reason == StrokeEnd::Edge && s.end_reason == StrokeEnd::Edge &&
           length >= kNarrow * picture_.options.spacing_max;
  }

  void add(TracedStroke stroke) {
    const auto id = static_cast<std::int32_t>(out_.strokes.size());
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
      const StrokeSample& s = stroke.samples[i];
      if (s.visible)
        out_.grid.insert(grid_sample(s, stroke.part, id, static_cast<std::int32_t>(i)));
    }
    out_.strokes.push_back(std::move(stroke));
  }

  void beside(std::size_t stroke, std::size_t index, double side) {
    // Copies: `start` may grow the list of strokes.
    const std::int32_t part = out_.strokes[stroke].part;
    const StrokeSample s = out_.strokes[stroke].samples[index];
    if (!s.visible || s.facing < 0.1) return;
    const Surface& surface = picture_.surface(part);
    const Vec3 across = side * glm::cross(s.normal, s.tangent);
    const double d = tracer_.spacing(s);
    const double speed =
        std::abs(cross2(s.direction, picture_.camera.velocity(s.point.position, across)));
    if (speed < 0.1 * picture_.camera.scale_at(s.point.position)) return;
    double length = d / speed;
    MarchStep step = surface.march(s.point, across, length);
    if (step.stop != MarchStop::Completed) return;
    const double reached =
        std::abs(cross2(s.direction, picture_.camera.to_paper(step.end.position) - s.paper));
    if (reached < 0.5 * d) return;  // bent away from the viewer
    length *= d / reached;
    step = surface.march(s.point, across, length);
    if (step.stop == MarchStop::Completed) start(part, step.end, kBeside);
  }

  const Picture& picture_;
  Family& out_;
  int family_;
  Tracer tracer_;
  std::size_t done_ = 0;

 public:
  static constexpr double anywhere() { return kAnywhere; }
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
    placement.start(seeds[i].part, seeds[i].point, Placement::anywhere());
    placement.fill_beside(context);
  }
  return out;
}

}  // namespace burin::detail
