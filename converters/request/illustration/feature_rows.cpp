#include "feature_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace burin::detail {
namespace {

/// A number of the drawing, or the nearest to a point.
KeyRow<FeatureRow> numbered_row(const char* name, const char* meaning, FeatureRow::Kind kind) {
  return {
      .name = name,
      .schema = {{"description", meaning},
                 {"anyOf", {{{"type", "integer"}, {"minimum", 0}}, vector_of("a point near it")}}},
      .read =
          [kind](const KeyedFile& in, const Json& value, const std::string& path, FeatureRow& to) {
            to.kind = kind;
            if (value.is_array()) {
              to.at = in.vector(value, path);
              return;
            }
            const double number =
                in.within(value, path, 0, 2147483647, "a number from 0, or a point [x, y, z]");
            if (number != std::floor(number)) in.fail(path, "takes a whole number");
            to.number = static_cast<std::int32_t>(number);
          },
      .write =
          [kind](const FeatureRow& from) {
            if (from.kind != kind) return Json();
            return from.number ? Json(*from.number) : vector_json(from.at);
          }};
}

constexpr std::array kFeatureKinds{FeatureKind::Line,     FeatureKind::Circle, FeatureKind::Plane,
                                   FeatureKind::Cylinder, FeatureKind::Cone,   FeatureKind::Sphere,
                                   FeatureKind::Torus,    FeatureKind::Turned, FeatureKind::Other};
constexpr std::array kFeatureNames{"line",   "circle", "plane",  "cylinder", "cone",
                                   "sphere", "torus",  "turned", "other"};

FeatureKind kind_of(const KeyedFile& in, const Json& value, const std::string& path) {
  return kFeatureKinds[word_of(in, value, path, kFeatureNames)];
}

const char* name_of(FeatureKind kind) {
  const auto found = std::ranges::find(kFeatureKinds, kind);
  return kFeatureNames[static_cast<std::size_t>(found - kFeatureKinds.begin()) % 9];
}

/// To nine digits: rounding of sums is left out, and two places that differ for a user stay
/// different.
double kept_digits(double value) {
  return std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr) + 0.0;
}

KeyRow<FeaturePrint> length_row(const char* name, const char* meaning,
                                double FeaturePrint::*member) {
  return {.name = name,
          .schema = {{"description", meaning}, {"type", "number"}, {"minimum", 0}},
          .read =
              [member](const KeyedFile& in, const Json& value, const std::string& path,
                       FeaturePrint& to) {
                to.*member = in.within(value, path, 0, 1e300, "a number from 0");
              },
          .write =
              [member](const FeaturePrint& from) {
                return from.*member > 0 ? Json(kept_digits(from.*member)) : Json();
              }};
}

KeyRow<FeaturePrint> place_row(const char* name, const char* meaning, Vec3 FeaturePrint::*member) {
  return {.name = name,
          .schema = vector_of(meaning),
          .read = [member](const KeyedFile& in, const Json& value, const std::string& path,
                           FeaturePrint& to) { to.*member = in.vector(value, path); },
          .write =
              [member](const FeaturePrint& from) {
                const Vec3& v = from.*member;
                if (v == Vec3(0)) return Json();
                return Json{kept_digits(v.x), kept_digits(v.y), kept_digits(v.z)};
              }};
}

/// What a face or an edge looked like.
const std::vector<KeyRow<FeaturePrint>>& print_rows() {
  static const std::vector<KeyRow<FeaturePrint>> rows = {
      {.name = "kind",
       .schema = words_schema("what it is", kFeatureNames),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  FeaturePrint& to) { to.kind = kind_of(in, value, path); },
       .write = [](const FeaturePrint& from) { return Json(name_of(from.kind)); },
       .missing = "what is kept of a feature has \"{}\""},
      length_row("size", "mm2 of a face, mm of an edge", &FeaturePrint::size),
      length_row("radius", "mm", &FeaturePrint::radius),
      place_row("at", "its middle, mm from the low corner of its part", &FeaturePrint::at),
      place_row("box", "the size of its part, mm", &FeaturePrint::box),
      place_row("along", "its normal, way or axis", &FeaturePrint::along),
      {.name = "beside",
       .schema = list_of(words_schema("a face beside it", kFeatureNames)),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, FeaturePrint& to) {
             in.check_array(value, path);
             for (std::size_t i = 0; i < value.size(); ++i) {
               to.beside.push_back(kind_of(in, value[i], fmt::format("{}/{}", path, i)));
             }
             std::ranges::sort(to.beside);
           },
       .write =
           [](const FeaturePrint& from) {
             Json list = Json::array();
             for (const FeatureKind kind : from.beside) list.push_back(name_of(kind));
             return list.empty() ? Json() : list;
           }},
  };
  return rows;
}

