#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/stroke/stroke.h>

#include "placing.h"
#include "remembered.h"
#include "view_raster.h"
#include "widths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace burin {
namespace {

using namespace detail;

// Paper mm of strokes in one drawing: some 2 GB of memory. An A0 sheet in full tone has half.
constexpr double kLongest = 1.6e6;
constexpr double kMm = 1000;  // in a metre

void check(const HatchOptions& hatch) {
  const auto fault = options::first_fault(hatch_option_rows(), hatch);
  if (fault) throw UsageError("hatch option " + *fault);
}

// Model mm within which two hits along a viewing ray are one surface: what single precision of the
// rays and the chords of the proxy can move them, as a share of the scene's size.
double same_place(std::span<const Surface* const> surfaces) {
  Box3 box;
  double tolerance = 0;
  for (const Surface* s : surfaces) {
    box.add(s->proxy().mesh.bounds());
    tolerance = std::max(tolerance, s->proxy().tolerance);
  }
  return 1e-4 * box.diagonal() + 2 * tolerance;
}

// Strokes on points in one drawing: some 1 GB.
constexpr double kMostStrokes = 4e5;

// What the tone asks for: the area that strokes of both families cover, in paper mm2, their length
// in mm, and how many stand on points.
struct Work {
  double area = 0, length = 0, strokes = 0;
};
Work work_of(const Picture& picture, const Placing& placing, const ViewRaster& raster) {
  const double cell_area = raster.pitch * raster.pitch;
  Work work;
  for (const RasterCell& cell : raster.cells) {
    if (cell.part < 0) continue;
    for (const int family : {1, 2}) {
      const double ink = picture.share(cell.darkness, family);
      if (!(ink >= picture.options.tone_min && ink > 0)) continue;
      work.area += cell_area;
      const Placing::Load load = placing.load(picture, ink);
      work.length += cell_area * cell.denser * load.length;
      work.strokes += cell_area * cell.denser * load.strokes;
    }
  }
  return work;
}

// Refuses more strokes on points than memory should be asked for.
void check_points(const Picture& picture, const Work& work) {
  const double over = std::max(work.strokes / kMostStrokes, work.length / kLongest);
  if (over <= 1) return;
  const Paper& paper = picture.camera.paper();
  throw UsageError(fmt::format(
      "the tone of this style asks for {:.0f} strokes on points, {:.0f} m long in all, on the "
      "sheet "
      "of {:g} x {:g} mm, {:.0f} of them and {:.0f} m are the most: take wider strokes "
      "(hatch.width_min, hatch.width_max){}, a lighter tone or a smaller sheet",
      work.strokes, work.length / kMm, paper.width, paper.height, kMostStrokes, kLongest / kMm,
      work.strokes > kMostStrokes ? ", longer ones (hatch.length)" : ""));
}

// Refuses more strokes than memory should be asked for, before any is placed.
void check_work(const Picture& picture, const Placing& placing, const ViewRaster& raster) {
  const Work work = work_of(picture, placing, raster);
  if (picture.by_chance()) return check_points(picture, work);
  if (work.length <= kLongest) return;
  // Neighbours that are nowhere nearer than this keep the limit; rounded up to two digits.
  const double spacing = 1.1 * work.area / kLongest;
  const Paper& paper = picture.camera.paper();
  constexpr double kWidest = 50;  // what styles take
  const std::string advice =
      spacing > kWidest
          ? ""
          : fmt::format("set hatch.spacing_min to {:.2g} and hatch.spacing_max to {:.2g} or more, ",
                        spacing, std::max(spacing, picture.options.spacing_max));
  throw UsageError(fmt::format(
      "the strokes of this style would be {:.0f} m long on the sheet of {:g} x {:g} mm, {:.0f} m "
      "are the most: {}draw without strokes (hatch.enabled=false), or take a smaller sheet",
      work.length / kMm, paper.width, paper.height, kLongest / kMm, advice));
}

// Takes the kinks out of a line that crossed the facets of a coarse mesh: low-pass filtering
// without shrinking, ends kept.
// @cite Taubin1995
void fair(std::vector<Vec3>& points, bool closed) {
  constexpr int kPasses = 6;
  constexpr double kShrink = 0.5,
                   kInflate = -0.53;  // a pass band of waves longer than about 12 samples
  const std::size_t n = points.size();
  if (n < 4) return;
  std::vector<Vec3> moved(n);
  for (int pass = 0; pass < 2 * kPasses; ++pass) {
    const double weight = pass % 2 == 0 ? kShrink : kInflate;
    for (std::size_t i = 0; i < n; ++i) {
      const bool fixed = !closed && (i == 0 || i + 1 == n);
      // The place that the point would have on the straight line between its neighbours.
      const Vec3 a = points[(i + n - 1) % n], b = points[(i + 1) % n];
      const double before = glm::distance(a, points[i]), after = glm::distance(points[i], b);
      const double t = before + after > 0 ? before / (before + after) : 0.5;
      const Vec3 middle = a + t * (b - a);
      moved[i] = fixed ? points[i] : points[i] + weight * (middle - points[i]);
    }
    points.swap(moved);
  }
}

// Lifting a line off its facets and fairing it move it off what it keeps. Put back along the
// surface, or, where that is nearly level itself, in space.
void restore_level(const TracedStroke& stroke, const Surface& surface, const Picture& picture,
                   std::vector<Vec3>& points) {
  constexpr double kMost = 0.4;   // paper mm: what is off by more was moved for another reason
  constexpr double kSteep = 0.5;  // sine of the angle between the surface and level planes
  if (!stroke.level) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    SurfacePoint at = stroke.samples[i].point;
    const Frame frame = surface.frame(at);
    at.position = points[i];
    const auto here = picture.level(stroke.part, at, frame);
    if (!here) continue;
    const bool steep = glm::length(here->gradient) >= kSteep * glm::length(here->in_space);
    const Vec3 along = steep ? here->gradient : here->in_space;
    const double off = *stroke.level - here->value, slope = glm::length(along);
    if (std::abs(off) * picture.camera.scale_at(points[i]) > kMost * slope) continue;
    points[i] += off / (slope * slope) * along;
  }
}

