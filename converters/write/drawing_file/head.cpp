#include <burin/base/error.h>
#include <burin/drawing/color.h>

#include "values.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

using Json = JsonPlace::Json;

DrawingItem read_item(const JsonPlace& place) {
  place.check_object();
  DrawingItem item;
  place.required("number", [&](const JsonPlace& number) { number.set(item.number); });
  place.member("name", item.name);
  place.member("color", item.color);
  place.member("source", item.source);
  place.each_of("parts",
                [&](const JsonPlace& part, std::size_t) { part.set(item.parts.emplace_back()); });
  place.each_of("selectors",
                [&](const JsonPlace& one, std::size_t) { one.set(item.selectors.emplace_back()); });
  return item;
}

void read_ink(const JsonPlace& place, std::string& name) {
  place.set(name);
  if (const std::string fault = fault_of_ink(name); !fault.empty()) place.fail(fault);
}

SpotInk read_spot_ink(const JsonPlace& place, const std::vector<SpotInk>& known) {
  place.check_object();
  SpotInk ink;
  place.required("name", [&](const JsonPlace& name) {
    read_ink(name, ink.name);
    if (std::ranges::find(known, ink.name, &SpotInk::name) != known.end()) {
      name.fail(fmt::format("is '{}', as that of another ink", ink.name));
    }
  });
  place.required("color", [&](const JsonPlace& color) { read_color(color, ink.color); });
  return ink;
}

/// That the inks of areas are known.
void check_inks(const JsonPlace& root, const Drawing& drawing) {
  root.each_of("areas", [&](const JsonPlace& area, std::size_t i) {
    const std::string& name = drawing.areas[i].ink;
    const auto& inks = drawing.inks;
    if (name.empty() || std::ranges::find(inks, name, &SpotInk::name) != inks.end()) return;
    area.optional("ink", [&](const JsonPlace& ink) {
      ink.fail(fmt::format("'{}' is an ink that the drawing does not list", name));
    });
  });
}

Area read_area(const JsonPlace& place) {
  place.check_object();
  Area area;
  place.required("part", [&](const JsonPlace& part) { part.set(area.part); });
  place.member("face", area.face);
  place.member("tone", area.tone);
  place.optional("fill", [&](const JsonPlace& fill) { read_color(fill, area.fill); });
  place.optional("opacity", [&](const JsonPlace& opacity) {
    opacity.set(area.opacity);
    if (!(area.opacity >= 0 && area.opacity <= 1)) opacity.fail("takes an opacity from 0 to 1");
  });
  place.optional("ink", [&](const JsonPlace& ink) { read_ink(ink, area.ink); });
  place.optional("tint", [&](const JsonPlace& tint) {
    tint.set(area.tint);
    if (!(area.tint >= 0 && area.tint <= 1)) tint.fail("takes a share of an ink, from 0 to 1");
  });
  place.member("role", area.role);
  place.each_of("rings", [&](const JsonPlace& ring, std::size_t) {
    if (ring.size() < 3) ring.fail(fmt::format("holds {} points; a ring has 3", ring.size()));
    read_points(ring, area.rings.emplace_back());
  });
  return area;
}

void read_breaks(const JsonPlace& place, PaperBreaks& breaks) {
  place.check_object();
  place.member("along", breaks.along);
  place.each_of("bands", [&](const JsonPlace& band, std::size_t) {
    Vec2 sides(0);
    band.set(sides);
    const double last = breaks.bands.empty() ? sides.x : breaks.bands.back().high;
    if (!(sides.x < sides.y) || sides.x < last) band.fail("takes bands that ascend, [low, high]");
    breaks.bands.push_back({sides.x, sides.y});
  });
  place.member("gap", breaks.gap);
  place.member("offset", breaks.offset);
}

void read_view(const JsonPlace& place, DrawingView& view) {
  place.check_object();
  place.member("projection", view.projection);
  place.member("direction", view.direction);
  place.member("right", view.right);
  place.member("up", view.up);
  place.member("scale", view.scale);
  place.member("center", view.center);
  place.member("offset", view.offset);
  place.member("eye", view.eye);
  place.member("field_of_view", view.field_of_view);
  place.optional("breaks", [&](const JsonPlace& at) { read_breaks(at, view.breaks); });
}

SheetView read_sheet_view(const JsonPlace& place) {
  place.check_object();
  SheetView view;
  place.member("name", view.name);
  place.required("view", [&](const JsonPlace& at) { read_view(at, view.view); });
  place.optional("box", [&](const JsonPlace& box) {
    std::vector<Vec2> corners;
    read_points(box, corners);
    for (const Vec2& corner : corners) view.box.add(corner);
  });
  return view;
}

