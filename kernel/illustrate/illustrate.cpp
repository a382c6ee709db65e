#include <burin/base/error.h>
#include <burin/feature/feature.h>
#include <burin/field/catalogue.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/view_probe.h>
#include <burin/section/hatch_cuts.h>
#include <burin/stroke/stroke.h>
#include <burin/surface/empty_surface.h>
#include <burin/tone/catalogue.h>
#include <burin/verify/verify.h>
#include <burin/visibility/occluder.h>
#include <burin/visibility/outline_gaps.h>

#include "compose.h"
#include "on_sheet.h"
#include "part_styles.h"
#include "sight.h"
#include "style_table.h"
#include "undirected.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace burin {
namespace {

// Paper mm that a tessellation chosen from the sheet may be off.
constexpr double kSheetTolerance = 0.05;

// Paper mm of radius from which a surface is flat for strokes that keep an angle: over a hand's
// width the angle changes by some three degrees.
constexpr double kFlatRadius = 2000;

using Surfaces = std::vector<std::shared_ptr<const Surface>>;

// Diagonals of the sheet that a drawing may be large before its surfaces are made no finer: what is
// beyond the sheet is made too.
constexpr double kMostSheets = 5;

// Model mm.
double chord_tolerance(const Scene& scene, const Camera& camera, const IllustrateOptions& options) {
  if (options.tolerance) return *options.tolerance;
  const Paper& paper = camera.paper();
  const double sheets = camera.scale() * drawn_bounds(scene, options.part_styles).diagonal() /
                        glm::length(Vec2(paper.width, paper.height));
  return std::max(1.0, sheets / kMostSheets) * kSheetTolerance / camera.scale();
}

// A word where a magnified drawing of curved surfaces is coarser than the sheet could show.
void tell_magnified(const Camera& camera, const Surfaces& surfaces, double tolerance,
                    Diagnostics& diagnostics) {
  const double on_paper = tolerance * camera.scale(), coarser = on_paper / kSheetTolerance;
  constexpr double kRounding = 1e-9;
  if (coarser <= 1 + kRounding) return;
  // The facets of meshes are as they are; what rounds them is no finer than this.
  if (std::all_of(surfaces.begin(), surfaces.end(),
                  [](const auto& s) { return s->proxy().tolerance == 0; })) {
    return;
  }
  diagnostics.add(Severity::Warning, "sheet.magnified", 1,
                  fmt::format("the drawing is {:.0f} times as large as the sheet: curved surfaces "
                              "are made to {:.2g} mm of paper; cut the detail out of the model, or "
                              "give `tolerance`, for finer ones",
                              coarser * kMostSheets, on_paper));
}

Surfaces realise(const Scene& scene, const Camera& camera, const detail::PartStyles& part_styles,
                 const IllustrateOptions& options, Diagnostics& diagnostics, RunContext& context) {
  RealiseOptions realise;
  realise.tolerance = chord_tolerance(scene, camera, options);
  realise.view = &camera;
  realise.diagnostics = &diagnostics;
  Surfaces surfaces;
  // A part that cannot be realised is no reason to refuse the others.
  std::size_t drawn = 0;
  std::exception_ptr first;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (!part_styles.drawn(i)) {
      surfaces.push_back(empty_surface());
      continue;
    }
    const Style& style = part_styles.style(i);
    realise.crease_angle = style.feature.crease_angle;
    realise.curvature = std::ranges::any_of(part_styles.strokes(), [&](const auto& strokes) {
      return strokes.parts[i] && follows_field(*strokes.hatch) &&
             field::find(strokes.hatch->field.name).needs_curvature;
    });
    try {
      surfaces.push_back(scene.parts[i].form->realise(realise, context));
      ++drawn;
    } catch (const GeometryError& e) {
      if (!first) first = std::current_exception();
      diagnostics.add(Severity::Error, "part.not_drawn", 1,
                      fmt::format("{}: the part was left out: {}", scene.parts[i].name, e.what()));
      surfaces.push_back(empty_surface());
    }
  }
  if (drawn == 0 && first) std::rethrow_exception(first);
  if (!options.tolerance) {
    tell_magnified(camera, surfaces, realise.tolerance, diagnostics);
  }
  return surfaces;
}

