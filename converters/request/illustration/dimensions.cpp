#include <burin/converters/values.h>

#include "feature_rows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace burin::detail {
namespace {

using Kind = DimensionRow::Kind;

constexpr std::array kKinds{Kind::Distance, Kind::Diameter, Kind::Radius,
                            Kind::Angle,    Kind::Depth,    Kind::Thread};
constexpr std::array kUnits{"mm", "cm", "m", "inch"};
constexpr std::array kSigns{"point", "comma"};

bool has_list(Kind kind) { return kind == Kind::Distance || kind == Kind::Angle; }
/// Of an angle one may do: that of a cone.
std::size_t least_of(Kind kind) { return kind == Kind::Angle ? 1 : 2; }

KeyRow<DimensionRow> kind_row(Kind kind) {
  Json one = feature_schema(), schema = one;
  if (has_list(kind)) {
    schema = list_of(one);
    schema["minItems"] = least_of(kind);
    schema["maxItems"] = 2;
  }
  return {.name = to_string(kind),
          .schema = std::move(schema),
          .read =
              [kind](const KeyedFile& in, const Json& value, const std::string& path,
                     DimensionRow& to) {
                to.kind = kind;
                if (!has_list(kind)) {
                  to.of = {read_feature(in, value, path)};
                  return;
                }
                if (!value.is_array() || value.size() < least_of(kind) || value.size() > 2 ||
                    value[0].is_number()) {
                  in.fail(path,
                          fmt::format("\"{}\" takes a list of two features{}", to_string(kind),
                                      kind == Kind::Angle ? ", or of one cone" : ""));
                }
                to.of.clear();
                for (std::size_t i = 0; i < value.size(); ++i) {
                  to.of.push_back(read_feature(in, value[i], fmt::format("{}/{}", path, i)));
                }
              },
          .write =
              [kind](const DimensionRow& from) {
                if (from.kind != kind) return Json();
                Json list = Json::array();
                for (const FeatureRow& one : from.of) list.push_back(write_feature(one));
                return has_list(kind) ? list : list[0];
              }};
}

/// A deviation as it is written, and how large it is.
struct Deviation {
  std::string text;
  double value = 0;
};

/// The number that a text begins with, which a degree sign may follow.
std::optional<double> number_of(std::string_view given) {
  constexpr std::string_view kMinus = "\u2212", kDegree = "\u00b0";
  const bool minus = given.starts_with(kMinus) || given.starts_with('-');
  if (minus || given.starts_with('+')) {
    given.remove_prefix(given.starts_with(kMinus) ? kMinus.size() : 1);
  }
  if (given.ends_with(kDegree)) given.remove_suffix(kDegree.size());
  std::string text(given);
  std::ranges::replace(text, ',', '.');
  const char* end = text.data() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !(value >= 0 && std::isfinite(value))) {
    return std::nullopt;
  }
  return minus ? -value : value;
}

/// A text, or a number with its sign.
Deviation deviation(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_string()) {
    const double number = in.number(value, path);
    return {number == 0 ? "0" : fmt::format("{:+g}", number), number};
  }
  const std::string text = in.text(value, path);
  const std::optional<double> number = number_of(text);
  if (!number) {
    in.fail(path, fmt::format("\"tolerance\": a deviation is a number such as \"+0.1\", not \"{}\"",
                              text));
  }
  return {text, *number};
}

void read_tolerance(const KeyedFile& in, const Json& value, const std::string& path,
                    DimensionRow& to) {
  if (!value.is_array()) {
    to.tolerance = value.is_number()
                       ? fmt::format("\u00b1{:g}", in.within(value, path, 0, kLarge, "mm from 0"))
                       : in.text(value, path);
    return;
  }
  if (value.size() != 2) {
    in.fail(path, "\"tolerance\" takes text, or two deviations: the upper, then the lower");
  }
  const Deviation upper = deviation(in, value[0], path + "/0"),
                  lower = deviation(in, value[1], path + "/1");
  if (upper.value < lower.value) {
    in.fail(path, fmt::format("\"tolerance\": the upper deviation comes first, and \"{}\" is less "
                              "than \"{}\"",
                              upper.text, lower.text));
  }
  to.upper = upper.text;
  to.lower = lower.text;
}

Json tolerance_schema() {
  const Json one = {{"type", {"string", "number"}}};
  Json both = list_of(one);
  both["minItems"] = 2;
  both["maxItems"] = 2;
  return {{"description", "H7, ±0.1, or the upper and the lower deviation"},
          {"anyOf", {one, both}}};
}

std::vector<KeyRow<DimensionRow>> kind_rows() {
  std::vector<KeyRow<DimensionRow>> rows;
  for (const Kind kind : kKinds) rows.push_back(kind_row(kind));
  return rows;
}

const std::vector<KeyRow<DimensionRow>>& dimension_rows() {
  static const std::vector<KeyRow<DimensionRow>> rows = [] {
    std::vector<KeyRow<DimensionRow>> all = kind_rows();
    const std::vector<KeyRow<DimensionRow>> others = {
        vector_row("along", "a distance is measured in this direction", &DimensionRow::along,
                   false),
        {.name = "supplement",
         .schema = flag("the angle beside that between the features"),
         .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                    DimensionRow& to) { to.supplement = in.flag(value, path); },
         .write = [](const DimensionRow& from) { return from.supplement ? Json(true) : Json(); }},
        text_row("text", "what is written; {value} is the number", &DimensionRow::text),
        {.name = "tolerance",
         .schema = tolerance_schema(),
         .read = read_tolerance,
         .write =
             [](const DimensionRow& from) {
               if (!from.tolerance.empty()) return Json(from.tolerance);
               return from.upper.empty() ? Json() : Json{from.upper, from.lower};
             }},
    };
    all.insert(all.end(), others.begin(), others.end());
    std::ranges::move(number_rows(), std::back_inserter(all));
    return all;
  }();
  return rows;
}

