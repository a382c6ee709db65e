#include "key_row.h"

#include <optional>

namespace burin::detail {
namespace {

/// A name or a file, or the members of a style file.
void set_style(const KeyedFile& in, const Json& value, const std::string& path,
               LookRequest& asked) {
  if (!value.is_object()) {
    asked.style = in.style_named(value, path);
    return;
  }
  asked.style_text = in.text_at_lines(value, path);
  asked.style_source = in.source();
  parse_style(asked.style_text, in.source());
}

/// One selector is written as text.
Json write_selectors(const std::vector<std::string>& select) {
  return select.size() == 1 ? Json(select.front()) : Json(select);
}

KeyRow<LookRequest> look_flag(const char* name, const char* meaning,
                              std::optional<bool> Look::*member) {
  const KeyRow<Look> row = flag_row(name, meaning, member);
  return {.name = row.name,
          .schema = row.schema,
          .read = [row](const KeyedFile& in, const Json& value, const std::string& path,
                        LookRequest& asked) { row.read(in, value, path, asked.look); },
          .write = [row](const LookRequest& asked) { return row.write(asked.look); }};
}

const std::vector<KeyRow<LookRequest>>& look_rows() {
  static const std::vector<KeyRow<LookRequest>> rows = {
      {.name = "select",
       .schema = one_or_list_of(selector()),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  LookRequest& asked) { asked.look.select = in.text_list(value, path); },
       .write = [](const LookRequest& asked) { return write_selectors(asked.look.select); },
       .missing = "a look has \"{}\", the parts that it is for"},
      {.name = "style",
       .schema = style_value_schema(),
       .read = set_style,
       .write =
           [](const LookRequest& asked) {
             return asked.style.empty() ? Json() : Json(asked.style);
           }},
      look_flag("drawn", "false: as if the part were not there", &Look::drawn),
      look_flag("hatched", "false: without strokes", &Look::hatched),
      look_flag("transparent", "true: of glass; it hides itself alone, and keeps its strokes",
                &Look::transparent),
      look_flag("listed", "false: no item of a parts list, and without a callout", &Look::listed),
  };
  return rows;
}

double strength(const KeyedFile& in, const Json& value, const std::string& path) {
  const double s = in.number(value, path);
  if (!(s >= 0 && s <= 10)) in.fail(path, "a light takes a strength of 0 to 10");
  return s;
}

/// Where a light is, or where it comes from.
KeyRow<tone::Light> light_place(const char* name, const char* meaning, tone::Light::Kind kind) {
  return {.name = name,
          .schema = vector_of(meaning),
          .read =
              [kind](const KeyedFile& in, const Json& value, const std::string& path,
                     tone::Light& light) {
                light.kind = kind;
                light.place = in.vector(value, path);
                if (kind == tone::Light::Kind::From && light.place == Vec3(0)) {
                  in.fail(path, "\"from\" takes a direction but 0,0,0");
                }
              },
          .write =
              [kind](const tone::Light& light) {
                if (light.kind != kind) return Json();
                return Json{light.place.x, light.place.y, light.place.z};
              }};
}

const std::vector<KeyRow<tone::Light>>& light_rows() {
  using Kind = tone::Light::Kind;
  static const Json strengths = {{"type", "number"}, {"minimum", 0}, {"maximum", 10}};
  static const std::vector<KeyRow<tone::Light>> rows = {
      {.name = "ambient",
       .schema = strengths,
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, tone::Light& light) {
             light.kind = Kind::Ambient;
             light.strength = strength(in, value, path);
           },
       .write =
           [](const tone::Light& light) {
             return light.kind == Kind::Ambient ? Json(light.strength) : Json();
           }},
      light_place("from", "to the light: right, up, towards the viewer", Kind::From),
      light_place("at", "where the light is, in model mm", Kind::At),
      {.name = "strength",
       .schema = strengths,
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, tone::Light& light) {
             if (light.kind == Kind::Ambient) {
               in.fail(path, "that of an ambient light is its number");
             }
             light.strength = strength(in, value, path);
           },
       .write =
           [](const tone::Light& light) {
             return light.kind == Kind::Ambient ? Json() : Json(light.strength);
           }},
  };
  return rows;
}

tone::Light light(const KeyedFile& in, const Json& value, const std::string& path) {
  check_members(light_rows(), in, value, path);
  const auto has = [&](const char* name) { return value.contains(name); };
  if (static_cast<int>(has("ambient")) + has("from") + has("at") != 1) {
    in.fail(path, "a light has one of \"ambient\", \"from\" and \"at\"");
  }
  tone::Light light;
  read_members(light_rows(), in, value, path, light);
  return light;
}

}  // namespace

/// A name or a file, or the members of a style file.
void take_style(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  DrawRequest& r = out.request;
  r.style_text.clear();
  r.style_source.clear();
  r.options.erase("style");
  if (value.is_object()) {
    Json named = value;
    if (value.contains("base") && !value.contains("name")) named["name"] = value["base"];
    r.style_text = in.text_at_lines(named, path);
    r.style_source = in.source();
    parse_style(r.style_text, in.source());  // also where another file's stands instead of it
  } else {
    r.options["style"] = {in.style_named(value, path)};
  }
}

void take_looks(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  in.check_array(value, path);
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string at = fmt::format("{}/{}", path, i);
    LookRequest start;
    start.look.place = in.place(at);
    out.request.looks.push_back(read_object(look_rows(), in, value[i], at, std::move(start)));
  }
}

void take_lights(const KeyedFile& in, const Json& value, const std::string& path,
                 IllustrationFile& out) {
  in.check_array(value, path);
  out.request.lights.clear();
  for (std::size_t i = 0; i < value.size(); ++i) {
    out.request.lights.push_back(light(in, value[i], fmt::format("{}/{}", path, i)));
  }
}

Json style_value_schema() {
  return {{"anyOf",
           {text("a built-in style, or a style file seen from the folder of this one"),
            {{"$ref", "#/$defs/style"}}}}};
}

Json looks_schema() { return list_of(object_schema(look_rows())); }
Json lights_schema() {
  Json light = object_schema(light_rows());
  light["oneOf"] = either({"ambient", "from", "at"});
  light["dependentSchemas"]["ambient"]["properties"]["strength"] = false;
  return list_of(std::move(light));
}

Json write_looks(const std::vector<LookRequest>& looks) {
  Json list = Json::array();
  for (const LookRequest& look : looks) list.push_back(write_object(look_rows(), look));
  return list;
}

Json write_lights(const std::vector<tone::Light>& lights) {
  Json list = Json::array();
  for (const tone::Light& light : lights) list.push_back(write_object(light_rows(), light));
  return list;
}

}  // namespace burin::detail