Curve3 to_curve(const TracedStroke& stroke, const Picture& picture, std::vector<double> widths) {
  const Surface& surface = picture.surface(stroke.part);
  Curve3 c;
  c.kind = LineClass::Stroke;
  c.family = stroke.family;
  c.closed = stroke.closed;
  c.source = {stroke.part, surface.proxy().face_source(stroke.samples.front().face), -1};
  c.widths = std::move(widths);
  for (const StrokeSample& s : stroke.samples) {
    c.points.push_back(surface.drawn_position(s.point));
    c.normals.push_back(s.normal);
    c.faces.push_back(static_cast<std::int32_t>(s.face));
  }
  if (!c.closed) c.faces.pop_back();
  if (!stroke.whole) fair(c.points, c.closed);  // motifs have their corners
  restore_level(stroke, surface, picture, c.points);
  return c;
}

// Gives the cells, which have what the tone of each place asks for, what the whole picture makes of
// it, and laws of that.
void tone_cells(const Picture& picture, ViewRaster& raster, const RunContext& context) {
  const auto cell = [&](RasterCell& c) {
    const Surface& surface = picture.surface(c.part);
    const ProxyPoint at = c.place();
    const Vec3 position = surface.proxy().position(at.face, at.bary);
    double ink = picture.toned(c.darkness, c.part, c.region, position);
    if (picture.laws->shape_picture()) {
      const SurfacePoint point = surface.lift(at);
      const Frame frame = surface.frame(point);
      const LawPlace place{c.part, point, frame, c.facing, ink};
      ink = picture.laws->inked(place, surface, picture.field);
      c.denser = static_cast<float>(picture.laws->denser(place, surface, picture.field));
    }
    c.darkness = static_cast<float>(ink);
  };
  constexpr std::size_t kGrain = 4096;
  parallel_for(
      raster.cells.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          if (raster.cells[i].part >= 0) cell(raster.cells[i]);
        }
      },
      &context);
}

