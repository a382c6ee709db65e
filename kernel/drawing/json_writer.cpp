#include <burin/base/version.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/ordered_text.h>
#include <burin/drawing/writers.h>

#include "json_members.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace burin {
namespace {

using detail::append_json_verification;
using detail::append_json_view;
using detail::model_decimals;

/// Paper mm are written to 0.1 um, far below any printer.
constexpr int kPaperDecimals = 4;

/// Where it is not empty.
void append_text_of(Buffer& out, std::string_view key, const std::string& text) {
  if (text.empty()) return;
  fmt::format_to(fmt::appender(out), ", \"{}\": ", key);
  append_json(out, text);
}

/// That of a part, a layer or a line which has one for itself.
void append_color(Buffer& out, const std::string& color) { append_text_of(out, "color", color); }

void append_part(Buffer& out, const DrawingPart& part) {
  fmt::format_to(fmt::appender(out), "{{\"id\": {}, \"name\": ", part.id);
  append_json(out, part.name);
  append(out, ", \"source\": ");
  append_json(out, part.source);
  fmt::format_to(fmt::appender(out), ", \"triangles\": {}, \"faces\": {}", part.triangles,
                 part.faces);
  if (!part.assembly.empty()) {
    append(out, ", \"assembly\": [");
    for (std::size_t i = 0; i < part.assembly.size(); ++i) {
      if (i > 0) append(out, ", ");
      append_json(out, part.assembly[i]);
    }
    out.push_back(']');
  }
  append_color(out, part.color);
  out.push_back('}');
}

void append_item(Buffer& out, const DrawingItem& item) {
  fmt::format_to(fmt::appender(out), "{{\"number\": {}, \"name\": ", item.number);
  append_json(out, item.name);
  fmt::format_to(fmt::appender(out), ", \"quantity\": {}, \"color\": ", item.quantity());
  append_json(out, item.color);
  append(out, ", \"source\": ");
  append_json(out, item.source);
  fmt::format_to(fmt::appender(out), ", \"parts\": [{}]", fmt::join(item.parts, ", "));
  if (!item.selectors.empty()) {
    append(out, ", \"selectors\": ");
    append_json(out, item.selectors);
  }
  out.push_back('}');
}

void append_point(Buffer& out, Vec2 p) {
  out.push_back('[');
  append_fixed(out, p.x, kPaperDecimals);
  out.push_back(',');
  append_fixed(out, p.y, kPaperDecimals);
  out.push_back(']');
}

void append_sheet_view(Buffer& out, const SheetView& view) {
  append(out, "{\"name\": ");
  append_json(out, view.name);
  append(out, ", \"box\": [");
  append_point(out, view.box.min);
  out.push_back(',');
  append_point(out, view.box.max);
  append(out, "], \"view\": ");
  append_json_view(out, view.view);
  out.push_back('}');
}

void append_area(Buffer& out, const Area& area) {
  fmt::format_to(fmt::appender(out), "{{\"part\": {}", area.part);
  if (area.face >= 0) fmt::format_to(fmt::appender(out), ", \"face\": {}", area.face);
  if (area.tone >= 0) fmt::format_to(fmt::appender(out), ", \"tone\": {}", area.tone);
  if (!area.fill.empty()) {
    fmt::format_to(fmt::appender(out), ", \"fill\": \"{}\", \"opacity\": ", area.fill);
    append_exact(out, area.opacity);
  }
  if (!area.ink.empty()) {
    append_text_of(out, "ink", area.ink);
    append(out, ", \"tint\": ");
    append_exact(out, area.tint);
  }
  append_text_of(out, "role", area.role);
  append(out, ", \"rings\": [");
  for (std::size_t r = 0; r < area.rings.size(); ++r) {
    append(out, r == 0 ? "[" : ", [");
    for (std::size_t i = 0; i < area.rings[r].size(); ++i) {
      if (i > 0) out.push_back(',');
      append_point(out, area.rings[r][i]);
    }
    out.push_back(']');
  }
  append(out, "]}");
}

void append_spot_ink(Buffer& out, const SpotInk& ink) {
  append(out, "{\"name\": ");
  append_json(out, ink.name);
  append_color(out, ink.color);
  out.push_back('}');
}

void append_text(Buffer& out, const Text& text) {
  append(out, "{\"at\": ");
  append_point(out, text.at);
  append(out, ", \"height\": ");
  append_fixed(out, text.height, kPaperDecimals);
  fmt::format_to(fmt::appender(out), ", \"anchor\": \"{}\", \"text\": ", to_string(text.anchor));
  append_json(out, text.text);
  append(out, ", \"role\": ");
  append_json(out, text.role);
  fmt::format_to(fmt::appender(out), ", \"item\": {}", text.item);
  if (text.turn != 0) {
    append(out, ", \"turn\": ");
    append_exact(out, text.turn);
  }
  out.push_back('}');
}

void append_diagnostic(Buffer& out, const Diagnostic& d) {
  fmt::format_to(fmt::appender(out), "{{\"severity\": \"{}\", \"code\": ", to_string(d.severity));
  append_json(out, d.code);
  fmt::format_to(fmt::appender(out), ", \"count\": {}, \"message\": ", d.count);
  append_json(out, d.message);
  out.push_back('}');
}

/// "  "name": [a,\n    b],\n" with `one` for each element.
template <class List, class F>
void append_list(Buffer& out, std::string_view name, const List& list, const F& one) {
  fmt::format_to(fmt::appender(out), "  \"{}\": [", name);
  bool first = true;
  for (const auto& element : list) {
    append(out, first ? "\n    " : ",\n    ");
    first = false;
    one(out, element);
  }
  append(out, "],\n");
}

void append_head(Buffer& out, const Drawing& d) {
  fmt::format_to(
      fmt::appender(out),
      "{{\n  \"format\": \"burin-drawing\", \"version\": 1, \"generator\": \"burin {}\", "
      "\"seed\": {}, \"style\": ",
      version(), d.seed);
  append_json(out, d.style);
  append_text_of(out, "title", d.title);
  append(out, ",\n  \"paper\": {\"width\": ");
  append_exact(out, d.paper_width);
  append(out, ", \"height\": ");
  append_exact(out, d.paper_height);
  append(out, ", \"unit\": \"mm\"");
  const Drawing plain;
  if (d.ink_color != plain.ink_color || d.paper_color != plain.paper_color) {
    append(out, ", \"ink_color\": ");
    append_json(out, d.ink_color);
    append(out, ", \"sheet_color\": ");
    append_json(out, d.paper_color);
  }
  append(out, "},\n");
  append(out, "  \"view\": ");
  append_json_view(out, d.view);
  append(out, ",\n");
  if (!d.views.empty()) append_list(out, "views", d.views, append_sheet_view);
  append_list(out, "parts", d.parts, append_part);
  if (!d.items.empty()) append_list(out, "items", d.items, append_item);
  if (!d.areas.empty()) append_list(out, "areas", d.areas, append_area);
  if (!d.inks.empty()) append_list(out, "inks", d.inks, append_spot_ink);
  append(out, "  \"layers\": [");
}

void append_tail(Buffer& out, const Drawing& d, std::size_t left_out) {
  append(out, "],\n");
  std::vector<Diagnostic> entries = d.diagnostics.entries();
  if (left_out > 0) {
    entries.push_back({Severity::Warning, "drawing.not_finite", static_cast<std::int64_t>(left_out),
                       "paths with coordinates that are no finite numbers were left out"});
  }
  append_list(out, "diagnostics", entries, append_diagnostic);
  fmt::format_to(fmt::appender(out),
                 "  \"stats\": {{\"triangles\": {}, \"strokes\": {}, \"coverage_points\": {}, "
                 "\"coverage_delta\": ",
                 d.stats.triangles, d.stats.strokes, d.stats.coverage_points);
  append_exact(out, d.stats.coverage_delta);
  if (d.stats.tone_gamma) {
    append(out, ", \"tone_gamma\": ");
    append_exact(out, *d.stats.tone_gamma);
  }
  if (d.stats.verify) append_json_verification(out, *d.stats.verify);
  append(out, "}\n}\n");
}

void append_json_also(Buffer& out, const std::vector<PathSource>& also) {
  for (std::size_t i = 0; i < also.size(); ++i) {
    const SourceId& of = also[i].source;
    fmt::format_to(fmt::appender(out),
                   "{}{{\"part\": {}, \"face\": {}, \"edge\": {}, \"kind\": \"{}\"}}{}",
                   i == 0 ? ", \"also\": [" : ", ", of.part, of.face, of.edge,
                   to_string(also[i].kind), i + 1 == also.size() ? "]" : "");
  }
}

/// One path on one line.
void append_json_path(Buffer& out, const Path& p, bool points3, int decimals3) {
  fmt::format_to(fmt::appender(out),
                 "{{\"kind\": \"{}\", \"visible\": {}, \"part\": {}, \"face\": {}, \"edge\": {}, "
                 "\"closed\": {}",
                 to_string(p.kind), p.visible, p.source.part, p.source.face, p.source.edge,
                 p.closed);
  if (p.in_full) append(out, ", \"in_full\": true");
  if (p.item != 0) fmt::format_to(fmt::appender(out), ", \"item\": {}", p.item);
  append_color(out, p.color);
  if (p.kind == LineClass::Stroke) {
    append(out, ", \"field\": ");
    append_json(out, p.field);
    fmt::format_to(fmt::appender(out), ", \"family\": {}", p.family);
    if (p.stroke_kind > 1) {
      fmt::format_to(fmt::appender(out), ", \"stroke_kind\": {}", p.stroke_kind);
    }
  }
  for (std::size_t i = 0; i < p.faces.size(); ++i) {
    fmt::format_to(fmt::appender(out), "{}[{},{}]{}", i == 0 ? ", \"faces\": [" : ",",
                   p.faces[i].first_point, p.faces[i].face, i + 1 == p.faces.size() ? "]" : "");
  }
  append_json_also(out, p.also);
  append(out, ", \"points\": [");
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    append(out, i == 0 ? "[" : ",[");
    append_fixed(out, p.points[i].x, kPaperDecimals);
    out.push_back(',');
    append_fixed(out, p.points[i].y, kPaperDecimals);
    out.push_back(']');
  }
  if (points3 && p.points3.size() == p.points.size()) {
    append(out, "], \"points3\": [");
    for (std::size_t i = 0; i < p.points3.size(); ++i) {
      append(out, i == 0 ? "[" : ",[");
      append_fixed(out, p.points3[i].x, decimals3);
      out.push_back(',');
      append_fixed(out, p.points3[i].y, decimals3);
      out.push_back(',');
      append_fixed(out, p.points3[i].z, decimals3);
      out.push_back(']');
    }
  }
  append(out, "], \"width\": [");
  for (std::size_t i = 0; i < p.width.size(); ++i) {
    if (i > 0) out.push_back(',');
    append_fixed(out, p.width[i], kPaperDecimals);
  }
  append(out, "]}");
}

