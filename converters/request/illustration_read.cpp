#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/base/nearest.h>
#include <burin/converters/illustration.h>
#include <burin/converters/read.h>
#include <burin/options/json_lines.h>

#include "draw_options.h"
#include "explode_option.h"
#include "illustration_keys.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 24;
constexpr std::size_t kMostInputs = 100'000;
constexpr int kMostExtended = 16;

/// A value of JSON as options take it: lists with commas.
std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string list;
  for (const Json& element : value) list += (list.empty() ? "" : ",") + text_of(element);
  return list;
}

/// One file, read into an illustration that may hold what it extends.
class Reader {
 public:
  Reader(std::string_view text, std::string source, int extended, Illustration& out)
      : text_(text),
        source_(std::move(source)),
        folder_(fs::path(source_).parent_path()),
        lines_(text),
        extended_(extended),
        out_(out) {}

  void read() {
    const Json json = parse();
    check_kind(json);
    if (json.contains("extends")) extend(json["extends"]);
    for (const auto& [key, value] : json.items()) {
      const std::string path = "/" + key;
      const auto member = std::ranges::find(members(), key, &Member::name);
      if (member == members().end()) unknown(path, key, names_of_members());
      if (member->take) (this->*member->take)(value, path);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& what) const {
    throw UsageError(fmt::format("{}{}", place(path), what));
  }
  std::string place(const std::string& path) const {
    return fmt::format("{}:{}: ", source_, lines_.line(path));
  }
  [[noreturn]] void unknown(const std::string& path, const std::string& key,
                            const std::vector<std::string>& known) const {
    fail(path, fmt::format("unknown key '{}'; did you mean '{}'?", key, nearest(key, known)));
  }

  Json parse() const {
    return parse_json_object<Json>(
        text_, source_, "illustration file",
        "an illustration file is one JSON object, {\"burin\": \"illustration\", ...}");
  }

  void check_kind(const Json& json) const {
    if (json.contains("format")) {
      throw InputError(
          "is a drawing, which is drawn already; burin convert writes it in other "
          "formats",
          source_);
    }
    if (!json.contains("burin") || json["burin"] != "illustration") {
      throw InputError("is no illustration file: its first key is \"burin\": \"illustration\"",
                       source_);
    }
    if (json.contains("version") && json["version"] != 1) {
      fail("/version", "this Burin reads version 1 of illustration files");
    }
  }

  /// A key of the file and what reads it; null: read before all others, or by nobody.
  struct Member {
    std::string name;
    void (Reader::*take)(const Json& value, const std::string& path);
  };

  static const std::vector<Member>& members() {
    static const std::vector<Member> all = [] {
      std::vector<Member> rows = {{"burin", nullptr},
                                  {"version", nullptr},
                                  {"$schema", nullptr},
                                  {"extends", nullptr},
                                  {"parts", &Reader::parts},
                                  {"style", &Reader::style},
                                  {"looks", &Reader::looks},
                                  {"lights", &Reader::lights},
                                  {"title", &Reader::title},
                                  {"items", &Reader::items},
                                  {"parts_list", &Reader::parts_list},
                                  {"view", &Reader::group},
                                  {"paper", &Reader::paper},
                                  {"section", &Reader::sections},
                                  {"explode", &Reader::explode}};
      for (const detail::IllustrationKey& key : detail::illustration_keys()) {
        const bool grouped = key.path.find('.') != std::string::npos;
        if (!grouped) rows.push_back({key.path, &Reader::option});
      }
      return rows;
    }();
    return all;
  }

  static std::vector<std::string> names_of_members() {
    std::vector<std::string> names;
    for (const Member& member : members()) names.push_back(member.name);
    return names;
  }

  void extend(const Json& value) {
    const std::string file = found_path(text(value, "/extends"));
    if (extended_ >= kMostExtended) {
      fail("/extends", "\"extends\" makes a chain of more than 16 files, or a ring of them");
    }
    std::string house;
    try {
      house = bytes_of(file);
    } catch (const InputError& e) {
      fail("/extends", fmt::format("'{}' {}", file, e.what()));
    }
    Reader(house, file, extended_ + 1, out_).read();
  }

  void title(const Json& value, const std::string& path) { out_.request.title = text(value, path); }

  /// Numbers and the names of what has them.
  void items(const Json& value, const std::string& path) {
    if (!value.is_object()) fail(path, "\"items\" takes an object, {\"1\": \"bolt\", ...}");
    ItemNumbers& numbers = out_.request.items;
    numbers.clear();
    std::map<std::string, std::string> known;
    for (const auto& [key, name] : value.items()) {
      const std::string at = path + "/" + key;
      int number = 0;
      const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
      if (error != std::errc() || end != key.data() + key.size() || number < 1 ||
          number > kLargestItem) {
        fail(at, fmt::format("an item has a number from 1 to {}, not '{}'", kLargestItem, key));
      }
      const std::string called = text(name, at);
      const auto [first, is_new] = known.try_emplace(called, key);
      if (!is_new) {
        fail(at, fmt::format("'{}' has the number {} already", called, first->second));
      }
      numbers[number] = called;
    }
  }

  void parts_list(const Json& value, const std::string& path) {
    const std::string given = text(value, path);
    if (given != "sheet") fail(path, "\"parts_list\" takes \"sheet\"; files are named at the door");
    out_.request.options["parts_list"] = {given};
  }

  void paper(const Json& value, const std::string& path) {
    if (value.is_object()) return group(value, path);
    set_option("paper", value, path, "paper");
  }

  /// A key that is an option of the same name.
  void option(const Json& value, const std::string& path) {
    const std::string name = path.substr(1);
    set_option(name, value, path, name);
  }

  /// Members of a group, "view" or "paper".
  void group(const Json& value, const std::string& path) {
    const std::string prefix = path.substr(1) + ".";
    std::vector<std::string> known;
    for (const detail::IllustrationKey& key : detail::illustration_keys()) {
      if (key.path.starts_with(prefix)) known.push_back(key.path.substr(prefix.size()));
    }
    check_object(value, path, known);
    for (const detail::IllustrationKey& key : detail::illustration_keys()) {
      if (!key.path.starts_with(prefix)) continue;
      const std::string name = key.path.substr(prefix.size());
      if (value.contains(name)) set_option(key.option, value[name], path + "/" + name, key.path);
    }
  }

  /// Sets an option of the drawing, once its row takes the value.
  void set_option(const std::string& option, const Json& value, const std::string& path,
                  const std::string& key) {
    const bool size = option == "paper" && value.is_array() && value.size() == 2;
    const std::string given =
        size ? fmt::format("{}x{}", text_of(value[0]), text_of(value[1])) : text_of(value);
    check(detail::draw_rows(), option, {given}, path, key);
    out_.request.options[option] = {given};
  }

  /// Asks the row of an option; its errors name the key and the line.
  template <class T>
  void check(const std::vector<RequestRow<T>>& rows, const std::string& option,
             const std::vector<std::string>& given, const std::string& path,
             const std::string& key) const {
    const auto row = std::ranges::find(rows, option, &RequestRow<T>::name);
    try {
      T scratch{};
      apply(std::vector<RequestRow<T>>{*row}, {{option, given}}, Spelling::Keywords, scratch);
    } catch (const UsageError& e) {
      std::string what = e.what();
      const std::string called = "argument " + option + " ";
      if (what.starts_with(called))
        what = fmt::format("\"{}\" {}", key, what.substr(called.size()));
      fail(path, what);
    }
  }

  void parts(const Json& value, const std::string& path) {
    check_array(value, path);
    if (value.size() > kMostInputs) fail(path, "more than 100,000 parts");
    out_.inputs.clear();
    for (std::size_t i = 0; i < value.size(); ++i) {
      input(value[i], fmt::format("{}/{}", path, i));
    }
  }

  void input(const Json& value, const std::string& path) {
    std::vector<std::string> known = detail::kInputKeys;
    for (const auto& row : read_option_rows()) known.push_back(row.name());
    check_object(value, path, known);
    IllustrationInput one;
    one.source = source_;
    one.line = lines_.line(path);
    if (value.contains("file") == value.contains("function")) {
      fail(path, "a part has either \"file\" or \"function\"");
    }
    if (value.contains("file")) {
      one.file = found_path(text(value["file"], path + "/file"));
    } else {
      one.function = text(value["function"], path + "/function");
    }
    if (value.contains("name")) one.name = text(value["name"], path + "/name");
    if (value.contains("place")) one.place = placement(value["place"], path + "/place");
    for (const auto& row : read_option_rows()) {
      const std::string& name = row.name();
      if (!value.contains(name)) continue;
      const std::vector<std::string> given = texts(row.about, value[name]);
      check(read_option_rows(), name, given, path + "/" + name, name);
      if (!given.empty()) one.read[name] = given;
    }
    out_.inputs.push_back(std::move(one));
  }

  /// Of an option that may be given several times: each of a list, NAME=VALUE of an object.
  static std::vector<std::string> texts(const RequestOption& option, const Json& value) {
    if (!option.many) return {text_of(value)};
    std::vector<std::string> given;
    if (value.is_object()) {
      for (const auto& [name, v] : value.items()) {
        given.push_back(name + "=" + v.dump());
      }
    } else if (value.is_array()) {
      for (const Json& v : value) given.push_back(text_of(v));
    } else {
      given.push_back(text_of(value));
    }
    return given;
  }

  Placement placement(const Json& value, const std::string& path) const {
    check_object(value, path, detail::kPlaceKeys);
    Placement place;
    if (value.contains("rotate"))
      place.linear = rotation(vector(value["rotate"], path + "/rotate"));
    if (value.contains("scale")) {
      const double scale = number(value["scale"], path + "/scale");
      if (!(scale >= 1e-9 && scale <= 1e9)) fail(path + "/scale", "\"scale\" takes 1e-9 to 1e9");
      place.linear *= scale;
    }
    if (value.contains("translate")) {
      place.offset = vector(value["translate"], path + "/translate");
    }
    return place;
  }

  /// A name or a file, or the members of a style file.
  void style(const Json& value, const std::string& path) {
    DrawRequest& r = out_.request;
    r.style_text.clear();
    r.style_source.clear();
    r.options.erase("style");
    if (value.is_object()) {
      Json named = value;
      if (value.contains("base") && !value.contains("name")) named["name"] = value["base"];
      r.style_text = text_at_lines(named, path);
      r.style_source = source_;
      parse_style(r.style_text, source_);  // also where another file's style stands instead of it
    } else {
      r.options["style"] = {style_named(value, path)};
    }
  }

  /// Built-in ones by name; files as they are found from here.
  std::string style_named(const Json& value, const std::string& path) const {
    std::string name = text(value, path);
    const auto builtin = builtin_styles();
    if (std::ranges::find(builtin, name, &StyleInfo::name) != builtin.end()) return name;
    if (name.find('/') != std::string::npos || name.ends_with(".json")) name = found_path(name);
    try {
      load_style(name);
    } catch (const MissingFile&) {
      fail(path, fmt::format("there is no style file '{}'", name));
    } catch (const UsageError& e) {
      fail(path, e.what());
    }
    return name;
  }

  void looks(const Json& value, const std::string& path) {
    check_array(value, path);
    for (std::size_t i = 0; i < value.size(); ++i) look(value[i], fmt::format("{}/{}", path, i));
  }

  void look(const Json& value, const std::string& path) {
    check_object(value, path, detail::kLookKeys);
    Look look;
    look.place = place(path);
    if (!value.contains("select")) fail(path, "a look has \"select\", the parts that it is for");
    const Json& select = value["select"];
    const Json list = select.is_array() ? select : Json::array({select});
    for (const Json& selector : list) look.select.push_back(text(selector, path + "/select"));
    const auto flag = [&](const char* name, std::optional<bool>& to) {
      if (!value.contains(name)) return;
      if (!value[name].is_boolean()) {
        fail(fmt::format("{}/{}", path, name), fmt::format("\"{}\" takes true or false", name));
      }
      to = value[name].get<bool>();
    };
    flag("drawn", look.drawn);
    flag("hatched", look.hatched);
    flag("transparent", look.transparent);
    if (value.contains("style")) {
      const std::string at = path + "/style";
      if (value["style"].is_object()) {
        look.style_text = text_at_lines(value["style"], at);
        look.style_source = source_;
        parse_style(look.style_text, source_);
      } else {
        look.style = style_named(value["style"], at);
      }
    }
    out_.request.looks.push_back(std::move(look));
  }

  void sections(const Json& value, const std::string& path) {
    const Json list = value.is_array() ? value : Json::array({value});
    out_.request.sections.clear();
    for (std::size_t i = 0; i < list.size(); ++i) {
      section(list[i], value.is_array() ? fmt::format("{}/{}", path, i) : path);
    }
  }

  /// As the option has it, or a plane and what stays whole.
  void section(const Json& value, const std::string& path) {
    Section section;
    if (value.is_object()) {
      check_object(value, path, detail::kSectionKeys);
      if (!value.contains("plane")) fail(path, "a section has \"plane\"");
      const Json& plane = value["plane"];
      const std::string at = path + "/plane";
      if (plane.is_object()) {
        check_object(plane, at, detail::kPlaneKeys);
        if (!plane.contains("normal")) fail(at, "a plane has \"normal\", towards what goes");
        section.plane.axis = vector(plane["normal"], at + "/normal");
        if (section.plane.axis == Vec3(0))
          fail(at + "/normal", "\"normal\" takes a direction but 0,0,0");
        section.plane.axis = glm::normalize(section.plane.axis);
        section.plane.side = 1;
        if (plane.contains("offset"))
          section.plane.offset = number(plane["offset"], at + "/offset");
      } else {
        section.plane = plane_of_text(plane, at);
      }
      if (value.contains("exclude")) {
        const Json& exclude = value["exclude"];
        const Json selectors = exclude.is_array() ? exclude : Json::array({exclude});
        for (const Json& selector : selectors) {
          section.exclude.push_back(text(selector, path + "/exclude"));
        }
      }
    } else {
      section.plane = plane_of_text(value, path);
    }
    section.place = place(path);
    section.json = value.dump();
    out_.request.sections.push_back(std::move(section));
  }

  CutText plane_of_text(const Json& value, const std::string& path) const {
    const std::string given = text(value, path);
    check(detail::draw_rows(), "section", {given}, path, "section");
    return cut_option("section", given);
  }

  /// As the option has it, or what it is made of.
  void explode(const Json& value, const std::string& path) {
    Explode& explode = out_.request.explode;
    explode = {.wanted = true, .json = value.dump(), .place = place(path)};
    if (!value.is_object()) return set_way(explode, value, path, "explode");
    check_object(value, path, detail::kExplodeKeys);
    if (value.contains("steps")) {
      for (const char* other : {"along", "base", "fit"}) {
        if (value.contains(other)) {
          fail(fmt::format("{}/{}", path, other),
               fmt::format("\"{}\" is for steps that are found; here \"steps\" are given", other));
        }
      }
      const Json& steps = value["steps"];
      check_array(steps, path + "/steps");
      if (steps.empty()) fail(path + "/steps", "\"steps\" has none; without it they are found");
      for (std::size_t i = 0; i < steps.size(); ++i) {
        explode.steps.push_back(step(steps[i], fmt::format("{}/steps/{}", path, i)));
      }
    }
    if (value.contains("along")) set_way(explode, value["along"], path + "/along", "along");
    if (value.contains("base")) {
      explode.base = text(value["base"], path + "/base");
      explode.place = place(path + "/base");
    }
    if (value.contains("fit")) {
      explode.fit = within(value["fit"], path + "/fit", 0, 1e6, "mm from 0");
    }
    if (value.contains("factor")) {
      explode.factor = within(value["factor"], path + "/factor", 0, 10, "0 to 10");
    }
  }

  void set_way(Explode& explode, const Json& value, const std::string& path,
               const std::string& key) const {
    const bool list = value.is_array() && value.size() == 3;
    const std::string given = list ? text_of(value) : text(value, path);
    check(detail::draw_rows(), "explode", {given}, path, key);
    detail::set_explode(explode, key, given);
  }

  double within(const Json& value, const std::string& path, double least, double most,
                const char* takes) const {
    const double given = number(value, path);
    if (!(given >= least && given <= most)) {
      fail(path, fmt::format("{} takes {}, not {}", named(path), takes, value.dump()));
    }
    return given;
  }

  Explode::Step step(const Json& value, const std::string& path) const {
    check_object(value, path, detail::kStepKeys);
    for (const char* key : {"move", "along", "by"}) {
      if (!value.contains(key)) {
        fail(path,
             fmt::format("a step has \"move\", \"along\" and \"by\"; \"{}\" is missing", key));
      }
    }
    Explode::Step step;
    step.place = place(path);
    const Json& move = value["move"];
    const Json selectors = move.is_array() ? move : Json::array({move});
    if (selectors.empty()) fail(path + "/move", "\"move\" names no parts");
    for (const Json& selector : selectors) step.move.push_back(text(selector, path + "/move"));
    const Vec3 along = vector(value["along"], path + "/along");
    const double length = glm::length(along);
    if (!(length > 0 && length < 1e300)) {
      fail(path + "/along", "\"along\" takes a direction but 0,0,0");
    }
    step.along = along / length;
    step.by = number(value["by"], path + "/by");
    if (!(step.by > 0 && step.by <= 1e12)) {
      fail(path + "/by", fmt::format("\"by\" takes mm over 0, not {}: a step moves parts, and "
                                     "\"along\" says which way",
                                     value["by"].dump()));
    }
    if (value.contains("trail")) {
      if (!value["trail"].is_boolean()) fail(path + "/trail", "\"trail\" takes true or false");
      step.trail = value["trail"].get<bool>();
    }
    return step;
  }

  void lights(const Json& value, const std::string& path) {
    check_array(value, path);
    out_.request.lights.clear();
    for (std::size_t i = 0; i < value.size(); ++i) {
      out_.request.lights.push_back(light(value[i], fmt::format("{}/{}", path, i)));
    }
  }

  tone::Light light(const Json& value, const std::string& path) const {
    check_object(value, path, detail::kLightKeys);
    const auto has = [&](const char* name) { return value.contains(name); };
    if (static_cast<int>(has("ambient")) + has("from") + has("at") != 1) {
      fail(path, "a light has one of \"ambient\", \"from\" and \"at\"");
    }
    tone::Light light;
    if (has("ambient")) {
      light.kind = tone::Light::Kind::Ambient;
      light.strength = strength(value["ambient"], path + "/ambient");
      if (has("strength")) fail(path + "/strength", "that of an ambient light is its number");
      return light;
    }
    const char* name = has("from") ? "from" : "at";
    const std::string at = fmt::format("{}/{}", path, name);
    light.kind = has("from") ? tone::Light::Kind::From : tone::Light::Kind::At;
    light.place = vector(value[name], at);
    if (has("from") && light.place == Vec3(0)) fail(at, "\"from\" takes a direction but 0,0,0");
    if (has("strength")) light.strength = strength(value["strength"], path + "/strength");
    return light;
  }

  double strength(const Json& value, const std::string& path) const {
    const double s = number(value, path);
    if (!(s >= 0 && s <= 10)) fail(path, "a light takes a strength of 0 to 10");
    return s;
  }

  /// An object with only known members.
  void check_object(const Json& value, const std::string& path,
                    const std::vector<std::string>& known) const {
    if (!value.is_object()) fail(path, named(path) + " takes an object, {...}");
    for (const auto& [key, ignored] : value.items()) {
      if (std::ranges::find(known, key) == known.end()) unknown(path + "/" + key, key, known);
    }
  }
  void check_array(const Json& value, const std::string& path) const {
    if (!value.is_array()) fail(path, named(path) + " takes a list, [...]");
  }
  std::string text(const Json& value, const std::string& path) const {
    if (!value.is_string() || value.get<std::string>().empty())
      fail(path, named(path) + " takes text");
    return value.get<std::string>();
  }
  double number(const Json& value, const std::string& path) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      fail(path, named(path) + " takes a number");
    }
    return value.get<double>();
  }
  Vec3 vector(const Json& value, const std::string& path) const {
    if (!value.is_array() || value.size() != 3) fail(path, named(path) + " takes [x, y, z]");
    Vec3 v;
    for (int k = 0; k < 3; ++k) v[k] = number(value[static_cast<std::size_t>(k)], path);
    return v;
  }
  /// "/parts/0/place" as people say it.
  static std::string named(const std::string& path) {
    std::string name = path.substr(path.rfind('/') + 1);
    if (!name.empty() && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; })) {
      const std::string list = path.substr(0, path.rfind('/'));
      return "each of \"" + list.substr(list.rfind('/') + 1) + "\"";
    }
    return "\"" + name + "\"";
  }

  /// The text of an object whose members stand in the lines that they have in the file, so that
  /// whoever reads it names these.
  std::string text_at_lines(const Json& object, const std::string& path) const {
    std::string out;
    std::int64_t line = 1;
    write_at_lines(object, path, out, line);
    return out;
  }
  void write_at_lines(const Json& value, const std::string& path, std::string& out,
                      std::int64_t& line) const {
    if (!value.is_object()) {
      out += value.dump();
      return;
    }
    out += '{';
    bool first = true;
    for (const auto& [key, v] : value.items()) {
      if (!first) out += ',';
      first = false;
      const std::string at = path + "/" + key;
      for (const std::int64_t to = lines_.line(at); line < to; ++line) out += '\n';
      out += Json(key).dump() + ":";
      write_at_lines(v, at, out, line);
    }
    out += '}';
  }

  std::string found_path(const std::string& name) const {
    const fs::path path(name);
    return path.is_absolute() || folder_.empty() ? name : (folder_ / path).string();
  }

 public:
  /// Throws InputError.
  static std::string bytes_of(const std::string& file) {
    check_inputs({file});
    std::ifstream in(file, std::ios::binary);
    std::string text;
    std::vector<char> block(1 << 16);
    while (in.read(block.data(), static_cast<std::streamsize>(block.size())), in.gcount() > 0) {
      text.append(block.data(), static_cast<std::size_t>(in.gcount()));
      if (text.size() > kMostBytes) {
        throw InputError("is larger than 16 MB, which no illustration file is", file);
      }
    }
    return text;
  }

 private:
  std::string_view text_;
  std::string source_;
  fs::path folder_;
  JsonLines lines_;
  int extended_;
  Illustration& out_;
};

}  // namespace