// Whether some place of a surface has u and v: those of a mesh may be told for a part of it.
bool has_parameters(const Surface& surface) {
  const Vec3 middle(1.0 / 3);
  for (std::uint32_t t = 0; t < surface.proxy().mesh.triangles.size(); ++t) {
    if (surface.parameters(surface.lift({t, middle}))) return true;
  }
  return false;
}

// Parts without any u and v.
std::vector<std::int32_t> without_parameters(std::span<const Surface* const> surfaces) {
  std::vector<std::int32_t> parts;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i]->proxy().mesh.triangles.empty()) continue;
    if (!has_parameters(*surfaces[i])) parts.push_back(static_cast<std::int32_t>(i));
  }
  return parts;
}

// What the law of width makes of the widths of a stroke; `number` tells its chance.
void apply_width_law(const TracedStroke& stroke, std::size_t number, const Picture& picture,
                     std::vector<double>& widths) {
  constexpr double kMost = 10;
  const Surface& surface = picture.surface(stroke.part);
  const double random = Laws::random(picture.seed, stroke.part, stroke.family, kWidthLaw, number);
  const double whole = stroke.length();
  double along = 0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const StrokeSample& s = stroke.samples[i];
    if (i > 0) along += glm::length(s.paper - stroke.samples[i - 1].paper);
    const Frame frame = surface.frame(s.point);
    const LawPlace place{stroke.part,
                         s.point,
                         frame,
                         s.facing,
                         picture.share(s.darkness, stroke.family),
                         random,
                         whole > 0 ? std::min(1.0, along / whole) : 0};
    widths[i] *= std::clamp(picture.laws->width.at(place, surface, picture.field, 1), 0.0, kMost);
  }
}

// Whether the law of presence lets a stroke, or the motif that it is of, be drawn, by its middle.
bool present(const TracedStroke& stroke, std::size_t number, const Picture& picture) {
  const Surface& surface = picture.surface(stroke.part);
  const StrokeSample& s =
      stroke.whole ? stroke.whole->middle : stroke.samples[stroke.samples.size() / 2];
  const auto dice = [&](std::uint64_t law) {
    return Laws::random(picture.seed, stroke.part, stroke.family, law, number);
  };
  constexpr std::uint64_t kOfFormula = 4;  // what `random` is in it
  const Frame frame = surface.frame(s.point);
  const LawPlace place{
      stroke.part,     s.point, frame, s.facing, picture.share(s.darkness, stroke.family),
      dice(kOfFormula)};
  return dice(kPresenceLaw) < picture.laws->presence.at(place, surface, picture.field, 1);
}

// The strokes as curves, by their laws.
void take_strokes(const Picture& picture, const std::vector<Family>& placed, Widths widths,
                  const RunContext& context, std::vector<Curve3>& out) {
  const Laws& laws = *picture.laws;
  for (std::size_t f = 0; f < placed.size(); ++f) {
    const std::vector<TracedStroke>& strokes = placed[f].strokes;
    std::vector<std::uint8_t> drawn(strokes.size(), 1);
    const auto apply = [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const std::size_t number = strokes[s].whole ? strokes[s].whole->number : s;
        if (!laws.width.plain()) apply_width_law(strokes[s], number, picture, widths[f][s]);
        drawn[s] = laws.presence.plain() || present(strokes[s], number, picture);
      }
    };
    constexpr std::size_t kGrain = 64;
    parallel_for(strokes.size(), kGrain, apply, &context);
    for (std::size_t s = 0; s < strokes.size(); ++s) {
      if (drawn[s]) out.push_back(to_curve(strokes[s], picture, std::move(widths[f][s])));
    }
  }
}

// The raster of the picture without any darkness: that of its memory where there is one.
ViewRaster seen_cells(const Picture& picture, const RunContext& context) {
  if (picture.memory == nullptr) return make_raster(picture, context);
  std::optional<ViewRaster>& kept = picture.memory->raster;
  if (!kept) kept = make_raster(picture, context);
  return *kept;
}

}  // namespace