/// Colour and dashes that a layer has for itself.
void append_look(Buffer& out, const Layer& layer) {
  append_color(out, layer.color);
  if (layer.dashes.empty()) return;
  append(out, ", \"dashes\": [");
  for (std::size_t i = 0; i < layer.dashes.size(); ++i) {
    if (i > 0) out.push_back(',');
    append_fixed(out, layer.dashes[i], kPaperDecimals);
  }
  out.push_back(']');
}

void write(const Buffer& text, std::ostream& out) {
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace

void write_json(const Drawing& drawing, const JsonOptions& options, std::ostream& out,
                const RunContext& context) {
  const int decimals3 = model_decimals(drawing);
  Buffer text;
  append_head(text, drawing);
  write(text, out);
  std::size_t left_out = 0;
  for (std::size_t l = 0; l < drawing.layers.size(); ++l) {
    const Layer& layer = drawing.layers[l];
    std::vector<const Path*> paths;
    for (const Path& p : layer.paths) {
      if (is_finite(p)) paths.push_back(&p);
    }
    left_out += layer.paths.size() - paths.size();
    text.clear();
    append(text, l == 0 ? "\n    {\"name\": " : ",\n    {\"name\": ");
    append_json(text, layer.name);
    append_look(text, layer);
    append(text, ", \"paths\": [");
    write(text, out);
    write_ordered(
        paths.size(), [&](std::size_t i) { return paths[i]->points.size(); },
        [&](std::size_t i, Buffer& buffer) {
          append(buffer, i == 0 ? "\n      " : ",\n      ");
          append_json_path(buffer, *paths[i], options.points3, decimals3);
        },
        out, context);
    text.clear();
    append(text, "]");
    if (!layer.texts.empty()) {
      append(text, ", \"texts\": [");
      for (std::size_t i = 0; i < layer.texts.size(); ++i) {
        append(text, i == 0 ? "\n      " : ",\n      ");
        append_text(text, layer.texts[i]);
      }
      append(text, "]");
    }
    append(text, "}");
    write(text, out);
  }
  text.clear();
  append_tail(text, drawing, left_out);
  write(text, out);
}

}  // namespace burin
