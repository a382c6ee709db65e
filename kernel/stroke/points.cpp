#include "points.h"

#include <burin/base/parallel.h>
#include <burin/base/rng.h>

#include "motif_strokes.h"
#include "sample_grid.h"
#include "shared_progress.h"
#include "tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace burin::detail {
namespace {

// Seen points that are tried for each disc: more add few.
constexpr double kDarts = 4;
// Tried so often, discs of diameter d fill a plane with about so many points in d^2.
constexpr double kPacking = 0.52;
// Times that more points are asked for, twice as many each, where too few of a part are seen.
constexpr int kPointRounds = 4;
// Points that are asked for beyond what a part needs on average, so that one round mostly does.
constexpr double kSpare = 1.1;

// Points that a surface is asked for at a time: some 300 MB.
constexpr double kMostAsked = 4e6;

// Paper mm of what stands on a point, on average.
double mean_length(const Picture& picture) {
  const HatchOptions& o = picture.options;
  if (picture.motif) return o.length * picture.motif->length;
  return o.length - std::min(o.taper, 0.4 * o.length);
}

// Paper mm: the length of a dot, which only says that it is a line.
constexpr double kDot = 0.02;

// Points a paper mm2 for strokes that are to cover a share `ink` of it. Dots that would come too
// near each other grow instead; motifs have wider lines, as wide as their own size apart.
double density(const Picture& picture, double ink) {
  const HatchOptions& o = picture.options;
  if (!(ink >= o.tone_min && ink > 0)) return 0;
  const double width = picture.free_width(ink);
  const auto clear = [](double apart) { return kPacking / (apart * apart); };
  if (picture.dots()) {
    return std::min(picture.laid(ink) / dot_area(width), clear(o.spacing_min));
  }
  const double many = picture.laid(ink) / (width * mean_length(picture));
  const bool motifs_clear =
      picture.motif && picture.placement_kind == Picture::PlacementKind::Discs;
  return motifs_clear ? std::min(many, clear(std::max(o.length, o.spacing_min))) : many;
}

bool is_inked(const Picture& picture, const Seed& seed, const StrokeSample& at) {
  const double ink = picture.share(at.darkness, seed.family);
  return ink > 0 && ink >= picture.options.tone_min;
}

// The dot at a seed; nothing where the surface turns away.
std::optional<TracedStroke> dot_at(const Picture& picture, const Seed& seed) {
  const Surface& surface = picture.surface(seed.part);
  const auto sample = [&](const SurfacePoint& point, StrokeSample& out) {
    const Frame frame = surface.frame(point);
    out.tangent = any_orthogonal(frame.normal);
    look_at(picture, seed.part, point, frame, out);
  };
  StrokeSample a, b;
  sample(seed.point, a);
  if (!may_begin(picture, a)) return std::nullopt;
  if (picture.laws->shape_picture() && !is_inked(picture, seed, a)) return std::nullopt;
  const double length = kDot / picture.camera.scale_at(seed.point.position);
  // At an edge it goes the other way.
  for (const double sign : {1.0, -1.0}) {
    const MarchStep step = surface.march(seed.point, sign * a.tangent, length);
    if (step.stop != MarchStop::Completed) continue;
    sample(step.end, b);
    TracedStroke dot;
    dot.part = seed.part;
    dot.samples = {a, b};
    dot.begin_reason = dot.end_reason = StrokeEnd::Edge;  // no taper
    return dot;
  }
  return std::nullopt;
}

// What a part shows: paper mm2, the points that its strokes of one family ask for, and the most
// that a mm2 of its surface gets, in points a paper mm2 seen square on.
struct VisiblePart {
  double area = 0, points = 0, densest = 0;
};

std::vector<VisiblePart> visible_by_part(const Picture& picture, const ViewRaster& raster,
                                         int family) {
  std::vector<VisiblePart> shown(picture.surfaces.size());
  const double cell = raster.pitch * raster.pitch;
  for (const RasterCell& c : raster.cells) {
    if (c.part < 0) continue;
    VisiblePart& s = shown[static_cast<std::size_t>(c.part)];
    s.area += cell;
    const double many = c.denser * density(picture, picture.share(c.darkness, family));
    s.points += cell * many;
    s.densest = std::max(s.densest, many * c.facing);
  }
  return shown;
}

// The largest area on paper that a model mm2 of a part has.
double largest_scale(const Surface& surface, const Camera& camera) {
  const auto& positions = surface.proxy().mesh.positions;
  if (!camera.perspective()) return camera.area_scale(positions.front());
  double most = 0;
  for (const Vec3& p : positions) most = std::max(most, camera.area_scale(p));
  return most;
}

// A triangle of a closed part that faces away is never seen.
void skip_what_turns_away(const Camera& camera, CoverRequest& request) {
  request.among = [&camera, all = request.among](Vec3 a, Vec3 b, Vec3 c) {
    return glm::dot(glm::cross(b - a, c - a), camera.to_viewer(a)) > 0 && (!all || all(a, b, c));
  };
}

// Points of one family, part by part.
class PointCover {
 public:
  PointCover(const Picture& picture, const ViewRaster& raster, bool discs, int family,
             SampleGrid& grid, Coverage& out, const RunContext& context)
      : picture_(picture),
        raster_(raster),
        discs_(discs),
        family_(family),
        grid_(grid),
        out_(out),
        context_(context) {}