const std::vector<KeyRow<FeatureRow>>& feature_rows() {
  static const std::vector<KeyRow<FeatureRow>> rows = {
      text_row("part", "the part that has it, as in looks; without it any that is drawn",
               &FeatureRow::part),
      numbered_row("face", "its number in drawing files, or [x, y, z], a point near it",
                   FeatureRow::Kind::Face),
      numbered_row("edge", "its number in drawing files, or [x, y, z], a point near it",
                   FeatureRow::Kind::Edge),
      {.name = "point",
       .schema = vector_of("a point of the model, mm"),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, FeatureRow& to) {
             to.kind = FeatureRow::Kind::Point;
             to.at = in.vector(value, path);
           },
       .write =
           [](const FeatureRow& from) {
             return from.kind == FeatureRow::Kind::Point ? vector_json(from.at) : Json();
           }},
      {.name = "kept",
       .schema = object_schema(print_rows()),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  FeatureRow& to) { to.print = read_object(print_rows(), in, value, path); },
       .write =
           [](const FeatureRow& from) {
             return from.print ? write_object(print_rows(), *from.print) : Json();
           }},
  };
  return rows;
}

}  // namespace

FeatureRow read_target(const KeyedFile& in, const Json& value, const std::string& path) {
  const bool object = value.is_object();
  if (!value.is_string() && !(object && value.size() == 1 && value.contains("part"))) {
    return read_feature(in, value, path);
  }
  FeatureRow out;
  out.kind = FeatureRow::Kind::Part;
  out.part = object ? in.text(value["part"], path + "/part") : in.text(value, path);
  return out;
}

FeatureRow read_feature(const KeyedFile& in, const Json& value, const std::string& path) {
  FeatureRow out;
  if (value.is_array()) {
    out.at = in.vector(value, path);
    return out;
  }
  check_members(feature_rows(), in, value, path);
  int kinds = 0;
  for (const char* kind : {"face", "edge", "point"}) kinds += value.contains(kind) ? 1 : 0;
  if (kinds != 1) in.fail(path, "a feature has one of \"face\", \"edge\" and \"point\"");
  if (value.contains("point") && value.contains("part")) {
    in.fail(path, "a \"point\" is one of the model: leave \"part\" out");
  }
  read_members(feature_rows(), in, value, path, out);
  if (out.print && !out.number) in.fail(path, "\"kept\" is about a face or an edge by its number");
  if (out.number && out.part.empty()) {
    in.fail(path, "a number is one of a part: give its \"part\"");
  }
  return out;
}

Json write_feature(const FeatureRow& feature) { return write_object(feature_rows(), feature); }

Json target_schema() {
  const Json selector = text("parts, as in looks: any of them that is seen will do");
  Json whole = object_of({{"part", selector}});
  whole["required"] = Json::array({"part"});
  Json schema = feature_schema();
  schema["anyOf"].push_back(selector);
  schema["anyOf"].push_back(std::move(whole));
  return schema;
}

Json feature_schema() {
  Json object = object_schema(feature_rows());
  object["oneOf"] = either({"face", "edge", "point"});
  Json numbered = Json::array();
  for (const char* key : {"face", "edge"}) {
    Json one{{"required", {key}}};
    one["properties"][key] = {{"type", "integer"}};
    numbered.push_back(std::move(one));
  }
  // A number is one of a part; what is kept is about a number; a point is of no part.
  object["if"]["anyOf"] = numbered;
  object["then"]["required"] = Json::array({"part"});
  object["dependentSchemas"]["kept"]["anyOf"] = numbered;
  object["dependentSchemas"]["point"]["properties"]["part"] = false;
  return {{"anyOf", {vector_of("a point near a face, mm"), std::move(object)}}};
}

}  // namespace burin::detail