Field make_field(const std::vector<const Surface*>& surfaces, const Camera& camera,
                 const detail::StrokeSet& strokes, const std::shared_ptr<const Image>& image,
                 const RunContext& context) {
  if (!follows_field(*strokes.hatch)) {
    return {"none", [](const FieldQuery&) { return std::optional<Cross>(); }};
  }
  const field::FieldKind& kind = field::find(strokes.hatch->field.name);
  if (stands_on_levels(*strokes.hatch) && !kind.has_levels) {
    std::vector<std::string_view> with;
    for (const field::FieldKind& other : field::catalogue()) {
      if (other.has_levels) with.push_back(other.name);
    }
    throw UsageError(
        fmt::format("hatch.placing levels asks for a hatch.field that has levels ({}); {} has none",
                    fmt::join(with, ", "), kind.name));
  }
  return kind.make({.surfaces = surfaces,
                    .camera = camera,
                    .options = strokes.hatch->field,
                    .light = tone::to_light(camera, *strokes.tone),
                    .flat = camera.scale() / kFlatRadius,
                    .context = context,
                    .image = image});
}

// Whether the ink of the whole picture is balanced: it is light and shade that need it. A tone that
// a program brings, or that asks for the same ink in any light, is taken as it is.
bool balances(const tone::ToneOptions& tone) {
  return tone.ink == tone::ToneOptions::Ink::Shade && tone::find(tone.law).uses_light;
}

// A stream of chance for each kind of strokes: points of two would lie on each other.
std::uint64_t seed_of(std::uint64_t seed, int number) {
  constexpr std::uint64_t kApart = 0x9E3779B97F4A7C15;
  return seed ^ (static_cast<std::uint64_t>(number - 1) * kApart);
}

// What stands before the lights of a scene: the solid parts.
tone::Blocked blocked_by(const Occluder& solid, double tolerance) {
  // A triangle does not hide the smooth surface that it stands for.
  const double off = std::max(4 * solid.resolution(), 2 * tolerance), far = 2 * solid.diagonal();
  return [&solid, off, far](Vec3 position, Vec3 normal, Vec3 towards, double distance) {
    return solid.occluded(position + off * normal, towards, 0, std::min(far, distance));
  };
}

// The picture of some strokes; null where they name none, or one that was not read.
std::shared_ptr<const Image> image_of(const HatchStyle& hatch, const IllustrateOptions& options) {
  const auto found = options.images.find(hatch.image);
  return found == options.images.end() ? nullptr : found->second;
}