namespace detail {

const std::vector<IllustrationKey>& illustration_keys() {
  static const std::vector<IllustrationKey> keys = {
      {"view.from", "view"},      {"view.up", "up"},         {"view.perspective", "perspective"},
      {"view.scale", "scale"},    {"view.center", "center"}, {"paper.size", "paper"},
      {"paper.margin", "margin"}, {"hidden", "hidden"},      {"tolerance", "tolerance"},
      {"seed", "seed"},           {"callouts", "callouts"},
  };
  return keys;
}

const RequestOption& option_named(const std::string& name) {
  return find_option(all_options(), name);
}

}  // namespace detail

bool is_illustration(const fs::path& path) { return path.extension() == ".json"; }

Illustration parse_illustration(std::string_view json, const std::string& source) {
  Illustration illustration;
  Reader(json, source, 0, illustration).read();
  if (illustration.inputs.empty()) {
    throw UsageError(source +
                     ": has no parts; name models: \"parts\": [{\"file\": \"part.step\"}]");
  }
  return illustration;
}

DrawRequest parse_settings(std::string_view json, const std::string& source) {
  Illustration illustration;
  Reader(json, source, 0, illustration).read();
  if (!illustration.inputs.empty()) {
    throw UsageError(source + ": \"parts\" are those of the scene here");
  }
  return std::move(illustration.request);
}

Illustration read_illustration(const fs::path& path) {
  return parse_illustration(Reader::bytes_of(path.string()), path.string());
}

DrawRequest merged(const DrawRequest& file, const DrawRequest& door) {
  DrawRequest all = file;
  for (const auto& [name, texts] : door.options) {
    std::vector<std::string>& to = all.options[name];
    if (!find_option(all_options(), name).many) to.clear();
    to.insert(to.end(), texts.begin(), texts.end());
  }
  if (door.has("style") || !door.style_text.empty()) {
    all.style_text = door.style_text;
    all.style_source = door.style_source;
  }
  all.looks.insert(all.looks.end(), door.looks.begin(), door.looks.end());
  if (!door.lights.empty()) all.lights = door.lights;
  all.sections.insert(all.sections.end(), door.sections.begin(), door.sections.end());
  if (door.explode.wanted) all.explode = door.explode;
  if (!door.title.empty()) all.title = door.title;
  if (!door.items.empty()) all.items = door.items;
  return all;
}

}  // namespace burin
