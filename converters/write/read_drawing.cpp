#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/converters/read_drawing.h>
#include <burin/drawing/color.h>

#include "json_place.h"
#include "source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Json = nlohmann::json;

constexpr double kDefaultWidth = 0.25;  // mm, a thin line after ISO 128
constexpr double kLargestSheet = 10000;
/// Far past any sheet, near enough for every writer's arithmetic.
constexpr double kFarthest = 1e9;
constexpr int kDeepest = 100;

LineClass kind_named(const JsonPlace& place) {
  std::string name;
  place.set(name);
  std::vector<std::string> known;
  for (int i = 0; i <= static_cast<int>(kLastLineClass); ++i) {
    const auto kind = static_cast<LineClass>(i);
    if (name == to_string(kind)) return kind;
    known.emplace_back(to_string(kind));
  }
  place.fail(fmt::format("no such kind of line; the nearest is \"{}\"",
                         nearest(name.substr(0, 40), known)));
}

void read_points(const JsonPlace& place, std::vector<Vec2>& out) {
  out.reserve(place.size());
  place.each([&](const JsonPlace& point, std::size_t) {
    Vec2 p;
    point.set(p);
    if (std::max(std::abs(p.x), std::abs(p.y)) > kFarthest) {
      point.fail("is more than 1e9 mm from the sheet");
    }
    out.push_back(p);
  });
}

void read_width(const JsonPlace& place, std::size_t points, std::vector<double>& out) {
  const auto one = [&](const JsonPlace& width) {
    double w = 0;
    width.set(w);
    if (w < 0 || w > kLargestSheet) width.fail("takes a width from 0 to 10000 mm");
    out.push_back(w);
  };
  out.clear();
  if (place.value().is_number()) return one(place);
  out.reserve(place.size());
  place.each([&](const JsonPlace& width, std::size_t) { one(width); });
  if (out.size() > 1 && out.size() != points) {
    place.fail(fmt::format("holds {} numbers; takes one, or one for each of the {} points",
                           out.size(), points));
  }
}

PathSource read_also(const JsonPlace& place) {
  place.check_object();
  PathSource also;
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("part", also.source.part);
  value("face", also.source.face);
  value("edge", also.source.edge);
  place.optional("kind", [&](const JsonPlace& kind) { also.kind = kind_named(kind); });
  return also;
}

void read_faces(const JsonPlace& place, std::size_t points, std::vector<PathFace>& out) {
  place.each([&](const JsonPlace& run, std::size_t i) {
    if (!run.value().is_array() || run.size() != 2) run.fail("takes [first point, face]");
    PathFace face;
    JsonPlace(run.value()[0], run, std::size_t{0}).set(face.first_point);
    JsonPlace(run.value()[1], run, std::size_t{1}).set(face.face);
    const bool in_order =
        i == 0 ? face.first_point == 0 : face.first_point > out.back().first_point;
    if (!in_order || face.first_point >= std::max<std::size_t>(points, 1)) {
      run.fail("begins at a wrong point; runs begin at point 0 and follow each other");
    }
    out.push_back(face);
  });
}

void read_color(const JsonPlace& place, std::string& out) {
  place.set(out);
  if (!rgb_of(out)) place.fail("takes a colour #rrggbb");
}

Path read_path(const JsonPlace& place) {
  place.check_object();
  Path p;
  p.width = {kDefaultWidth};
  place.required("points", [&](const JsonPlace& points) { read_points(points, p.points); });
  const std::size_t n = p.points.size();
  place.optional("points3", [&](const JsonPlace& points) {
    p.points3.resize(points.size());
    points.each([&](const JsonPlace& point, std::size_t i) { point.set(p.points3[i]); });
    if (points.size() != n) points.fail(fmt::format("holds {} points of {}", points.size(), n));
  });
  place.optional("width", [&](const JsonPlace& width) { read_width(width, n, p.width); });
  place.optional("kind", [&](const JsonPlace& kind) { p.kind = kind_named(kind); });
  place.optional("faces", [&](const JsonPlace& faces) { read_faces(faces, n, p.faces); });
  place.optional("also", [&](const JsonPlace& also) {
    also.each([&](const JsonPlace& one, std::size_t) { p.also.push_back(read_also(one)); });
  });
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("visible", p.visible);
  value("in_full", p.in_full);
  value("part", p.source.part);
  value("face", p.source.face);
  value("edge", p.source.edge);
  value("closed", p.closed);
  value("item", p.item);
  place.optional("color", [&](const JsonPlace& color) { read_color(color, p.color); });
  value("field", p.field);
  value("family", p.family);
  value("stroke_kind", p.stroke_kind);
  return p;
}