// The strokes of one kind on the parts that are flagged.
StrokeResult hatch(std::vector<const Surface*> surfaces, std::vector<bool> parts,
                   const Occluder& occluder, const Camera& camera, const detail::StrokeSet& strokes,
                   const Occluder& solid, const detail::DepthCue& cue,
                   const IllustrateOptions& options, detail::Undirected& undirected,
                   RunContext& context) {
  double tolerance = 0;
  for (const Surface* s : surfaces) tolerance = std::max(tolerance, s->proxy().tolerance);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!parts[i]) surfaces[i] = empty_surface().get();
  }
  context.begin_stage(RunStage::Field);
  const ViewProbe probe = view_probe(occluder, camera, std::move(parts));
  const HatchScene scene{surfaces, camera, probe, context};
  const std::shared_ptr<const Image> image = image_of(*strokes.hatch, options);
  const Field field =
      options.field ? options.field(scene) : make_field(surfaces, camera, strokes, image, context);
  const Tone tone = options.tone ? options.tone(scene)
                                 : tone::make(camera, *strokes.tone, blocked_by(solid, tolerance));
  InkOptions ink{.exponents = strokes.exponents,
                 .tone_min = strokes.hatch->tone_min,
                 .image = image,
                 .keys = detail::kind_group(static_cast<std::size_t>(strokes.number))};
  if (!options.tone && balances(*strokes.tone)) ink.balance = *strokes.tone;
  if (!options.tone && cue.pales()) ink.fade = [&](Vec3 position) { return cue.ink(position); };
  StrokeResult result = trace_strokes(surfaces, camera, field, tone, probe, *strokes.hatch,
                                      seed_of(options.seed, strokes.number), context, ink);
  for (Curve3& stroke : result.strokes) stroke.stroke_kind = strokes.number;
  // Where there is no level there is no line of it to be missed.
  if (!options.field && follows_field(*strokes.hatch) && !stands_on_levels(*strokes.hatch)) {
    const Tone toned = [&](Vec3 position, Vec3 normal) {
      const double asked = std::pow(1 - tone(position, normal), result.tone_gamma);
      return 1 - (ink.fade ? ink.fade(position) : 1.0) * asked;
    };
    undirected.look(scene, field, toned, *strokes.hatch);
  }
  return result;
}

// `most`: the coverage points of the largest so far.
void append(StrokeResult& all, StrokeResult one, std::int64_t& most) {
  all.strokes.insert(all.strokes.end(), std::make_move_iterator(one.strokes.begin()),
                     std::make_move_iterator(one.strokes.end()));
  if (one.coverage_points > most) {
    most = one.coverage_points;
    all.tone_gamma = one.tone_gamma;
  }
  all.coverage_points += one.coverage_points;
  all.coverage_delta = std::max(all.coverage_delta, one.coverage_delta);
  all.thinned_parts += one.thinned_parts;
  all.unmapped.insert(all.unmapped.end(), one.unmapped.begin(), one.unmapped.end());
}

// Whether any strokes are to have their ink brought to a median.
bool states_gamma(const detail::PartStyles& part_styles) {
  return std::ranges::any_of(part_styles.strokes(), [](const detail::StrokeSet& strokes) {
    const tone::ToneOptions& tone = *strokes.tone;
    return balances(tone) && (tone.median_min > 0 || tone.median_max < 1);
  });
}

// Of the solid parts a kind of strokes at a time; then of the transparent ones, each as it is seen
// alone.
StrokeResult hatch_all(const std::vector<const Surface*>& surfaces, const detail::Sight& sight,
                       const Camera& camera, const detail::PartStyles& part_styles,
                       const detail::DepthCue& cue, const IllustrateOptions& options,
                       detail::Undirected& undirected, RunContext& context) {
  StrokeResult all;
  std::int64_t most = 0;
  for (const detail::StrokeSet& strokes : part_styles.strokes()) {
    std::vector<bool> parts = strokes.parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (part_styles.transparent(i)) parts[i] = false;
    }
    if (std::find(parts.begin(), parts.end(), true) == parts.end()) continue;
    append(all,
           hatch(surfaces, std::move(parts), sight.solid(), camera, strokes, sight.solid(), cue,
                 options, undirected, context),
           most);
  }
  for (std::size_t part = 0; part < part_styles.size(); ++part) {
    if (!part_styles.transparent(part) || !part_styles.hatched(part)) continue;
    std::vector<bool> alone(part_styles.size(), false);
    alone[part] = true;
    context.begin_stage(RunStage::Build);
    const Occluder before = sight.before(part, context);
    for (const detail::StrokeSet& strokes : part_styles.strokes()) {
      if (!strokes.parts[part]) continue;
      append(all,
             hatch(surfaces, alone, before, camera, strokes, sight.solid(), cue, options,
                   undirected, context),
             most);
    }
  }
  return all;
}

