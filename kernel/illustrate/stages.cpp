#include "stages.h"

#include <burin/base/error.h>
#include <burin/base/plugin_error.h>
#include <burin/centre_lines/centre_lines.h>
#include <burin/feature/feature.h>
#include <burin/illustrate/legend.h>
#include <burin/section/hatch_cuts.h>
#include <burin/tone/catalogue.h>
#include <burin/verify/verify.h>

#include "all_strokes.h"
#include "broken.h"
#include "compose.h"
#include "fill/fills.h"
#include "fill/hatch_areas.h"
#include "isophote_lines.h"
#include "on_sheet.h"
#include "parts_before.h"
#include "pmi/lay_pmi.h"
#include "region_options.h"
#include "shadow/ground_shadow.h"
#include "shadow/light_view.h"
#include "tell.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace burin::detail {
namespace {

// Whether any strokes are to have their ink brought to a median.
bool states_gamma(const PartStyles& part_styles) {
  return std::ranges::any_of(part_styles.strokes(), [](const StrokeSet& strokes) {
    const tone::ToneOptions& tone = *strokes.tone;
    return balances(tone) && (tone.median_min > 0 || tone.median_max < 1);
  });
}

std::vector<Curve3> centre_lines_of(const Occluders& occluders, const Camera& camera,
                                    const PartStyles& part_styles, HiddenLines hidden,
                                    Diagnostics& said, const RunContext& context) {
  CentreLineOptions options{.over = {}, .hidden = hidden != HiddenLines::None};
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const Style& style = part_styles.style(i);
    options.over.emplace_back();
    if (part_styles.drawn(i) && style.feature.centre_lines) {
      options.over.back() = style.line.centre_over;
    }
  }
  return centre_lines(occluders.surfaces(), camera, occluders.solid(), options, said, context);
}

// The threads of parts that show them; nothing where none does.
std::vector<DrawnThreads> drawn_threads(const Scene& scene, const PartStyles& part_styles) {
  std::vector<DrawnThreads> out(scene.parts.size());
  bool any = false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Style& style = part_styles.style(i);
    if (!part_styles.drawn(i) || !style.feature.threads) continue;
    out[i] = {scene.parts[i].threads, style.line.thread_gap};
    any = any || !out[i].threads.empty();
  }
  if (!any) out.clear();
  return out;
}

void name_own_field(Drawing& drawing) {
  for (Layer& layer : drawing.layers) {
    for (Path& path : layer.paths) {
      if (path.kind == LineClass::Stroke) path.field = "own";
    }
  }
}

// Whether the lines that the outer outline is made of are drawn.
bool draws_outline(const PartStyles& part_styles) {
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const auto& drawn = part_styles.style(i).feature;
    if (!drawn.contours || !drawn.creases || !drawn.boundaries) return false;
  }
  return true;
}

std::vector<bool> transparent_ones(const PartStyles& part_styles) {
  std::vector<bool> out;
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    out.push_back(part_styles.transparent(i) && part_styles.drawn(i));
  }
  return out;
}

VerifyOptions verify_options(const Scene& scene, const Camera& camera, const Style& style,
                             const PartStyles& part_styles, const IllustrateOptions& options,
                             std::span<const double> ranks, std::span<const Area> areas) {
  VerifyOptions verify{.tolerance = chord_tolerance(scene, camera, options),
                       .outline = style.halo.gap <= 0 && draws_outline(part_styles),
                       .ranks = {ranks.begin(), ranks.end()}};
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    verify.parts.push_back(!part_styles.drawn(i)        ? PartOpacity::Absent
                           : part_styles.transparent(i) ? PartOpacity::Transparent
                                                        : PartOpacity::Solid);
    verify.crease_angles.push_back(part_styles.style(i).feature.crease_angle);
  }
  if (areas.empty()) return verify;
  verify.shown = options.shown;
  const bool shadows = style.shadow.cast;
  verify.areas = {areas, region_options(scene, part_styles, camera, shadows).tones};
  verify.areas->pen = style.line.crease;
  verify.areas->unshaded = without_shadow(part_styles, transparent_ones(part_styles));
  if (shadows) verify.areas->shadows = tone::to_light(camera, style.tone);
  return verify;
}

}  // namespace