  void run() {
    const std::vector<VisiblePart> shown = visible_by_part(picture_, raster_, family_);
    for (std::size_t part = 0; part < shown.size(); ++part) {
      if (shown[part].points > 0) cover(static_cast<std::int32_t>(part), shown[part]);
    }
  }

 private:
  // Asks the surface for so many points that enough of them are seen.
  void cover(std::int32_t part, const VisiblePart& shown) {
    const Surface& surface = picture_.surface(part);
    const Box2 box = box_of(raster_);
    const double sheets = projected_area(surface, picture_.camera, box) / shown.area;
    const double most = std::max(1.0, kMostSheets * box.size().x * box.size().y / shown.area);
    const auto wanted =
        static_cast<std::size_t>(std::ceil((discs_ ? kDarts : 1) * std::max(1.0, shown.points)));
    CoverRequest request = request_of(picture_, part, box);
    request.seed += static_cast<std::uint64_t>(family_ - 1);
    request.weight = weight(part, shown.densest);
    if (!is_two_sided(surface)) skip_what_turns_away(picture_.camera, request);
    request.count = static_cast<std::size_t>(
        std::min(kMostAsked, kSpare * static_cast<double>(wanted) * std::clamp(sheets, 1.0, most)));
    std::size_t seen = 0, begin = 0;
    for (int round = 0; round < kPointRounds && seen < wanted; ++round) {
      const std::vector<SurfacePoint> points = surface.cover(request, context_);
      take(part, points, begin, wanted, seen);
      if (points.size() == begin) break;  // there are no more
      if (2 * static_cast<double>(request.count) > kMostAsked) break;
      // The same points come first again.
      begin = points.size();
      request.count *= 2;
    }
    // One in ten is what the tone can spare.
    if (10 * seen < 9 * wanted && wanted > kFew) ++out_.thinned_parts;
  }

  std::function<double(Vec3, Vec3)> weight(std::int32_t part, double densest) const {
    const double largest = largest_scale(picture_.surface(part), picture_.camera);
    return weight_in_picture(
        picture_, raster_, part,
        [=, this](Vec3 position, double darkness, double facing, double denser) {
          const double wanted = facing * denser * asked(darkness) / (kMissed * densest);
          return picture_.camera.area_scale(position) / largest * std::min(1.0, wanted);
        });
  }

  // Points a paper mm2.
  double asked(double darkness) const {
    return density(picture_, picture_.share(darkness, family_));
  }

