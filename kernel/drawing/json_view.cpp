#include "json_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

/// Decimals of model mm that hold a millionth of a paper mm.
int model_decimals(const DrawingView& view) {
  if (!(view.scale > 0) || !std::isfinite(view.scale)) return 9;
  const int decimals = std::clamp(static_cast<int>(std::ceil(std::log10(view.scale))) + 6, 0, 15);
  // Nearer to the viewer than the centre a perspective drawing is larger: one decimal more.
  return std::min(15, decimals + (view.projection == "perspective" ? 1 : 0));
}

void append_key(Buffer& out, std::string_view key) {
  fmt::format_to(fmt::appender(out), "\"{}\": ", key);
}

void append_exact_pair(Buffer& out, double a, double b) {
  append(out, "[");
  append_exact(out, a);
  append(out, ", ");
  append_exact(out, b);
  append(out, "]");
}

void append_breaks(Buffer& out, const PaperBreaks& breaks) {
  append(out, ", \"breaks\": {\"along\": ");
  append_exact_pair(out, breaks.along.x, breaks.along.y);
  append(out, ", \"bands\": [");
  const char* between = "";
  for (const PaperBreaks::Band& band : breaks.bands) {
    append(out, between);
    append_exact_pair(out, band.low, band.high);
    between = ", ";
  }
  append(out, "], \"gap\": ");
  append_exact(out, breaks.gap);
  append(out, ", \"offset\": ");
  append_exact_pair(out, breaks.offset.x, breaks.offset.y);
  append(out, "}");
}

void append_member(Buffer& out, std::string_view key, Vec3 v) {
  append_key(out, key);
  append_json_vec(out, v);
  append(out, ", ");
}

}  // namespace

int model_decimals(const Drawing& drawing) {
  int decimals = model_decimals(drawing.view);
  for (const SheetView& one : drawing.views)
    decimals = std::max(decimals, model_decimals(one.view));
  return decimals;
}

void append_json_vec(Buffer& out, Vec3 v) {
  out.push_back('[');
  append_exact(out, v.x);
  append(out, ", ");
  append_exact(out, v.y);
  append(out, ", ");
  append_exact(out, v.z);
  out.push_back(']');
}

void append_json_view(Buffer& out, const DrawingView& view) {
  append(out, "{\"projection\": ");
  append_json(out, view.projection);
  append(out, ", ");
  append_member(out, "direction", view.direction);
  append_member(out, "right", view.right);
  append_member(out, "up", view.up);
  append_key(out, "scale");
  append_exact(out, view.scale);
  append(out, ", ");
  append_member(out, "center", view.center);
  append(out, "\"offset\": [");
  append_exact(out, view.offset.x);
  append(out, ", ");
  append_exact(out, view.offset.y);
  append(out, "]");
  if (view.projection == "perspective") {
    append(out, ", ");
    append_member(out, "eye", view.eye);
    append_key(out, "field_of_view");
    append_exact(out, view.field_of_view);
  }
  if (!view.breaks.empty()) append_breaks(out, view.breaks);
  append(out, "}");
}

}  // namespace burin::detail