std::vector<std::size_t> Stages::parts_before(std::span<const std::size_t> shown,
                                              const Camera& camera) const {
  const Occluders* last = occluders_.last();
  return last ? detail::parts_before(shown, *last, camera) : std::vector<std::size_t>();
}

std::shared_ptr<Stages::Lines> Stages::lines_of(const View& view, RunContext& context) {
  return lines_.get(view, [&] {
    Diagnostics said;
    const auto proxies = view.occluders->proxies();
    std::vector<Curve3> features =
        extract_features(proxies, view.camera, view.features, said, context,
                         {view.occluders->transparent(), view.occluders->ranks()});
    for (Curve3& line :
         hatch_cuts(proxies, view.camera, context, view.magnified, view.occluders->ranks())) {
      features.push_back(std::move(line));
    }
    std::ranges::move(
        isophote_lines(*view.occluders, view.camera, view.isophotes, view.pen, context),
        std::back_inserter(features));
    add_thread_lines(view.threads, proxies, view.camera, features, said, context);
    features.insert(features.end(), view.trails.begin(), view.trails.end());
    return std::make_shared<Lines>(
        Lines{Sight(view.occluders, view.camera, std::move(features), view.closes_outline),
              std::move(said)});
  });
}

Labels Stages::labels_of(const Scene& scene, const Drawing& drawing,
                         const std::shared_ptr<Lines>& lines, const Shaded& shaded,
                         const Style& style, const PartStyles& part_styles,
                         const IllustrateOptions& options, RunContext& context) {
  Labels labels;
  const auto &occluders = shaded.occluders, &casters = shaded.casters;
  const Vec3 to_light = shaded.to_light;
  const Camera& camera = shaded.camera;
  const auto& over = options.annotations;
  // A title block alone is about no part.
  const bool pointed_at = over && (!over->items.empty() || !over->title_block);
  const std::vector<bool> faces = told_faces(part_styles, options.face_areas);
  const bool regions = std::ranges::find(faces, true) != faces.end() || paints(part_styles) ||
                       hatches(part_styles) || style.shadow.cast || style.shadow.ground;
  std::shared_ptr<std::optional<LightView>> light;
  if (style.shadow.cast || style.shadow.ground) {
    light = light_.get({casters, to_light}, [&] {
      return std::make_shared<std::optional<LightView>>(light_view(*casters, to_light, context));
    });
  }
  if (pointed_at || regions) {
    LabelRequest wanted(drawing, occluders, camera, !regions);
    if (regions && occluders->any_transparent()) {
      wanted.colors = face_colors(scene, part_styles);
    }
    labels = *labels_.get(wanted, [&] { return std::make_shared<Labels>(label(wanted, context)); });
    if (regions) {
      Parted parted{lines, casters, wanted.box,
                    region_options(scene, part_styles, camera, style.shadow.cast)};
      parted.options.faces = faces;
      parted.options.pen = style.line.crease;
      if (style.shadow.cast) parted.options.shadows = to_light;
      const auto parts = regions_.get(parted, [&] {
        Toned toned{occluders, camera, parted.options.pen, {}};
        for (const Isophotes& tones : parted.options.tones) {
          toned.steps.push_back(!tones.levels.empty());
        }
        const auto normals = light_normals_.get(toned, [&] {
          return std::make_shared<LightNormals>(
              light_normals_of(*occluders, camera, parted.options, context));
        });
        const Sight& sight = lines->sight;
        const LightView* from_light = style.shadow.cast && *light ? &**light : nullptr;
        return std::make_shared<Partition>(
            find_regions(parted.box, {sight.features(), sight.feature_spans()}, *occluders,
                         *casters, camera, parted.options, from_light, *normals, context));
      });
      if (pointed_at && options.annotations->callouts) {
        labels.whole = labels.areas;
        std::ranges::move(silhouettes(*parts), std::back_inserter(labels.whole));
      }
      std::ranges::move(areas_of(*parts, parted.options, nested_fills(part_styles)),
                        std::back_inserter(labels.areas));
    }
  }
  if (style.shadow.ground && *light) {
    labels.shadow = *shadow_.get(shaded, [&] {
      return std::make_shared<std::optional<Area>>(
          ground_shadow(*casters, **light, camera, context));
    });
  }
  return labels;
}