  // From `begin` on, until `wanted` points have been seen.
  void take(std::int32_t part, const std::vector<SurfacePoint>& points, std::size_t begin,
            std::size_t wanted, std::size_t& seen) {
    constexpr std::size_t kGrain = 128;
    if (begin >= points.size()) return;
    std::vector<GridSample> samples(points.size() - begin);
    std::vector<std::uint8_t> visible(samples.size());
    std::vector<double> keeps(discs_ ? samples.size() : 0);  // distance to all others
    parallel_for(
        samples.size(), kGrain,
        [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            const PointOnPaper at = on_paper(picture_, part, points[begin + i]);
            samples[i] = at.sample;
            visible[i] = picture_.seen(part, at.face, at.sample.paper, at.sample.depth) ? 1 : 0;
            if (discs_ && visible[i]) keeps[i] = diameter(part, points[begin + i]);
          }
        },
        &context_);
    for (std::size_t i = 0; i < samples.size() && seen < wanted; ++i) {
      if (!visible[i]) continue;
      ++seen;
      if (discs_ && taken(samples[i], keeps[i])) continue;
      grid_.insert(samples[i]);
      out_.seeds.push_back({part, points[begin + i], family_});
    }
  }

  bool taken(const GridSample& sample, double diameter) const {
    return !std::isfinite(diameter) || grid_.nearest(sample, diameter) < diameter;
  }

  // Of a disc; infinite where no ink is asked for.
  double diameter(std::int32_t part, const SurfacePoint& point) const {
    const Surface& surface = picture_.surface(part);
    const Frame frame = surface.frame(point);
    const double cosine = glm::dot(frame.normal, picture_.camera.to_viewer(point.position));
    const double many =
        picture_.denser(part, point, frame) *
        asked(picture_.darkness(part, surface.proxy().face_region[surface.to_proxy(point).face],
                                point, frame, cosine));
    return many > 0 ? std::sqrt(kPacking / many) : std::numeric_limits<double>::infinity();
  }

  static constexpr std::size_t kFew = 16;
  // What is darker than every cell of the raster, but by less than this, gets what it asks for.
  static constexpr double kMissed = 1.1;

  const Picture& picture_;
  const ViewRaster& raster_;
  bool discs_;
  int family_;
  SampleGrid& grid_;
  Coverage& out_;
  const RunContext& context_;
};

Coverage cover(const Picture& picture, const ViewRaster& raster, bool discs,
               const RunContext& context) {
  // As far apart as points are where the tone is lightest.
  const double apart = std::clamp(1 / std::sqrt(density(picture, picture.options.tone_min)),
                                  picture.options.width_min, picture.options.spacing_max);
  const auto grid = [&] {
    return SampleGrid(raster.origin, raster.pitch * Vec2(raster.nx, raster.ny), apart);
  };
  Coverage out;
  SampleGrid first = grid();
  PointCover(picture, raster, discs, 1, first, out, context).run();
  out.delta = measure_delta(picture, raster, first, apart, 4 * apart, context);
  if (picture.options.cross_from <= 1) {
    SampleGrid second = grid();
    PointCover(picture, raster, discs, 2, second, out, context).run();
  }
  out.points = static_cast<std::int64_t>(out.seeds.size());
  return out;
}

// The strokes that `make` gives for each of the seeds by number, by family, in their order.
template <class Make>
std::vector<Family> on_each(const std::vector<Seed>& seeds, int families, const RunContext& context,
                            const std::function<void(double)>& progress, const Make& make) {
  constexpr std::size_t kGrain = 32;
  std::vector<std::vector<TracedStroke>> strokes(seeds.size());
  SharedProgress done(static_cast<double>(seeds.size()), progress);
  parallel_for(
      seeds.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) make(i, strokes[i]);
        done.add(end - begin);
      },
      &context);
  std::vector<Family> out(static_cast<std::size_t>(families),
                          Family{{}, SampleGrid({0, 0}, {0, 0}, 1)});
  for (std::vector<TracedStroke>& of_seed : strokes) {
    for (TracedStroke& stroke : of_seed) {
      out[static_cast<std::size_t>(stroke.family - 1)].strokes.push_back(std::move(stroke));
    }
  }
  return out;
}