Text read_text(const JsonPlace& place) {
  place.check_object();
  Text text;
  place.required("at", [&](const JsonPlace& at) {
    at.set(text.at);
    if (std::max(std::abs(text.at.x), std::abs(text.at.y)) > kFarthest) {
      at.fail("is more than 1e9 mm from the sheet");
    }
  });
  place.required("text", [&](const JsonPlace& words) { words.set(text.text); });
  place.optional("height", [&](const JsonPlace& height) {
    height.set(text.height);
    if (!(text.height > 0 && text.height <= kLargestSheet)) {
      height.fail("takes a height over 0 and up to 10000 mm");
    }
  });
  place.optional("anchor", [&](const JsonPlace& anchor) {
    std::string name;
    anchor.set(name);
    for (const TextAnchor a : {TextAnchor::Start, TextAnchor::Middle, TextAnchor::End}) {
      if (name == to_string(a)) return void(text.anchor = a);
    }
    anchor.fail("takes \"start\", \"middle\" or \"end\"");
  });
  place.optional("role", [&](const JsonPlace& role) { role.set(text.role); });
  place.optional("item", [&](const JsonPlace& item) { item.set(text.item); });
  return text;
}

DrawingItem read_item(const JsonPlace& place) {
  place.check_object();
  DrawingItem item;
  place.required("number", [&](const JsonPlace& number) { number.set(item.number); });
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("name", item.name);
  value("color", item.color);
  value("source", item.source);
  place.optional("parts", [&](const JsonPlace& parts) {
    parts.each([&](const JsonPlace& part, std::size_t) { part.set(item.parts.emplace_back()); });
  });
  place.optional("selectors", [&](const JsonPlace& selectors) {
    selectors.each(
        [&](const JsonPlace& one, std::size_t) { one.set(item.selectors.emplace_back()); });
  });
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
  root.optional("areas", [&](const JsonPlace& areas) {
    areas.each([&](const JsonPlace& area, std::size_t i) {
      const std::string& name = drawing.areas[i].ink;
      const auto& inks = drawing.inks;
      if (name.empty() || std::ranges::find(inks, name, &SpotInk::name) != inks.end()) return;
      area.optional("ink", [&](const JsonPlace& ink) {
        ink.fail(fmt::format("'{}' is an ink that the drawing does not list", name));
      });
    });
  });
}

Area read_area(const JsonPlace& place) {
  place.check_object();
  Area area;
  place.required("part", [&](const JsonPlace& part) { part.set(area.part); });
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("face", area.face);
  value("tone", area.tone);
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
  value("role", area.role);
  place.optional("rings", [&](const JsonPlace& rings) {
    rings.each([&](const JsonPlace& ring, std::size_t) {
      if (ring.size() < 3) ring.fail(fmt::format("holds {} points; a ring has 3", ring.size()));
      read_points(ring, area.rings.emplace_back());
    });
  });
  return area;
}

void read_view(const JsonPlace& place, DrawingView& view) {
  place.check_object();
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("projection", view.projection);
  value("direction", view.direction);
  value("right", view.right);
  value("up", view.up);
  value("scale", view.scale);
  value("center", view.center);
  value("offset", view.offset);
  value("eye", view.eye);
  value("field_of_view", view.field_of_view);
}

SheetView read_sheet_view(const JsonPlace& place) {
  place.check_object();
  SheetView view;
  place.optional("name", [&](const JsonPlace& name) { name.set(view.name); });
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
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("id", part.id);
  value("name", part.name);
  value("source", part.source);
  value("triangles", part.triangles);
  value("faces", part.faces);
  value("color", part.color);
  place.optional("assembly", [&](const JsonPlace& names) {
    names.each([&](const JsonPlace& name, std::size_t) { name.set(part.assembly.emplace_back()); });
  });
  return part;
}

Diagnostic read_diagnostic(const JsonPlace& place) {
  place.check_object();
  Diagnostic d;
  std::string severity = to_string(d.severity);
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("severity", severity);
  value("code", d.code);
  value("count", d.count);
  value("message", d.message);
  for (const Severity s : {Severity::Info, Severity::Warning, Severity::Error}) {
    if (severity == to_string(s)) d.severity = s;
  }
  return d;
}

Contradiction read_contradiction(const JsonPlace& place) {
  place.check_object();
  Contradiction c;
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("what", c.what);
  place.optional("kind", [&](const JsonPlace& kind) { c.kind = kind_named(kind); });
  value("part", c.source.part);
  value("face", c.source.face);
  value("edge", c.source.edge);
  value("length", c.length);
  value("size", c.size);
  value("at", c.at);
  value("model", c.model);
  return c;
}