DrawingPart read_part(const JsonPlace& place) {
  place.check_object();
  DrawingPart part;
  place.member("id", part.id);
  place.member("name", part.name);
  place.member("source", part.source);
  place.member("triangles", part.triangles);
  place.member("faces", part.faces);
  place.member("color", part.color);
  place.each_of("assembly", [&](const JsonPlace& name, std::size_t) {
    name.set(part.assembly.emplace_back());
  });
  return part;
}

Diagnostic read_diagnostic(const JsonPlace& place) {
  place.check_object();
  Diagnostic d;
  std::string severity = to_string(d.severity);
  place.member("severity", severity);
  place.member("code", d.code);
  place.member("count", d.count);
  place.member("message", d.message);
  for (const Severity s : {Severity::Info, Severity::Warning, Severity::Error}) {
    if (severity == to_string(s)) d.severity = s;
  }
  return d;
}

Contradiction read_contradiction(const JsonPlace& place) {
  place.check_object();
  Contradiction c;
  place.member("what", c.what);
  place.optional("kind", [&](const JsonPlace& kind) { c.kind = kind_named(kind); });
  place.member("part", c.source.part);
  place.member("face", c.source.face);
  place.member("edge", c.source.edge);
  place.member("length", c.length);
  place.member("size", c.size);
  place.member("at", c.at);
  place.member("model", c.model);
  return c;
}

Verification read_verification(const JsonPlace& place) {
  place.check_object();
  Verification v;
  place.member("spans", v.spans);
  place.member("length", v.length);
  place.member("contradicted", v.contradicted);
  place.member("count", v.count);
  place.member("loose_ends", v.loose_ends);
  place.member("area", v.area);
  place.member("wrong_area", v.wrong_area);
  place.member("wrong_patches", v.wrong_patches);
  place.each_of("contradictions", [&](const JsonPlace& one, std::size_t) {
    v.contradictions.push_back(read_contradiction(one));
  });
  return v;
}

void read_paper(const JsonPlace& place, Drawing& drawing) {
  place.check_object();
  const auto side = [&](const char* key, double& out) {
    place.required(key, [&](const JsonPlace& at) {
      at.set(out);
      if (!(out > 0) || out > kLargestSheet) at.fail("takes a side over 0 and up to 10000 mm");
    });
  };
  side("width", drawing.paper_width);
  side("height", drawing.paper_height);
  place.optional("unit", [](const JsonPlace& unit) {
    if (unit.value() != "mm") unit.fail("takes \"mm\"");
  });
  const auto color = [&](const char* key, std::string& out) {
    place.optional(key, [&](const JsonPlace& at) { read_color(at, out); });
  };
  color("ink_color", drawing.ink_color);
  color("sheet_color", drawing.paper_color);
}

}  // namespace

void check_version(const JsonPlace& place) {
  std::int32_t number = 0;
  place.set(number);
  if (number == 1) return;
  place.fail(fmt::format("is {}; this program reads version 1, a newer one may read it", number));
}

void read_head(const JsonPlace& root, Drawing& drawing) {
  if (!root.value().is_object() || root.value().value("format", Json()) != "burin-drawing") {
    throw InputError("is no drawing file: \"format\": \"burin-drawing\" is missing");
  }
  root.required("version", check_version);
  root.required("paper", [&](const JsonPlace& paper) { read_paper(paper, drawing); });
  root.member("seed", drawing.seed);
  root.member("title", drawing.title);
  root.member("style", drawing.style);
  root.optional("view", [&](const JsonPlace& view) { read_view(view, drawing.view); });
  root.each_of("views", [&](const JsonPlace& one, std::size_t) {
    drawing.views.push_back(read_sheet_view(one));
  });
  root.each_of("parts", [&](const JsonPlace& part, std::size_t) {
    drawing.parts.push_back(read_part(part));
  });
  root.each_of("items", [&](const JsonPlace& item, std::size_t) {
    drawing.items.push_back(read_item(item));
  });
  root.each_of("areas", [&](const JsonPlace& area, std::size_t) {
    drawing.areas.push_back(read_area(area));
  });
  root.each_of("inks", [&](const JsonPlace& one, std::size_t) {
    drawing.inks.push_back(read_spot_ink(one, drawing.inks));
  });
  check_inks(root, drawing);
  root.each_of("diagnostics", [&](const JsonPlace& d, std::size_t) {
    drawing.diagnostics.add(read_diagnostic(d));
  });
  root.optional("stats", [&](const JsonPlace& stats) {
    stats.check_object();
    stats.member("triangles", drawing.stats.triangles);
    stats.member("strokes", drawing.stats.strokes);
    stats.member("coverage_points", drawing.stats.coverage_points);
    stats.member("coverage_delta", drawing.stats.coverage_delta);
    stats.optional("tone_gamma",
                   [&](const JsonPlace& at) { at.set(drawing.stats.tone_gamma.emplace()); });
    stats.optional("verify",
                   [&](const JsonPlace& at) { drawing.stats.verify = read_verification(at); });
  });
}

}  // namespace burin
