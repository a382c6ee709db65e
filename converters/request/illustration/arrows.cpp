#include <burin/base/error.h>
#include <burin/converters/values.h>
#include <burin/drawing/color.h>

#include "arrow_option.h"
#include "key_row.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

constexpr double kLongestArrow = 1e9;  // model mm
/// The ends of a longer turn would lie on each other.
constexpr double kMostDegrees = 340;

std::string read_color(const KeyedFile& in, const Json& value, const std::string& path) {
  const std::string given = in.text(value, path);
  std::string color = without_name(given);
  if (!rgb_of(color)) {
    in.fail(path, fmt::format("\"color\" takes #rrggbb or a name, {}, not '{}'", said_color_names(),
                              given));
  }
  return color;
}

const std::vector<KeyRow<ArrowRow>>& arrow_key_rows() {
  static const std::vector<KeyRow<ArrowRow>> rows = {
      {.name = "at",
       .schema = one_or_list_of(selector()),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ArrowRow& to) { to.select = in.text_list(value, path); },
       .write =
           [](const ArrowRow& from) {
             if (from.select.empty()) return Json();
             return from.select.size() == 1 ? Json(from.select[0]) : Json(from.select);
           }},
      vector_row("along", "the way that the parts move", &ArrowRow::along, false),
      vector_row("about", "the axis that they turn about, by the right hand", &ArrowRow::about,
                 false),
      {.name = "degrees",
       .schema = {{"description", "how far they turn (default 270); negative: the other way"},
                  {"type", "number"},
                  {"minimum", -kMostDegrees},
                  {"maximum", kMostDegrees}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, ArrowRow& to) {
             to.degrees = in.within(value, path, -kMostDegrees, kMostDegrees, "-340 to 340");
             if (std::abs(to.degrees) < 1) in.fail(path, "\"degrees\" is 1 at least");
           },
       .write =
           [](const ArrowRow& from) {
             return from.about && from.degrees != 270 ? Json(from.degrees) : Json();
           }},
      {.name = "behind",
       .schema = flag("the arrow is behind the parts and ends at them"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ArrowRow& to) { to.behind = in.flag(value, path); },
       .write = [](const ArrowRow& from) { return from.behind ? Json(true) : Json(); }},
      vector_row("from", "a point of the model, where it begins", &ArrowRow::from, true),
      vector_row("to", "where it ends", &ArrowRow::to, true),
      positive_row("length", "model mm (default: by the size of the drawing)", &ArrowRow::length,
                   kLongestArrow),
      positive_row("width", "model mm (default: by the size of the drawing)", &ArrowRow::width,
                   kLongestArrow),
      {.name = "color",
       .schema = text("its fill, #rrggbb or a name (default: none)"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ArrowRow& to) { to.color = read_color(in, value, path); },
       .write =
           [](const ArrowRow& from) { return from.color.empty() ? Json() : Json(from.color); }},
  };
  return rows;
}

ArrowRow read_arrow(const KeyedFile& in, const Json& value, const std::string& path) {
  ArrowRow row = read_object(arrow_key_rows(), in, value, path);
  row.place = in.place(path);
  const bool moves = row.along || row.about;
  if (row.along && row.about) in.fail(path, "an arrow has \"along\" or \"about\", not both");
  if (row.select.empty() && (!row.from || !row.to || moves)) {
    in.fail(path, "an arrow has \"at\" with \"along\" or \"about\", or \"from\" and \"to\"");
  }
  if (!row.select.empty() && (!moves || row.from || row.to)) {
    in.fail(path, "an arrow at parts has \"along\" or \"about\", and no \"from\" or \"to\"");
  }
  if (row.from && !(glm::distance(*row.from, *row.to) > 0)) {
    in.fail(path, "\"from\" and \"to\" are two points");
  }
  if (value.contains("degrees") && !row.about) in.fail(path, "\"degrees\" is for one \"about\"");
  if (row.behind && !row.along) in.fail(path, "\"behind\" is for an arrow \"along\" a way");
  if (row.length && !row.along) in.fail(path, "\"length\" is for an arrow \"along\" a way");
  return row;
}

}  // namespace

ArrowRow arrow_option(const std::string& spelled, const std::string& text) {
  constexpr const char* kTakes = "NAME=X,Y,Z, as cover=0,0,1";
  const auto [name, given] = name_and_value(spelled, kTakes, text);
  double way[3];
  if (!parse_list(given, way)) refuse_value(spelled, kTakes, text);
  ArrowRow row{.select = {name}, .along = Vec3(way[0], way[1], way[2])};
  row.place = spelled + ": ";
  if (!(glm::length(*row.along) > 0)) refuse_value(spelled, kTakes, text);
  return row;
}

std::vector<RequestRow<Draft>> arrow_rows() {
  return {
      {{.option = {.name = "arrow",
                   .meaning = "draw a flat arrow in space before parts, the way that they move, "
                              "X,Y,Z of the model; repeatable; \"arrows\" of an illustration has "
                              "others",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME=X,Y,Z",
        .many = true,
        .python = "str | Sequence[str]",
        .also = {"motion", "motion arrow", "movement", "direction arrow"}},
       [](Draft& d, const Asked& a) {
         for (const std::string& text : a.texts) {
           d.plan.arrows.push_back(arrow_option(a.spelled, text));
         }
       }},
      {{.option = {.name = "arrows",
                   .meaning = "draw an arrow for each step of an exploded view, the way that its "
                              "parts go together: steps, or none (default none)",
                   .takes = WordList{{"none", "steps"}}},
        .group = kSheet,
        .label = "none|steps",
        .fallback = "none",
        .also = {"motion arrows", "step arrows", "assembly arrows", "explode arrows"}},
       [](Draft& d, const Asked& a) {
         d.plan.step_arrows = std::get<std::uint64_t>(a.value) == 1;
       }},
  };
}

void take_arrows(const KeyedFile& in, const Json& value, const std::string& path,
                 IllustrationFile& out) {
  out.request.arrows.clear();
  out.request.options.erase("arrows");
  for_rows(in, value, path, [&](const Json& row, const std::string& at) {
    if (row.is_object()) {
      out.request.arrows.push_back(read_arrow(in, row, at));
      return;
    }
    const std::string word = in.text(row, at);
    if (word.find('=') == std::string::npos) {
      in.check(draw_rows(), "arrows", {word}, at, "arrows");
      out.request.options["arrows"] = {word};
      return;
    }
    in.check(draw_rows(), "arrow", {word}, at, "arrows");
    out.request.arrows.push_back(arrow_option("arrows", word));
    out.request.arrows.back().place = in.place(at);
  });
}

Json arrows_schema() {
  Json row = object_schema(arrow_key_rows());
  row["anyOf"] =
      Json::array({Json{{"required", {"at", "along"}}}, Json{{"required", {"at", "about"}}},
                   Json{{"required", {"from", "to"}}}});
  Json schema = one_or_list_of(
      {{"anyOf", {text("steps, or parts and a way, as cover=0,0,1"), std::move(row)}}});
  schema["anyOf"][1]["maxItems"] = kMostRows;
  return schema;
}

Json write_arrows(const DrawRequest& request) {
  Json list = Json::array();
  const std::vector<std::string> words = given_texts(request.options, "arrows");
  if (!words.empty() && words.back() != "none") list.push_back(words.back());
  for (const ArrowRow& row : request.arrows) list.push_back(write_object(arrow_key_rows(), row));
  for (const std::string& text : given_texts(request.options, "arrow")) list.push_back(text);
  return list;
}

}  // namespace burin::detail