StrokeMemory::StrokeMemory() : impl_(std::make_unique<Impl>()) {}
StrokeMemory::~StrokeMemory() = default;

HatchOptions remembered_by(HatchOptions options) {
  const HatchOptions usual;
  const bool swells = swelling(options);
  options.width_min = 1;
  options.width_max = swells ? 2 * kLeastSwelling : 1;
  options.taper = usual.taper;
  options.tone_min = usual.tone_min;
  options.cross_from = usual.cross_from;
  options.cross_angle = usual.cross_angle;
  options.ink_law = usual.ink_law;
  options.width_law = usual.width_law;
  options.presence_law = usual.presence_law;
  return options;
}

StrokeResult trace_strokes(std::span<const Surface* const> surfaces, const Camera& camera,
                           const Field& field, const Tone& tone, const ViewProbe& probe,
                           const HatchOptions& options, std::uint64_t seed, RunContext& context,
                           const InkOptions& ink, StrokeMemory* memory) {
  check(options);
  const Placing& placing = find_placing(options.placing);
  if (options.has_image() && !ink.image) {
    throw UsageError(
        fmt::format("style key '{}image': no picture '{}' was read", ink.keys, options.image));
  }
  const Laws laws(options, ink.keys, ink.image);
  HatchOptions own = options;
  if (!follows_field(options)) own.cross_from = 2;  // dots do not cross
  if (placing.placement_kind == Picture::PlacementKind::Levels) own.cross_from = 2;
  std::optional<Motif> motif;
  if (options.has_motif() && takes_motif(options)) {
    // Paper mm that lines may be off a motif's curves.
    constexpr double kTolerance = 0.01;
    motif = motif_of(options, ink.keys, kTolerance / options.length);
    own.cross_from = 2;
  }
  Marks marks;
  if (const MarkKind* kind = find_mark(options.placing)) {
    marks = kind->make({camera, options, VisibleSurfaces{surfaces, {}, &context}});
    // What a point weighs: a mark in half the ink.
    constexpr double kLeast = 0.1;
    motif = motif_of(marks({.ink = 0.5, .random = 0.5}));
    motif->length = std::max(motif->length, kLeast);
    own.cross_from = 2;
  }
  if (!ink.exponents.empty()) {
    own.tone_min = Picture::shared(own.tone_min, *std::ranges::min_element(ink.exponents));
  }
  Picture picture{.surfaces = surfaces,
                  .camera = camera,
                  .field = field,
                  .tone = tone,
                  .probe = probe,
                  .options = own,
                  .seed = seed,
                  .same_place = same_place(surfaces),
                  .placement_kind = placing.placement_kind,
                  .motif = motif ? &*motif : nullptr,
                  .marks = marks ? &marks : nullptr,
                  .memory = memory ? &memory->impl() : nullptr};
  context.begin_stage(RunStage::Cover);
  ViewRaster raster = seen_cells(picture, context);
  shade_raster(picture, raster, context);
  const ToneBalance balanced(picture, raster, ink.balance);
  if (balanced.active()) picture.balance = &balanced;
  picture.shaping = &ink;
  picture.laws = &laws;
  if (picture.balance || ink.fade || !ink.exponents.empty() || laws.shape_picture()) {
    tone_cells(picture, raster, context);
  }
  check_work(picture, placing, raster);
  const Coverage coverage = placing.cover(picture, raster, context);

  context.begin_stage(RunStage::Trace);
  const std::vector<Family> placed =
      placing.place(picture, raster, coverage.seeds, own.cross_from <= 1 ? 2 : 1, context,
                    [&](double share) { context.progress(0.8 * share); });
  Widths widths = solve_widths(picture, raster, placed, context);

  StrokeResult result;
  result.coverage_points = coverage.points;
  result.coverage_delta = coverage.delta;
  result.thinned_parts = coverage.thinned_parts;
  result.tone_gamma = balanced.gamma();
  if (laws.need_parameters()) result.unmapped = without_parameters(surfaces);
  take_strokes(picture, placed, std::move(widths), context, result.strokes);
  context.end_stage();
  return result;
}

}  // namespace burin