// Feature lines of all parts; drawn or not: contours and boundaries cut the visibility of others.
std::vector<Curve3> features_of(const std::vector<const ProxyMesh*>& proxies, const Camera& camera,
                                const detail::PartStyles& part_styles, Diagnostics& diagnostics,
                                const RunContext& context) {
  FeatureOptions options{.intersections = false, .smooth = false};
  for (const Style* style : part_styles.styles()) {
    options.intersections |= style->feature.intersections;
    options.smooth |= style->feature.smooth;
    options.seams |= style->feature.seams;
  }
  return extract_features(proxies, camera, options, diagnostics, context);
}

DrawingView describe(const Camera& camera) {
  DrawingView view;
  view.projection = camera.perspective() ? "perspective" : "orthographic";
  view.direction = camera.direction();
  view.right = camera.right();
  view.up = camera.up();
  view.scale = camera.scale();
  view.center = camera.center();
  view.offset = camera.offset();
  if (camera.perspective()) {
    view.eye = camera.eye();
    view.field_of_view = camera.field_of_view();
  }
  return view;
}

std::int64_t face_count(const ProxyMesh& proxy) {
  if (proxy.source_face.empty()) return proxy.region_count;
  return static_cast<std::int64_t>(
      std::set(proxy.source_face.begin(), proxy.source_face.end()).size());
}

Drawing describe(const Scene& scene, const std::vector<const ProxyMesh*>& proxies,
                 const Camera& camera, const Style& style, std::uint64_t seed) {
  Drawing drawing;
  drawing.paper_width = camera.paper().width;
  drawing.paper_height = camera.paper().height;
  drawing.ink_color = style.sheet.ink;
  drawing.paper_color = style.sheet.paper;
  drawing.seed = seed;
  drawing.style = style.name;
  drawing.view = describe(camera);
  drawing.diagnostics = scene.diagnostics;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const auto triangles = static_cast<std::int64_t>(proxies[i]->mesh.triangles.size());
    const Part& part = scene.parts[i];
    drawing.parts.push_back({static_cast<std::int32_t>(i), part.name, part.source, triangles,
                             face_count(*proxies[i]), part.assembly, part.color});
    drawing.stats.triangles += triangles;
  }
  return drawing;
}

/// What was done with less care so that the work stays bounded.
void tell_bounds(const StrokeResult& strokes, const detail::Seen& seen, Diagnostics& diagnostics) {
  if (strokes.thinned_parts > 0) {
    diagnostics.add(Severity::Warning, "stroke.many_sheets", strokes.thinned_parts,
                    "parts lie in so many sheets over each other that strokes were begun at fewer "
                    "places; some areas may be white, and the file may be damaged");
  }
  if (seen.merged_cuts > 0) {
    diagnostics.add(
        Severity::Warning, "visibility.crowded", 1,
        fmt::format(
            "the lines cross each other so often that what is hidden was decided for {:.2g} "
            "mm at a time; the file may be damaged, or show more than one sheet can hold",
            seen.merged_cuts));
  }
}

// Parts on which laws of u and v say nothing.
void tell_unmapped(const Scene& scene, std::vector<std::int32_t> parts, Diagnostics& diagnostics) {
  std::ranges::sort(parts);
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  if (parts.empty()) return;
  const std::string& first = scene.parts[static_cast<std::size_t>(parts.front())].name;
  diagnostics.add(
      Severity::Warning, "strokes.no_parameters", static_cast<std::int64_t>(parts.size()),
      fmt::format(
          "{}{} has no u and v; laws of strokes that look at them (hatch.ink_law "
          "to hatch.presence_law) change nothing there",
          first.empty() ? fmt::format("part {}", parts.front()) : fmt::format("'{}'", first),
          parts.size() > 1 ? fmt::format(" (and {} more)", parts.size() - 1) : ""));
}