// What the law of length makes of a stroke.
double longer(const Picture& picture, const Seed& seed, const StrokeSample& at, std::size_t i) {
  constexpr double kMost = 10;
  const Surface& surface = picture.surface(seed.part);
  const double random = Laws::random(picture.seed, seed.part, seed.family, kLengthLaw, i);
  const Frame frame = surface.frame(seed.point);
  const LawPlace place{
      seed.part, seed.point, frame, at.facing, picture.share(at.darkness, seed.family), random};
  return std::clamp(picture.laws->length.at(place, surface, picture.field, 1), 0.0, kMost);
}

// What a kind from elsewhere draws on a seed.
Motif mark_at(const Picture& picture, const Seed& seed, const StrokeSample& at, std::size_t i) {
  constexpr std::uint64_t kMark = 5;  // of the streams of Laws::random
  return motif_of((*picture.marks)({seed.point.position, at.front ? at.normal : -at.normal,
                                    at.tangent, picture.share(at.darkness, seed.family),
                                    Laws::random(picture.seed, seed.part, seed.family, kMark, i)}));
}

}  // namespace

Coverage cover_points(const Picture& picture, const ViewRaster& raster, const RunContext& context) {
  return cover(picture, raster, false, context);
}

Coverage cover_discs(const Picture& picture, const ViewRaster& raster, const RunContext& context) {
  return cover(picture, raster, true, context);
}

std::vector<Family> place_on_points(const Picture& picture, const ViewRaster& /*raster*/,
                                    const std::vector<Seed>& seeds, int families,
                                    const RunContext& context,
                                    const std::function<void(double)>& progress) {
  const auto stroke = [&](std::size_t i, std::vector<TracedStroke>& out) {
    const Seed& seed = seeds[i];
    const Tracer tracer(picture, seed.family);
    StrokeSample at;
    if (!tracer.seed(seed.part, seed.point, Vec3(0), at)) return;
    // The weight of the coverage knows of laws to within a cell of the raster.
    if (picture.laws->shape_picture() && !is_inked(picture, seed, at)) return;
    const double law = picture.laws->length.plain() ? 1 : longer(picture, seed, at, i);
    if (picture.motif) {
      const Motif own = picture.marks ? mark_at(picture, seed, at, i) : Motif();
      out = motif_strokes(picture, picture.marks ? own : *picture.motif, seed.part, seed.family, at,
                          picture.options.length * law, i);
      return;
    }
    // Equal strokes would look ruled.
    const Rng rng(picture.seed, static_cast<std::uint64_t>(seed.part),
                  static_cast<std::uint64_t>(seed.family));
    const double reach = law * picture.options.length * (1.0 / 3 + rng.uniform(i) / 3);
    TracedStroke traced =
        tracer.trace(seed.part, at, {.reach = reach, .least_ink = picture.options.tone_min});
    if (traced.samples.size() > 1) out.push_back(std::move(traced));
  };
  return on_each(seeds, families, context, progress, stroke);
}

std::vector<Family> place_dots(const Picture& picture, const ViewRaster& /*raster*/,
                               const std::vector<Seed>& seeds, int families,
                               const RunContext& context,
                               const std::function<void(double)>& progress) {
  return on_each(seeds, families, context, progress,
                 [&](std::size_t i, std::vector<TracedStroke>& out) {
                   if (auto dot = dot_at(picture, seeds[i])) out.push_back(std::move(*dot));
                 });
}

Placing::Load dots_load(const Picture& picture, double ink) {
  const double points = density(picture, ink);
  return {.length = points * kDot, .strokes = points};
}

Placing::Load points_load(const Picture& picture, double ink) {
  const double points = density(picture, ink), length = picture.options.length;
  if (!picture.motif) return {.length = points * length, .strokes = points};
  // A motif of many samples weighs as much as the strokes that have as many.
  constexpr double kSamples = 10;
  double samples = picture.motif->length * length / kStep;
  for (const Motif::Line& line : picture.motif->lines) {
    samples += static_cast<double>(line.points.size());
  }
  return {.length = points * length * picture.motif->length,
          .strokes = points * std::max(1.0, samples / kSamples)};
}

}  // namespace burin::detail
