#include <burin/base/nearest.h>
#include <burin/drawing/color.h>

#include "values.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

constexpr double kDefaultWidth = 0.25;  // mm, a thin line after ISO 128
/// Far past any sheet, near enough for every writer's arithmetic.
constexpr double kFarthest = 1e9;

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
  place.member("part", also.source.part);
  place.member("face", also.source.face);
  place.member("edge", also.source.edge);
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

}  // namespace

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
  place.each_of("also",
                [&](const JsonPlace& one, std::size_t) { p.also.push_back(read_also(one)); });
  place.member("visible", p.visible);
  place.member("in_full", p.in_full);
  place.member("part", p.source.part);
  place.member("face", p.source.face);
  place.member("edge", p.source.edge);
  place.member("closed", p.closed);
  place.member("item", p.item);
  place.optional("color", [&](const JsonPlace& color) { read_color(color, p.color); });
  place.member("field", p.field);
  place.member("family", p.family);
  place.member("stroke_kind", p.stroke_kind);
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
  place.optional("turn", [&](const JsonPlace& turn) {
    turn.set(text.turn);
    if (!(std::abs(text.turn) <= 360)) turn.fail("takes degrees from -360 to 360");
  });
  place.member("role", text.role);
  place.member("item", text.item);
  return text;
}

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

}  // namespace burin
