#include "tell.h"

#include <burin/tone/catalogue.h>

#include "fill/fills.h"
#include "style/style_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace burin::detail {
namespace {

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

}  // namespace

Drawing describe(const Scene& scene, std::span<const ProxyMesh* const> proxies,
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

void report_bounds(const StrokeResult& strokes, double merged_cuts, Diagnostics& diagnostics) {
  if (strokes.thinned_parts > 0) {
    diagnostics.add(Severity::Warning, "stroke.many_sheets", strokes.thinned_parts,
                    "parts lie in so many sheets over each other that strokes were begun at fewer "
                    "places; some areas may be white, and the file may be damaged");
  }
  if (merged_cuts > 0) {
    diagnostics.add(
        Severity::Warning, "visibility.crowded", 1,
        fmt::format(
            "the lines cross each other so often that what is hidden was decided for {:.2g} "
            "mm at a time; the file may be damaged, or show more than one sheet can hold",
            merged_cuts));
  }
}

void report_unmapped(const Scene& scene, std::vector<std::int32_t> parts,
                     Diagnostics& diagnostics) {
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

namespace {

// Of styles of some parts, what they have that holds for the whole drawing.
void report_whole_drawing_keys(const PartStyles& part_styles, bool annotated,
                               std::set<std::string>& reported) {
  const Style& whole = *part_styles.styles().front();
  for (const Style* style : part_styles.styles()) {
    std::vector<std::string> keys = keys_without_effect(*style, whole);
    if (!annotated)
      std::erase_if(keys, [](const auto& key) { return key.starts_with("callout."); });
    if (keys.empty()) continue;
    const bool ink = std::ranges::any_of(keys, [](const auto& key) { return key == "sheet.ink"; });
    reported.insert(fmt::format(
        "{} of style '{}', which some parts have, {} no effect: such keys hold for the whole "
        "drawing{}",
        fmt::join(keys, ", "), style->name, keys.size() > 1 ? "have" : "has",
        ink ? " (line.color is the colour of a part's lines)" : ""));
  }
}

}  // namespace

void report_solid_glass(const Scene& scene, const PartStyles& part_styles,
                        Diagnostics& diagnostics) {
  std::int64_t count = 0;
  const Part* first = nullptr;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const FillOptions& fill = part_styles.style(i).fill;
    const bool painted = part_styles.drawn(i) && fill.color == "part" && fill.opacity > 0;
    const Part& part = scene.parts[i];
    if (!painted || part_styles.transparent(i) || !has_solid_glass(part)) continue;
    if (count++ == 0) first = &part;
  }
  if (count == 0) return;
  diagnostics.add(Severity::Warning, "fill.solid_glass", count,
                  fmt::format("parts have faces of glass beside solid ones; these are painted as "
                              "solid: draw such a part whole as of glass (ghost) or make its glass "
                              "a part of its own; the first: '{}'",
                              first->name));
}

void report_unused(const PartStyles& part_styles, const IllustrateOptions& options,
                   Diagnostics& diagnostics) {
  std::set<std::string> reported;
  report_whole_drawing_keys(part_styles, options.annotations.has_value(), reported);
  for (const StrokeSet& strokes : part_styles.strokes()) {
    const HatchStyle& hatch = *strokes.hatch;
    const std::string group = kind_group(static_cast<std::size_t>(strokes.number));
    if (!takes_motif(hatch)) {
      const auto report = [&](const char* key) {
        reported.insert(
            fmt::format("{0}{1} has no effect: it is for strokes on points ({0}placing points, "
                        "discs), not {2}",
                        group, key, hatch.placing));
      };
      if (hatch.length_law != HatchOptions().length_law) report("length_law");
      if (hatch.has_motif()) report("motif");
    }
    const tone::ToneOptions& tone = *strokes.tone;
    if (!options.tone && tone.shadow > 0 && !tone::find(tone.law).uses_light) {
      reported.insert(fmt::format("{0}tone.shadow has no effect: {0}tone.law {1} looks at no light",
                                  strokes.number == 1 ? "" : group, tone.law));
    }
  }
  for (const std::string& text : reported) {
    diagnostics.add(Severity::Warning, "option.unused", 1, text);
  }
}

}  // namespace burin::detail