Drawing Stages::draw_lines(const Scene& scene, const Camera& camera, const Style& style,
                           const PartStyles& part_styles, const IllustrateOptions& options,
                           Judged* judged, Labels& labels, bool keeps, RunContext& context) {
  Diagnostics said;
  const Surfaces surfaces = realised_.realise(scene, camera, part_styles, options, said, context);
  context.begin_stage(RunStage::Build);
  const auto sizes = sizes_.get(
      surfaces, [&] { return std::make_shared<const std::vector<double>>(sizes_of(surfaces)); });
  const Solid solid{surfaces, transparent_ones(part_styles), part_styles.meeting_ranks(*sizes)};
  const std::shared_ptr<const Occluders> trees = occluders_.get(solid, [&] {
    return std::make_shared<Occluders>(solid.surfaces, solid.transparent, solid.ranks, context);
  });
  const auto proxies = trees->proxies();
  Drawing drawing = describe(scene, proxies, camera, style, options.seed);
  drawing.diagnostics.append(said);

  const DepthCue cue(proxies, camera, style);
  const HatchedParts::Hatchings hatchings =
      hatched_.hatch(trees, camera, part_styles, cue, style.depth, options, keeps, context);
  MissingDirections missing_directions(scene);
  for (const auto& one : hatchings) {
    if (one->missing_directions) missing_directions.add(*one->missing_directions);
  }
  missing_directions.report(drawing.diagnostics);
  report_failed(hatchings, drawing.diagnostics);
  StrokeResult totals = stroke_totals(hatchings);
  drawing.stats.coverage_points = totals.coverage_points;
  drawing.stats.coverage_delta = totals.coverage_delta;
  if (states_gamma(part_styles)) drawing.stats.tone_gamma = totals.tone_gamma;

  context.begin_stage(RunStage::Features);
  View view{trees,
            camera,
            feature_options(part_styles),
            draws_outline(part_styles),
            options.trails,
            drawn_threads(scene, part_styles),
            options.magnified,
            drawn_isophotes(part_styles, camera)};
  if (!view.isophotes.empty()) view.pen = style.line.crease;
  const std::shared_ptr<Lines> features = lines_of(view, context);
  drawing.diagnostics.append(features->said);

  context.begin_stage(RunStage::Visibility);
  const AllStrokes all(hatchings);
  const std::shared_ptr<Spans> spans = seen_.get({features, hatchings}, [&] {
    return std::make_shared<Spans>(features->sight.classify(all.strokes(), context));
  });
  report_bounds(totals, features->sight.merged_cuts(), drawing.diagnostics);
  report_unmapped(scene, std::move(totals.unmapped), drawing.diagnostics);
  report_unused(part_styles, options, drawing.diagnostics);
  report_solid_glass(scene, part_styles, drawing.diagnostics);

  context.begin_stage(RunStage::Compose);
  const std::vector<Curve3> centres =
      centre_lines_of(*trees, camera, part_styles, options.hidden, drawing.diagnostics, context);
  const LinesToDraw to_draw{features->sight.features(), features->sight.feature_spans(),
                            all.strokes(), *spans, centres};
  compose(to_draw, {proxies, camera, part_styles, style, options.hidden, cue}, drawing, context,
          judged ? &judged->found : nullptr);
  if (judged) judged->ranks = trees->ranks();
  if (options.field) name_own_field(drawing);
  const Solid casting{surfaces, without_shadow(part_styles, solid.transparent), solid.ranks};
  const auto casters = casting == solid ? trees : casters_.get(casting, [&] {
    return std::make_shared<Occluders>(surfaces, casting.transparent, casting.ranks, context);
  });
  labels = labels_of(scene, drawing, features,
                     {trees, casters, tone::to_light(camera, style.tone), camera}, style,
                     part_styles, options, context);
  const PaperBreaks& breaks = options.broken.breaks;
  labels.cut = cut_stretches(proxies, part_styles, camera, breaks, drawing.diagnostics);
  lay_pmi(scene, part_styles, {camera, breaks, options.view_name}, trees->solid(), style, drawing);
  context.end_stage();
  return drawing;
}