Verification read_verification(const JsonPlace& place) {
  place.check_object();
  Verification v;
  const auto value = [&](const char* key, auto& out) {
    place.optional(key, [&](const JsonPlace& at) { at.set(out); });
  };
  value("spans", v.spans);
  value("length", v.length);
  value("contradicted", v.contradicted);
  value("count", v.count);
  value("loose_ends", v.loose_ends);
  value("area", v.area);
  value("wrong_area", v.wrong_area);
  value("wrong_patches", v.wrong_patches);
  place.optional("contradictions", [&](const JsonPlace& list) {
    list.each([&](const JsonPlace& one, std::size_t) {
      v.contradictions.push_back(read_contradiction(one));
    });
  });
  return v;
}

/// Lengths of ink and gaps in turn; all 0 would never end.
void read_dashes(const JsonPlace& place, std::vector<double>& out) {
  double sum = 0;
  place.each([&](const JsonPlace& length, std::size_t) {
    double mm = 0;
    length.set(mm);
    if (mm < 0 || mm > kLargestSheet) length.fail("takes a length from 0 to 10000 mm");
    sum += mm;
    out.push_back(mm);
  });
  if (out.size() % 2 != 0 || (!out.empty() && !(sum > 0))) {
    place.fail("takes lengths of dashes and gaps in turn, not all of them 0");
  }
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

void check_version(const JsonPlace& place) {
  std::int32_t number = 0;
  place.set(number);
  if (number == 1) return;
  place.fail(fmt::format("is {}; this program reads version 1, a newer one may read it", number));
}

/// Everything but the layers.
void read_head(const JsonPlace& root, Drawing& drawing) {
  if (!root.value().is_object() || root.value().value("format", Json()) != "burin-drawing") {
    throw InputError("is no drawing file: \"format\": \"burin-drawing\" is missing");
  }
  root.required("version", check_version);
  root.required("paper", [&](const JsonPlace& paper) { read_paper(paper, drawing); });
  root.optional("seed", [&](const JsonPlace& seed) { seed.set(drawing.seed); });
  root.optional("title", [&](const JsonPlace& title) { title.set(drawing.title); });
  root.optional("style", [&](const JsonPlace& style) { style.set(drawing.style); });
  root.optional("view", [&](const JsonPlace& view) { read_view(view, drawing.view); });
  root.optional("views", [&](const JsonPlace& views) {
    views.each(
        [&](const JsonPlace& one, std::size_t) { drawing.views.push_back(read_sheet_view(one)); });
  });
  root.optional("parts", [&](const JsonPlace& parts) {
    parts.each(
        [&](const JsonPlace& part, std::size_t) { drawing.parts.push_back(read_part(part)); });
  });
  root.optional("items", [&](const JsonPlace& items) {
    items.each(
        [&](const JsonPlace& item, std::size_t) { drawing.items.push_back(read_item(item)); });
  });
  root.optional("areas", [&](const JsonPlace& areas) {
    areas.each(
        [&](const JsonPlace& area, std::size_t) { drawing.areas.push_back(read_area(area)); });
  });
  root.optional("inks", [&](const JsonPlace& inks) {
    inks.each([&](const JsonPlace& one, std::size_t) {
      drawing.inks.push_back(read_spot_ink(one, drawing.inks));
    });
  });
  check_inks(root, drawing);
  root.optional("diagnostics", [&](const JsonPlace& list) {
    list.each(
        [&](const JsonPlace& d, std::size_t) { drawing.diagnostics.add(read_diagnostic(d)); });
  });
  root.optional("stats", [&](const JsonPlace& stats) {
    stats.check_object();
    const auto value = [&](const char* key, auto& out) {
      stats.optional(key, [&](const JsonPlace& at) { at.set(out); });
    };
    value("triangles", drawing.stats.triangles);
    value("strokes", drawing.stats.strokes);
    value("coverage_points", drawing.stats.coverage_points);
    value("coverage_delta", drawing.stats.coverage_delta);
    stats.optional("tone_gamma",
                   [&](const JsonPlace& at) { at.set(drawing.stats.tone_gamma.emplace()); });
    stats.optional("verify",
                   [&](const JsonPlace& at) { drawing.stats.verify = read_verification(at); });
  });
}

/// Takes each path and layer out of the parsed text as soon as it is whole: a tree of all values
/// would take ten times the memory of the drawing.
class LayerTaker {
 public:
  LayerTaker(std::vector<Layer>& layers, const RunContext& context)
      : layers_(layers), context_(context) {}

  using Event = Json::parse_event_t;
  /// nlohmann's parser callback; false drops the value.
  bool operator()(int depth, Event event, Json& value) {
    switch (event) {
      case Event::key:
        if (depth == kRoot + 1) root_key_ = value.get<std::string>();
        if (depth == kLayer + 1) layer_key_ = value.get<std::string>();
        break;
      case Event::object_start:
      case Event::array_start:
        if (depth > kDeepest) throw InputError(fmt::format("is nested deeper than {}", kDeepest));
        if (depth == kLayers && root_key_ == "layers") layers_.clear();
        if (depth == kLayer) layer_key_.clear();
        if (depth == kLayer || (depth == kPaths && layer_key_ == "paths")) paths_.clear();
        break;
      case Event::object_end:
        return !take(depth, value);
      case Event::array_end:
      case Event::value:
        // Before the layers, which may look otherwise in another version.
        if (depth == kRoot + 1 && root_key_ == "version")
          check_version(JsonPlace(value, "version"));
        if (depth == kPath && root_key_ == "layers" && layer_key_ == "paths") {
          JsonPlace(value, path_place()).check_object();
        }
        if (depth == kLayer && root_key_ == "layers") {
          JsonPlace(value, layer_place()).check_object();
        }
        break;
    }
    return true;
  }

 private:
  // The depths of the values on the way to a path.
  static constexpr int kRoot = 0, kLayers = 1, kLayer = 2, kPaths = 3, kPath = 4;

  std::string layer_place() const { return fmt::format("layers[{}]", layers_.size()); }
  std::string path_place() const {
    return layer_place() + fmt::format(".paths[{}]", paths_.size());
  }

  bool take(int depth, Json& value) {
    if (root_key_ != "layers") return false;
    if (depth == kPath && layer_key_ == "paths") {
      context_.check();
      paths_.push_back(read_path(JsonPlace(value, path_place())));
      return true;
    }
    if (depth != kLayer) return false;
    const JsonPlace place(value, layer_place());
    Layer layer;
    place.optional("name", [&](const JsonPlace& name) { name.set(layer.name); });
    place.optional("paths", [](const JsonPlace& paths) { paths.each([](const auto&, auto) {}); });
    layer.paths = std::exchange(paths_, {});
    place.optional("color", [&](const JsonPlace& color) { read_color(color, layer.color); });
    place.optional("dashes", [&](const JsonPlace& dashes) { read_dashes(dashes, layer.dashes); });
    place.optional("texts", [&](const JsonPlace& texts) {
      texts.each(
          [&](const JsonPlace& text, std::size_t) { layer.texts.push_back(read_text(text)); });
    });
    layers_.push_back(std::move(layer));
    return true;
  }

  std::vector<Layer>& layers_;
  const RunContext& context_;
  std::vector<Path> paths_;
  std::string root_key_, layer_key_;
};

/// What nlohmann says without its number and place: the line says where.
std::string reason(const Json::exception& e, std::string_view rest) {
  for (const std::string_view word : {"NaN", "nan", "Infinity", "inf"}) {
    if (rest.starts_with(word)) return "NaN and Infinity are no numbers of JSON";
  }
  if (dynamic_cast<const Json::out_of_range*>(&e)) return "broken JSON: a number is too large";
  std::string text = e.what();
  const std::size_t dash = text.find(" - ");
  if (dash != std::string::npos) text.erase(0, dash + 3);
  text.resize(std::min<std::size_t>(text.size(), 120));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, ' ');
  return "broken JSON: " + text;
}

