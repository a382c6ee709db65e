#include <burin/base/missing_file.h>

#include "illustration_keyed.h"

#include <fstream>

namespace burin {
namespace {

using detail::Json;
using detail::KeyedFile;
namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 24;
constexpr int kMostExtended = 16;

/// Sets an option of the drawing, once its row takes the value.
void set_option(const KeyedFile& in, const std::string& option, const Json& value,
                const std::string& path, const std::string& key, IllustrationFile& out) {
  const bool size = option == "paper" && value.is_array() && value.size() == 2;
  const std::string given =
      size ? fmt::format("{}x{}", detail::option_text(value[0]), detail::option_text(value[1]))
           : detail::option_text(value);
  in.check(detail::draw_rows(), option, {given}, path, key);
  out.request.options[option] = {given};
}

/// A key that is an option of the same name.
void take_option(const KeyedFile& in, const Json& value, const std::string& path,
                 IllustrationFile& out) {
  const std::string name = path.substr(1);
  set_option(in, name, value, path, name, out);
}

/// Members of a group, "view" or "paper".
void take_group(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  const std::string prefix = path.substr(1) + ".";
  std::vector<std::string> known;
  for (const detail::IllustrationKey& key : detail::illustration_keys()) {
    if (key.path.starts_with(prefix)) known.push_back(key.path.substr(prefix.size()));
  }
  in.check_object(value, path, known);
  for (const detail::IllustrationKey& key : detail::illustration_keys()) {
    if (!key.path.starts_with(prefix)) continue;
    const std::string name = key.path.substr(prefix.size());
    if (value.contains(name)) {
      set_option(in, key.option, value[name], path + "/" + name, key.path, out);
    }
  }
}

void take_paper(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  if (value.is_object()) return take_group(in, value, path, out);
  set_option(in, "paper", value, path, "paper", out);
}

/// A key of the file and what reads it; null: read before all others, or by nobody.
struct Member {
  std::string name;
  detail::TakeKey* take;
};

const std::vector<Member>& members() {
  static const std::vector<Member> all = [] {
    std::vector<Member> rows = {{"burin", nullptr},
                                {"version", nullptr},
                                {"$schema", nullptr},
                                {"extends", nullptr},
                                {"parts", detail::take_parts},
                                {"style", detail::take_style},
                                {"looks", detail::take_looks},
                                {"lights", detail::take_lights},
                                {"title", detail::take_title},
                                {"items", detail::take_items},
                                {"parts_list", detail::take_parts_list},
                                {"view", take_group},
                                {"paper", take_paper},
                                {"section", detail::take_sections},
                                {"explode", detail::take_explode},
                                {"details", detail::take_details}};
    for (const detail::IllustrationKey& key : detail::illustration_keys()) {
      const bool grouped = key.path.find('.') != std::string::npos;
      if (!grouped) rows.push_back({key.path, take_option});
    }
    return rows;
  }();
  return all;
}

Json parse(std::string_view text, const std::string& source) {
  return parse_json_object<Json>(
      text, source, "illustration file",
      "an illustration file is one JSON object, {\"burin\": \"illustration\", ...}");
}

void check_kind(const KeyedFile& in, const Json& json) {
  if (json.contains("format")) {
    throw InputError(
        "is a drawing, which is drawn already; burin convert writes it in other "
        "formats",
        in.source());
  }
  if (!json.contains("burin") || json["burin"] != "illustration") {
    throw InputError("is no illustration file: its first key is \"burin\": \"illustration\"",
                     in.source());
  }
  if (json.contains("version") && json["version"] != 1) {
    in.fail("/version", "this Burin reads version 1 of illustration files");
  }
}

/// Throws InputError.
std::string bytes_of(const std::string& file) {
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

void read(std::string_view text, const std::string& source, int extended, IllustrationFile& out);

void extend(const KeyedFile& in, const Json& value, int extended, IllustrationFile& out) {
  const std::string file = in.found_path(in.text(value, "/extends"));
  if (extended >= kMostExtended) {
    in.fail("/extends", "\"extends\" makes a chain of more than 16 files, or a ring of them");
  }
  std::string house;
  try {
    house = bytes_of(file);
  } catch (const InputError& e) {
    in.fail("/extends", fmt::format("'{}' {}", file, e.what()));
  }
  read(house, file, extended + 1, out);
}

/// One file, into an illustration that may hold what it extends.
void read(std::string_view text, const std::string& source, int extended, IllustrationFile& out) {
  const KeyedFile in(text, source);
  const Json json = parse(text, source);
  check_kind(in, json);
  if (json.contains("extends")) extend(in, json["extends"], extended, out);
  for (const auto& [key, value] : json.items()) {
    const std::string path = "/" + key;
    const auto member = std::ranges::find(members(), key, &Member::name);
    if (member == members().end()) {
      std::vector<std::string> known;
      for (const Member& other : members()) known.push_back(other.name);
      in.unknown(path, key, known);
    }
    if (member->take) member->take(in, value, path, out);
  }
}

}  // namespace

namespace detail {

const std::vector<IllustrationKey>& illustration_keys() {
  static const std::vector<IllustrationKey> keys = {
      {"view.from", "view"},
      {"view.up", "up"},
      {"view.perspective", "perspective"},
      {"view.scale", "scale"},
      {"view.center", "center"},
      {"paper.size", "paper"},
      {"paper.margin", "margin"},
      {"hidden", "hidden"},
      {"tolerance", "tolerance"},
      {"seed", "seed"},
      {"callouts", "callouts"},
      {"views", "views"},
      {"projection", "projection"},
  };
  return keys;
}

const RequestOption& option_named(const std::string& name) {
  return find_option(all_options(), name);
}

}  // namespace detail

bool is_illustration(const fs::path& path) { return path.extension() == ".json"; }

IllustrationFile parse_illustration(std::string_view json, const std::string& source) {
  IllustrationFile illustration;
  read(json, source, 0, illustration);
  if (illustration.inputs.empty()) {
    throw UsageError(source +
                     ": has no parts; name models: \"parts\": [{\"file\": \"part.step\"}]");
  }
  return illustration;
}

DrawRequest parse_settings(std::string_view json, const std::string& source) {
  IllustrationFile illustration;
  read(json, source, 0, illustration);
  if (!illustration.inputs.empty()) {
    throw UsageError(source + ": \"parts\" are those of the scene here");
  }
  return std::move(illustration.request);
}

IllustrationFile read_illustration(const fs::path& path) {
  return parse_illustration(bytes_of(path.string()), path.string());
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
  all.details.insert(all.details.end(), door.details.begin(), door.details.end());
  if (door.explode.wanted) all.explode = door.explode;
  if (!door.title.empty()) all.title = door.title;
  if (!door.items.empty()) all.items = door.items;
  return all;
}

}  // namespace burin
