#include "on_sheet.h"

#include <burin/base/box.h>
#include <burin/drawing/clip.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm: a drawing that is no larger is a dot.
constexpr double kDot = 1;
// Paper mm that a line may pass the edge and still is on the sheet: rounding of a drawing that
// fills it.
constexpr double kEdge = 0.01;

bool draws_anything(const Style& s) {
  const auto& f = s.feature;
  return has_strokes(s) || f.contours || f.creases || f.boundaries || f.smooth || f.seams ||
         f.intersections || f.isophotes > 0;
}

std::string why_empty(const PartStyles& part_styles) {
  bool any_part = false, any_line = false;
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    any_part = any_part || part_styles.drawn(i);
    any_line = any_line || (part_styles.drawn(i) && draws_anything(part_styles.style(i)));
  }
  if (!any_part) return "every part is left out";
  if (!any_line)
    return "the style has neither feature lines (feature.*) nor strokes (hatch.enabled)";
  return "no line of the model is seen from this view; try another one";
}

// Millimetres in two or three digits, never as a power of ten.
std::string mm(double x) {
  return std::abs(x) >= 10 || x == 0 ? fmt::format("{:.0f}", x) : fmt::format("{:.2g}", x);
}

Box2 bounds(const Drawing& drawing) {
  Box2 box;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) box.add(p);
    }
  }
  return box;
}

}  // namespace

void settle_on_sheet(const PartStyles& part_styles, bool clip, Drawing& drawing) {
  const Box2 ink = bounds(drawing);
  const auto warn = [&](const char* code, const std::string& message) {
    drawing.diagnostics.add(Severity::Warning, code, 1, message);
  };
  if (ink.empty()) return warn("drawing.empty", "nothing is drawn: " + why_empty(part_styles));
  const Vec2 size(drawing.paper_width, drawing.paper_height);
  const Box2 sheet{Vec2(-kEdge), size + kEdge};
  const Vec2 extent = ink.size();
  if (std::max(extent.x, extent.y) < kDot) {
    warn("sheet.dot", fmt::format("the drawing is no larger than a dot, {:.2g} x {:.2g} mm on the "
                                  "sheet: give a larger scale, or none to fit the sheet",
                                  extent.x, extent.y));
  }
  if (!ink.overlaps(sheet)) {
    warn("sheet.outside",
         fmt::format("nothing of the drawing lies on the sheet of {:g} x {:g} mm: it reaches from "
                     "{}, {} to {}, {}; change the centre or the scale",
                     size.x, size.y, mm(ink.min.x), mm(ink.min.y), mm(ink.max.x), mm(ink.max.y)));
    if (clip) clip_to(sheet, drawing);
    return;
  }
  const bool inside = ink.min.x >= sheet.min.x && ink.min.y >= sheet.min.y &&
                      ink.max.x <= sheet.max.x && ink.max.y <= sheet.max.y;
  if (inside || !clip) return;
  clip_to(sheet, drawing);
  const double smaller = std::min(size.x / extent.x, size.y / extent.y);
  warn("sheet.clipped",
       fmt::format("the drawing is {} x {} mm, the sheet {:g} x {:g} mm: what runs off it "
                   "is cut ({}; sheet.clip=false keeps it)",
                   mm(extent.x), mm(extent.y), size.x, size.y,
                   smaller < 1 ? fmt::format("scale {:.2g} or less would hold it all",
                                             0.95 * smaller * drawing.view.scale)
                               : "another centre would hold it all"));
}

void cut_at_sheet(Area& area, const Drawing& drawing) {
  Drawing alone;
  alone.areas.push_back(std::move(area));
  clip_to({Vec2(0), Vec2(drawing.paper_width, drawing.paper_height)}, alone);
  area = alone.areas.empty() ? Area{.rings = {}} : std::move(alone.areas.front());
}

}  // namespace burin::detail