Drawing Stages::draw(const Scene& scene, const Camera& camera, const Style& style,
                     const IllustrateOptions& options, bool keeps, RunContext& context) {
  try {
    return draw_all(scene, camera, style, options, keeps, context);
  } catch (const PluginError& e) {
    *this = {};
    IllustrateOptions without = options;
    const std::size_t left = leave_out(scene, e, without);
    if (left == 0 || std::ranges::none_of(without.part_styles, &PartStyle::drawn)) throw;
    Drawing drawing = draw(scene, camera, style, without, keeps, context);
    drawing.diagnostics.add(Severity::Warning, "plugin.quarantined",
                            static_cast<std::int64_t>(left),
                            std::string(e.what()) + "; the drawing goes on without its parts");
    return drawing;
  }
}

Drawing Stages::draw_all(const Scene& scene, const Camera& camera, const Style& style,
                         const IllustrateOptions& options, bool keeps, RunContext& context) {
  if (scene.parts.empty()) throw GeometryError("nothing to draw: the input has no parts");
  const PartStyles part_styles(scene, style, options);
  for (const Style* one : part_styles.styles()) check_style(*one);
  Judged judged;
  Labels labels;
  Drawing drawing = draw_lines(scene, camera, style, part_styles, options,
                               options.verify ? &judged : nullptr, labels, keeps, context);
  if (!keeps) *this = {};
  if (options.verify) {
    drawing.stats.verify = verify(
        drawing, judged.found, scene, camera,
        verify_options(scene, camera, style, part_styles, options, judged.ranks, labels.areas),
        drawing.diagnostics, context);
  }
  break_drawing(camera, options.broken, style.broken, labels, drawing);
  settle_on_sheet(part_styles, style.sheet.clip, drawing);
  if (options.annotations && labels.whole.empty()) labels.whole = labels.areas;
  std::vector<Area> letters = std::exchange(drawing.areas, std::move(labels.areas));
  hatch_areas(scene, part_styles, "", drawing, context);
  if (paints(part_styles) || hatches(part_styles)) paint_areas(scene, part_styles, drawing);
  if (style.shadow.cast) shade_areas(style, drawing.areas);
  if (labels.shadow && style.sheet.clip) cut_at_sheet(*labels.shadow, drawing);
  if (labels.shadow && !labels.shadow->rings.empty()) {
    lay_shadow(std::move(*labels.shadow), style, part_styles, drawing.areas);
  }
  std::ranges::move(letters, std::back_inserter(drawing.areas));
  lay_dimensions(drawing, camera_on_sheet(camera, options.broken), options.dimensions,
                 style.dimension);
  if (options.annotations) {
    annotate(drawing, labels.whole, with_seen_rows(scene, style, options, drawing), style.callout,
             context);
    divide_squares(scene, style, options, drawing);
    hatch_areas(scene, part_styles, "legend", drawing, context);
  }
  return drawing;
}

}  // namespace burin::detail