// Choices of strokes that nothing of the drawing looks at, each once.
void tell_unused(const detail::PartStyles& part_styles, const IllustrateOptions& options,
                 Diagnostics& diagnostics) {
  std::set<std::string> told;
  for (const detail::StrokeSet& strokes : part_styles.strokes()) {
    const HatchStyle& hatch = *strokes.hatch;
    const std::string group = detail::kind_group(static_cast<std::size_t>(strokes.number));
    if (!takes_motif(hatch)) {
      const auto tell = [&](const char* key) {
        told.insert(
            fmt::format("{0}{1} has no effect: it is for strokes on points ({0}placing points, "
                        "discs), not {2}",
                        group, key, hatch.placing));
      };
      if (hatch.length_law != HatchOptions().length_law) tell("length_law");
      if (hatch.has_motif()) tell("motif");
    }
    const tone::ToneOptions& tone = *strokes.tone;
    if (!options.tone && tone.shadow > 0 && !tone::find(tone.law).uses_light) {
      told.insert(fmt::format("{0}tone.shadow has no effect: {0}tone.law {1} looks at no light",
                              strokes.number == 1 ? "" : group, tone.law));
    }
  }
  for (const std::string& text : told) {
    diagnostics.add(Severity::Warning, "option.unused", 1, text);
  }
}

void name_own_field(Drawing& drawing) {
  for (Layer& layer : drawing.layers) {
    for (Path& path : layer.paths) {
      if (path.kind == LineClass::Stroke) path.field = "own";
    }
  }
}

// Whether the lines that the outer outline is made of are drawn.
bool draws_outline(const detail::PartStyles& part_styles) {
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const auto& drawn = part_styles.style(i).feature;
    if (!drawn.contours || !drawn.creases || !drawn.boundaries) return false;
  }
  return true;
}

// Which parts are seen where, what can be looked through apart.
struct Labels {
  LabelMap seen, glass;
};

// Where a drawing has ink, on its sheet.
Box2 ink_on_sheet(const Drawing& drawing) {
  Box2 box;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) box.add(p);
    }
  }
  if (box.empty()) return box;
  constexpr double kAround = 1;  // paper mm
  return {glm::max(box.min - kAround, Vec2(0)),
          glm::min(box.max + kAround, Vec2(drawing.paper_width, drawing.paper_height))};
}

Labels label(const Drawing& drawing, const std::vector<const ProxyMesh*>& proxies,
             const Camera& camera, const detail::PartStyles& part_styles,
             const detail::Sight& sight, const RunContext& context) {
  const Box2 box = ink_on_sheet(drawing);
  if (box.empty() || box.min.x >= box.max.x || box.min.y >= box.max.y) return {};
  const auto map = [&](const Occluder& occluder) {
    const ViewProbe probe = view_probe(occluder, camera);
    return make_label_map(
        box,
        [&](Vec2 at) {
          const auto hit = probe(at);
          return hit ? hit->part : -1;
        },
        context);
  };
  Labels labels{map(sight.solid()), {}};
  bool any_glass = false;
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    any_glass |= part_styles.drawn(i) && part_styles.transparent(i);
  }
  if (!any_glass) return labels;
  labels.glass = map(Occluder(proxies, context));
  for (std::int32_t& part : labels.glass.parts) {
    if (part >= 0 && !part_styles.transparent(static_cast<std::size_t>(part))) part = -1;
  }
  return labels;
}

