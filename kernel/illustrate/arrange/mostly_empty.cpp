#include "mostly_empty.h"

#include <burin/base/box.h>
#include <burin/camera/view_grid.h>
#include <burin/drawing/font.h>

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {
namespace {

/// How many times as large a drawing at a scale that was asked for could be.
constexpr double kMuchLarger = 5;
/// Share of the sheet that a fitted drawing takes at least.
constexpr double kLittle = 0.05;

Box2 ink_box(const Drawing& drawing) {
  Box2 box;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) box.add(p);
    }
    for (const Text& text : layer.texts) box.add(text_box(text));
  }
  return box;
}

/// What is reported about the sheet already.
bool is_reported(const Drawing& drawing) {
  return std::ranges::any_of(drawing.diagnostics.entries(), [](const Diagnostic& d) {
    return d.code == "drawing.empty" || d.code == "sheet.outside" || d.code == "sheet.dot" ||
           d.code == "sheet.clipped";
  });
}

/// Whether the shadow on the ground takes most of what is drawn.
bool has_shadow(const Drawing& drawing) {
  Box2 parts, shadow;
  for (const Area& area : drawing.areas) {
    if (!area.role.empty()) continue;
    for (const std::vector<Vec2>& ring : area.rings) {
      for (const Vec2& p : ring) (area.part < 0 ? shadow : parts).add(p);
    }
  }
  const auto size = [](const Box2& box) { return std::max(box.size().x, box.size().y); };
  return size(shadow) > 2 * size(parts);
}

}  // namespace

void report_mostly_empty(const Illustration& illustration, Drawing& drawing) {
  const Box2 ink = ink_box(drawing);
  if (illustration.sheet.fits || ink.empty() || is_reported(drawing)) return;
  const Vec2 sheet(drawing.paper_width, drawing.paper_height);
  const Margin& margin = illustration.sheet.margin;
  const Vec2 room = sheet - Vec2(margin.left + margin.right, margin.top + margin.bottom);
  const Vec2 size = glm::max(ink.size(), Vec2(1e-6));
  const double larger = std::min(room.x / size.x, room.y / size.y);
  const double share = size.x * size.y / (sheet.x * sheet.y);
  const bool scaled = illustration.view.scale.has_value();
  if (scaled ? larger < kMuchLarger : share >= kLittle) return;
  const std::string fills =
      scaled ? fmt::format("a `scale` of {} would fill it, ",
                           scale_text(standard_scale(*illustration.view.scale * larger)))
             : std::string();
  drawing.diagnostics.add(
      Severity::Warning, "sheet.mostly_empty", 1,
      fmt::format("the drawing takes {:.0f} x {:.0f} mm of a sheet of {:g} x {:g} mm, {:.2g} % of "
                  "it: {}`paper fit` makes the sheet as large as the drawing",
                  size.x, size.y, sheet.x, sheet.y, 100 * share, fills) +
          (has_shadow(drawing) ? "; its shadow on the ground takes most: `light` from higher up "
                                 "makes it short, `set` shadow.ground=false leaves it out"
                               : ""));
}

}  // namespace burin::detail
