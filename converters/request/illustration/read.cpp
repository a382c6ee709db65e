#include <burin/base/missing_file.h>

#include "rows.h"

#include <fstream>

namespace burin {
namespace {

using detail::Json;
using detail::KeyedFile;
using detail::KeyRow;
namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 24;
constexpr int kMostExtended = 16;

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

/// The name of a file that is extended, and its text.
std::pair<std::string, std::string> extended_text(const KeyedFile& in, const Json& value,
                                                  int extended) {
  std::string file = in.found_path(in.text(value, "/extends"));
  if (extended >= kMostExtended) {
    in.fail("/extends", "\"extends\" makes a chain of more than 16 files, or a ring of them");
  }
  try {
    std::string text = bytes_of(file);
    return {std::move(file), std::move(text)};
  } catch (const InputError& e) {
    in.fail("/extends", fmt::format("'{}' {}", file, e.what()));
  }
}

/// One file, into an illustration that may hold what it extends.
void read(std::string_view text, const std::string& source, int extended, IllustrationFile& out) {
  const KeyedFile in(text, source);
  const Json json = parse(text, source);
  check_kind(in, json);
  if (json.contains("extends")) {
    const auto [file, house] = extended_text(in, json["extends"], extended);
    read(house, file, extended + 1, out);
  }
  for (const auto& [key, value] : json.items()) {
    const std::string path = "/" + key;
    const auto row =
        std::ranges::find(detail::rows_of_file(), key, &KeyRow<IllustrationFile>::name);
    if (row == detail::rows_of_file().end())
      in.unknown(path, key, detail::names_of(detail::rows_of_file()));
    if (row->read) row->read(in, value, path, out);
  }
}

}  // namespace

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

namespace {

/// The members of a file over those of what it extends.
Json members_of(std::string_view text, const std::string& source, int extended) {
  const KeyedFile in(text, source);
  const Json json = parse(text, source);
  Json all = Json::object();
  if (json.contains("extends")) {
    const auto [file, house] = extended_text(in, json["extends"], extended);
    all = members_of(house, file, extended + 1);
  }
  for (const auto& [key, value] : json.items()) all[key] = value;
  return all;
}

}  // namespace

std::string illustration_members(std::string_view json, const std::string& source) {
  return members_of(json, source, 0).dump();
}

std::string illustration_members(const fs::path& path) {
  return illustration_members(bytes_of(path.string()), path.string());
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