// The drawing; `found` gets its lines as compose gives them, `labels` which parts are seen where.
Drawing draw(const Scene& scene, const Camera& camera, const Style& style,
             const detail::PartStyles& part_styles, const IllustrateOptions& options,
             std::vector<Path>* found, Labels& labels, RunContext& context) {
  Diagnostics realised;
  const Surfaces owned = realise(scene, camera, part_styles, options, realised, context);
  std::vector<const Surface*> surfaces;
  std::vector<const ProxyMesh*> proxies;
  for (const auto& s : owned) {
    surfaces.push_back(s.get());
    proxies.push_back(&s->proxy());
  }
  Drawing drawing = describe(scene, proxies, camera, style, options.seed);
  drawing.diagnostics.append(realised);
  context.begin_stage(RunStage::Build);
  const detail::Sight sight(proxies, camera, part_styles, context);

  const detail::DepthCue cue(proxies, camera, style);
  detail::Undirected undirected(scene);
  const StrokeResult strokes =
      hatch_all(surfaces, sight, camera, part_styles, cue, options, undirected, context);
  undirected.tell(drawing.diagnostics);
  drawing.stats.coverage_points = strokes.coverage_points;
  drawing.stats.coverage_delta = strokes.coverage_delta;
  if (states_gamma(part_styles)) drawing.stats.tone_gamma = strokes.tone_gamma;

  context.begin_stage(RunStage::Features);
  std::vector<Curve3> features =
      features_of(proxies, camera, part_styles, drawing.diagnostics, context);
  for (Curve3& line : hatch_cuts(proxies, camera, context)) features.push_back(std::move(line));

  context.begin_stage(RunStage::Visibility);
  detail::Seen seen = sight.classify(features, strokes.strokes, context);
  if (draws_outline(part_styles)) sight.close_outline(features, seen, context);
  tell_bounds(strokes, seen, drawing.diagnostics);
  tell_unmapped(scene, strokes.unmapped, drawing.diagnostics);
  tell_unused(part_styles, options, drawing.diagnostics);

  context.begin_stage(RunStage::Compose);
  detail::compose({features, seen.features, strokes.strokes, seen.strokes},
                  {proxies, camera, part_styles, style, options.hidden, cue}, drawing, context,
                  found);
  if (options.field) name_own_field(drawing);
  if (options.annotations) {
    labels = label(drawing, proxies, camera, part_styles, sight, context);
  }
  context.end_stage();
  return drawing;
}

VerifyOptions verify_options(const Scene& scene, const Camera& camera, const Style& style,
                             const detail::PartStyles& part_styles,
                             const IllustrateOptions& options) {
  VerifyOptions verify{.tolerance = chord_tolerance(scene, camera, options),
                       .outline = style.halo.gap <= 0 && draws_outline(part_styles)};
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    verify.parts.push_back(!part_styles.drawn(i)        ? Standing::Absent
                           : part_styles.transparent(i) ? Standing::Transparent
                                                        : Standing::Solid);
    verify.crease_angles.push_back(part_styles.style(i).feature.crease_angle);
  }
  return verify;
}

}  // namespace

Box3 drawn_bounds(const Scene& scene, std::span<const PartStyle> part_styles, const Mat3& axes) {
  Box3 box;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (i < part_styles.size() && !part_styles[i].drawn) continue;
    box.add(scene.parts[i].form->bounds(axes));
  }
  return box.empty() ? scene.bounds(axes) : box;
}

Drawing illustrate(const Scene& scene, const Camera& camera, const Style& style,
                   const IllustrateOptions& options, RunContext& context) {
  if (scene.parts.empty()) throw GeometryError("nothing to draw: the input has no parts");
  const detail::PartStyles part_styles(scene, style, options);
  for (const Style* one : part_styles.styles()) check_style(*one);
  std::vector<Path> found;
  // Its surfaces are gone before finer ones are made.
  Labels labels;
  Drawing drawing = draw(scene, camera, style, part_styles, options,
                         options.verify ? &found : nullptr, labels, context);
  if (options.verify) {
    drawing.stats.verify = verify(drawing, found, scene, camera,
                                  verify_options(scene, camera, style, part_styles, options),
                                  drawing.diagnostics, context);
  }
  detail::settle_on_sheet(part_styles, style.sheet.clip, drawing);
  if (options.annotations) {
    annotate(drawing, labels.seen, labels.glass, *options.annotations, style.callout, context);
  }
  return drawing;
}

}  // namespace burin