std::vector<std::string> kind_names() { return names_of(kind_rows()); }

DimensionRow dimension(const KeyedFile& in, const Json& value, const std::string& path) {
  check_members(dimension_rows(), in, value, path);
  int kinds = 0;
  for (const std::string& kind : kind_names()) kinds += value.contains(kind) ? 1 : 0;
  if (kinds != 1) {
    in.fail(path, fmt::format("a dimension has one of {}", fmt::join(kind_names(), ", ")));
  }
  DimensionRow row;
  read_members(dimension_rows(), in, value, path, row);
  if (row.along && row.kind != Kind::Distance) in.fail(path, "\"along\" is for a distance");
  if (row.supplement && (row.kind != Kind::Angle || row.of.size() < 2)) {
    in.fail(path, "\"supplement\" is for an angle between two features");
  }
  if (row.kind == Kind::Thread && row.text.empty()) {
    in.fail(path, "a thread has \"text\", such as \"M8\": its shape alone does not tell");
  }
  check_braces(in, row.text, path + "/text", {"value"}, "{value} is known, which is the number");
  row.place = in.place(path);
  return row;
}

}  // namespace

std::vector<KeyRow<DimensionRow>> number_rows() {
  return {
      {.name = "decimals",
       .schema = {{"description", "places after the point (default: the style's)"},
                  {"type", "integer"},
                  {"minimum", 0},
                  {"maximum", 6}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DimensionRow& to) {
             const double places = in.within(value, path, 0, 6, "0 to 6");
             if (places != std::floor(places)) in.fail(path, "takes a whole number");
             to.decimals = static_cast<std::uint64_t>(places);
           },
       .write =
           [](const DimensionRow& from) { return from.decimals ? Json(*from.decimals) : Json(); }},
      {.name = "unit",
       .schema = words_schema("of lengths (default: the style's)", kUnits),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DimensionRow& to) {
             to.unit = static_cast<DimensionOptions::Unit>(word_of(in, value, path, kUnits));
           },
       .write =
           [](const DimensionRow& from) {
             return from.unit ? Json(kUnits[static_cast<std::size_t>(*from.unit)]) : Json();
           }},
      {.name = "sign",
       .schema = words_schema("before the decimals (default: the style's)", kSigns),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DimensionRow& to) {
             to.sign = static_cast<DimensionOptions::Sign>(word_of(in, value, path, kSigns));
           },
       .write =
           [](const DimensionRow& from) {
             return from.sign ? Json(kSigns[static_cast<std::size_t>(*from.sign)]) : Json();
           }},
      text_row("view", "the view that has it (default: the first that shows it best)",
               &DimensionRow::view),
  };
}

std::optional<std::string> unknown_brace(const std::string& text,
                                         const std::vector<std::string>& names) {
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    const std::size_t end = text.find('}', at);
    if (end == std::string::npos) break;
    std::string name = text.substr(at + 1, end - at - 1);
    if (std::ranges::find(names, name) == names.end()) return name;
  }
  return std::nullopt;
}

void check_braces(const KeyedFile& in, const std::string& text, const std::string& path,
                  const std::vector<std::string>& names, const std::string& known) {
  if (const std::optional<std::string> name = unknown_brace(text, names)) {
    in.fail(path, fmt::format("\"text\" has {{{}}}: only {}", *name, known));
  }
}

void take_dimensions(const KeyedFile& in, const Json& value, const std::string& path,
                     IllustrationFile& out) {
  out.request.dimensions.clear();
  out.request.options.erase("dimensions");
  for_rows(in, value, path, [&](const Json& row, const std::string& at) {
    if (row.is_object()) {
      out.request.dimensions.push_back(dimension(in, row, at));
      return;
    }
    if (!row.is_string()) {
      in.fail(at,
              "\"dimensions\" takes \"overall\" and rows such as {\"diameter\": [58, 30.5, 5]}");
    }
    const std::string word = in.text(row, at);
    in.check(draw_rows(), "dimensions", {word}, at, "dimensions");
    out.request.options["dimensions"] = {word};
  });
}

Json dimensions_schema() {
  Json row = object_schema(dimension_rows());
  row["oneOf"] = either(kind_names());
  row["dependentRequired"] = {
      {"along", {"distance"}}, {"supplement", {"angle"}}, {"thread", {"text"}}};
  Json schema = one_or_list_of({{"anyOf", {value_of_option("dimensions"), std::move(row)}}});
  schema["anyOf"][1]["maxItems"] = kMostRows;
  return schema;
}

Json write_dimensions(const DrawRequest& request) {
  const std::vector<std::string> words = asked_texts(option_named("dimensions"), request.options);
  if (request.dimensions.empty()) {
    return words.empty() ? Json() : written_value(option_named("dimensions"), words.back());
  }
  Json list = Json::array();
  if (!words.empty() && words.back() != "none") list.push_back(words.back());
  for (const DimensionRow& row : request.dimensions) {
    list.push_back(write_object(dimension_rows(), row));
  }
  return list;
}

}  // namespace burin::detail
