#include "illustration_keyed.h"

#include <optional>

namespace burin::detail {
namespace {

LookRequest look(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_object(value, path, kLookKeys);
  LookRequest asked;
  Look& look = asked.look;
  look.place = in.place(path);
  if (!value.contains("select")) in.fail(path, "a look has \"select\", the parts that it is for");
  look.select = in.text_list(value["select"], path + "/select");
  const auto flag = [&](const char* name, std::optional<bool>& to) {
    if (value.contains(name)) to = in.flag(value[name], fmt::format("{}/{}", path, name));
  };
  flag("drawn", look.drawn);
  flag("hatched", look.hatched);
  flag("transparent", look.transparent);
  flag("listed", look.listed);
  if (!value.contains("style")) return asked;
  const std::string at = path + "/style";
  if (value["style"].is_object()) {
    asked.style_text = in.text_at_lines(value["style"], at);
    asked.style_source = in.source();
    parse_style(asked.style_text, in.source());
  } else {
    asked.style = in.style_named(value["style"], at);
  }
  return asked;
}

double strength(const KeyedFile& in, const Json& value, const std::string& path) {
  const double s = in.number(value, path);
  if (!(s >= 0 && s <= 10)) in.fail(path, "a light takes a strength of 0 to 10");
  return s;
}

tone::Light light(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_object(value, path, kLightKeys);
  const auto has = [&](const char* name) { return value.contains(name); };
  if (static_cast<int>(has("ambient")) + has("from") + has("at") != 1) {
    in.fail(path, "a light has one of \"ambient\", \"from\" and \"at\"");
  }
  tone::Light light;
  if (has("ambient")) {
    light.kind = tone::Light::Kind::Ambient;
    light.strength = strength(in, value["ambient"], path + "/ambient");
    if (has("strength")) in.fail(path + "/strength", "that of an ambient light is its number");
    return light;
  }
  const char* name = has("from") ? "from" : "at";
  const std::string at = fmt::format("{}/{}", path, name);
  light.kind = has("from") ? tone::Light::Kind::From : tone::Light::Kind::At;
  light.place = in.vector(value[name], at);
  if (has("from") && light.place == Vec3(0)) in.fail(at, "\"from\" takes a direction but 0,0,0");
  if (has("strength")) light.strength = strength(in, value["strength"], path + "/strength");
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
    out.request.looks.push_back(look(in, value[i], fmt::format("{}/{}", path, i)));
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

}  // namespace burin::detail
