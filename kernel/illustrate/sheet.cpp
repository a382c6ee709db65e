#include <burin/base/short_list.h>
#include <burin/drawing/views.h>
#include <burin/illustrate/ground.h>
#include <burin/illustrate/legend.h>
#include <burin/illustrate/sheet.h>

#include "broken.h"
#include "fill/hatch_areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Parts that a message names.
constexpr std::size_t kNamed = 3;

/// Lines of sections and details that are laid over a view when all are drawn.
std::vector<std::vector<Vec2>> lines_over(const PlacedView& view, const SheetOfViews& sheet,
                                          const CalloutOptions& style) {
  std::vector<std::vector<Vec2>> lines;
  const auto add = [&](std::vector<Vec2> line) {
    if (view.box.contains(line.front())) lines.push_back(std::move(line));
  };
  for (const SectionMark& mark : sheet.section_marks) {
    for (std::vector<Vec2>& line : lines_of(mark, style)) add(std::move(line));
  }
  for (const DetailMark& mark : sheet.details) add(line_of(mark));
  return lines;
}

/// What of the options holds for one view of several.
IllustrateOptions options_of(const PlacedView& view, const SheetOfViews& sheet,
                             const CalloutOptions& style, const IllustrateOptions& all) {
  IllustrateOptions options = all;
  options.magnified = view.magnified;
  options.view_name = view.name;
  options.dimensions = view.dimensions;
  options.dimensions.over_it = lines_over(view, sheet, style);
  if (view.none_hidden) options.hidden = HiddenLines::None;
  if (view.within) {
    const auto& [center, radius] = *view.within;
    options.shown = {center - radius, center + radius};
    options.annotations.reset();
  }
  options.dimensions.within = view.box;
  if (!options.annotations) return options;
  options.annotations->callouts = all.annotations->callouts && view.callouts;
  options.annotations->parts_list = false;  // one a sheet
  options.annotations->legend.clear();
  options.annotations->title_block.reset();
  options.annotations->margin = margin_about(view.box, view.camera.paper());
  options.annotations->over_it = options.dimensions.over_it;
  const Paper& paper = view.camera.paper();
  options.dimensions.within = inside(paper, annotation_margin(*options.annotations, style, paper));
  return options;
}

/// Whether a detail of parts shows nothing of them.
bool shows_none(const PlacedView& view, const Drawing& drawing) {
  if (view.shows.empty()) return false;
  const auto shows = [&](const SourceId& source) {
    return std::ranges::find(view.shows, static_cast<std::size_t>(source.part)) != view.shows.end();
  };
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!path.visible) continue;
      if (shows(path.source)) return false;
      for (const PathSource& other : path.also) {
        if (shows(other.source)) return false;
      }
    }
  }
  return true;
}

void report_empty(const PlacedView& view, Drawing& drawing) {
  if (drawing.layers.empty()) {
    drawing.diagnostics.add(Severity::Warning, "detail.empty", 1,
                            "detail " + view.name + " is empty: no line of the drawing is there");
  } else if (shows_none(view, drawing)) {
    drawing.diagnostics.add(
        Severity::Warning, "detail.not_shown", 1,
        "detail " + view.name + " shows no line of its parts: they are hidden in this view");
  }
}

/// A detail without the parts that stand before those it is there for.
std::optional<Drawing> draw_opened(const Scene& scene, const PlacedView& view, const Style& style,
                                   IllustrateOptions options, RunContext& context,
                                   Session& session) {
  const std::vector<std::size_t> gone = session.parts_before(view.shows, view.camera);
  if (gone.empty()) return std::nullopt;
  options.part_styles.resize(std::max(options.part_styles.size(), scene.parts.size()));
  for (const std::size_t part : gone) options.part_styles[part].drawn = false;
  Drawing drawing = session.draw(scene, view.camera, style, options, context);
  drawing.diagnostics.add(Severity::Info, "detail.opened", static_cast<std::int64_t>(gone.size()),
                          fmt::format("detail {} leaves out {}, behind which its parts are hidden",
                                      view.name, short_list(gone, kNamed, [&](std::size_t part) {
                                        return "'" + scene.parts[part].name + "'";
                                      })));
  return drawing;
}