/// The word that the byte at `at` belongs to.
std::string_view word_at(std::string_view bytes, std::size_t at) {
  at = std::min(at, bytes.size());
  std::size_t begin = at;
  while (begin > 0 && is_letter(bytes[begin - 1])) --begin;
  return bytes.substr(begin, 20);
}

Drawing read(const Source& source, const RunContext& context) {
  Drawing drawing;
  const std::string_view bytes = source.bytes();
  try {
    const Json root = Json::parse(bytes.begin(), bytes.end(), LayerTaker(drawing.layers, context));
    read_head(JsonPlace(root), drawing);
    JsonPlace(root).required("layers",
                             [](const JsonPlace& list) { list.each([](const auto&, auto) {}); });
  } catch (const Json::parse_error& e) {
    const std::size_t at = std::min(e.byte > 0 ? e.byte - 1 : 0, bytes.size());
    source.fail_at_line(bytes.data() + at, reason(e, word_at(bytes, at)));
  } catch (const Json::exception& e) {
    source.fail(reason(e, ""));
  } catch (const InputError& e) {
    source.fail(e.what());
  }
  return drawing;
}

}  // namespace

Drawing read_drawing(const std::filesystem::path& path, const RunContext& context) {
  return read(Source(path, context), context);
}

Drawing parse_drawing(std::string_view json, const std::string& file, const RunContext& context) {
  return read(Source(file, json, context), context);
}

}  // namespace burin