Drawing draw_view(const Scene& whole_scene, const PlacedView& view, const Style& style,
                  IllustrateOptions options, RunContext& context, Session& session) {
  const Scene& scene = view.scene ? *view.scene : whole_scene;
  if (!view.within) {
    const Camera camera = detail::whole_camera(scene, view, style, options);
    return session.draw(scene, camera, style, options, context);
  }
  Style whole = style;
  whole.sheet.clip = false;  // the circle cuts it
  Drawing drawing = session.draw(scene, view.camera, whole, options, context);
  clip_to(*view.within, drawing);
  if (shows_none(view, drawing)) {
    if (auto opened = draw_opened(scene, view, whole, options, context, session)) {
      drawing = std::move(*opened);
      clip_to(*view.within, drawing);
    }
  }
  report_empty(view, drawing);
  return drawing;
}

/// Styles of parts change as the whole does: else they would seem to ask for something else.
Drawing draw_in_grid(const Scene& scene, const PlacedView& view, const Style& style,
                     IllustrateOptions options, RunContext& context, Session& session) {
  const Vec3 to_viewer = view.camera.direction();
  for (PartStyle& one : options.part_styles) {
    if (one.style) one.style = style_in_grid(*one.style, to_viewer);
  }
  return draw_view(scene, view, style_in_grid(style, to_viewer), options, context, session);
}

SheetView described(const PlacedView& view, const Drawing& drawing) {
  Box2 box = view.box;
  if (view.within) {
    const auto& [center, radius] = *view.within;
    box = {center - radius, center + radius};
  }
  return {view.name, drawing.view, box};
}

}  // namespace

Drawing illustrate(const Scene& scene, const SheetOfViews& sheet, const Style& style,
                   const IllustrateOptions& options, RunContext& context, Session* session) {
  if (sheet.plain()) {
    const PlacedView& view = sheet.views.front();
    const auto draw = [&](const Camera& camera, const IllustrateOptions& lone) {
      return session ? session->draw(scene, camera, style, lone, context)
                     : illustrate(scene, camera, style, lone, context);
    };
    if (view.dimensions.list.empty() && view.breaks.empty()) return draw(view.camera, options);
    IllustrateOptions lone = options;
    lone.dimensions = view.dimensions;
    const Camera camera = detail::whole_camera(scene, view, style, lone);
    return draw(camera, lone);
  }
  Session own;
  Session& kept = session ? *session : own;
  std::optional<Drawing> all;
  std::vector<SheetView> views;
  for (const PlacedView& view : sheet.views) {
    const IllustrateOptions here = options_of(view, sheet, style.callout, options);
    Drawing one = sheet.method ? draw_in_grid(scene, view, style, here, context, kept)
                               : draw_view(scene, view, style, here, context, kept);
    views.push_back(described(view, one));
    if (all) {
      append_view(*all, std::move(one));
    } else {
      all = std::move(one);
    }
  }
  all->views = std::move(views);
  if (!sheet.section_names.empty()) {
    lay_sections(*all, sheet.section_marks, sheet.section_names, style.callout);
  }
  if (!sheet.details.empty()) lay_details(*all, sheet.details, style.callout);
  if (sheet.symbol_at) {
    all->layers.push_back(projection_symbol(*sheet.method, *sheet.symbol_at, style.callout));
  }
  if (options.annotations) {
    Annotations over = with_seen_rows(scene, style, options, *all);
    if (over.title_block) over.title_block->method = sheet.method;
    lay_tables(*all, over, style.callout);
    detail::hatch_areas(scene, {scene, style, options}, "legend", *all, context);
  }
  return *std::move(all);
}

}  // namespace burin
