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

/// Calls `one` with each file of a chain of illustrations: the one that is extended first, last the
/// text itself.
template <class F>
void for_each_file(std::string_view text, const std::string& source, const F& one,
                   int extended = 0) {
  const KeyedFile in(text, source);
  const Json json = parse(text, source);
  check_kind(in, json);
  in.check_repeated();
  if (json.contains("extends")) {
    const auto [file, base] = extended_text(in, json["extends"], extended);
    for_each_file(base, file, one, extended + 1);
  }
  one(in, json);
}

/// `members`: as `parse_illustration` has them; null: nobody asks.
IllustrationFile read(std::string_view text, const std::string& source, Json* members) {
  IllustrationFile out;
  const std::vector<KeyRow<IllustrationFile>>& rows = detail::rows_of_file();
  for_each_file(text, source, [&](const KeyedFile& in, const Json& json) {
    for (const auto& [key, value] : json.items()) {
      const std::string path = "/" + key;
      const auto row = std::ranges::find(rows, key, &KeyRow<IllustrationFile>::name);
      if (row == rows.end()) in.unknown(path, key, detail::names_of(rows));
      if (row->read) row->read(in, value, path, out);
      if (members) (*members)[key] = value;
    }
  });
  return out;
}

}  // namespace

bool is_illustration(const fs::path& path) { return path.extension() == ".json"; }

IllustrationFile parse_illustration(std::string_view json, const std::string& source,
                                    std::string* members) {
  Json all = Json::object();
  IllustrationFile illustration = read(json, source, members ? &all : nullptr);
  if (members) *members = all.dump();
  if (illustration.inputs.empty()) {
    throw UsageError(source +
                     ": has no parts; name models: \"parts\": [{\"file\": \"part.step\"}]");
  }
  return illustration;
}

DrawRequest parse_settings(std::string_view json, const std::string& source) {
  IllustrationFile illustration = read(json, source, nullptr);
  if (!illustration.inputs.empty()) {
    throw UsageError(source + ": \"parts\" are those of the scene here");
  }
  return std::move(illustration.request);
}

IllustrationFile read_illustration(const fs::path& path, std::string* members) {
  return parse_illustration(bytes_of(path.string()), path.string(), members);
}

DrawRequest merged(const DrawRequest& file, const DrawRequest& over) {
  DrawRequest all = file;
  for (const auto& [name, texts] : over.options) {
    std::vector<std::string>& to = all.options[name];
    if (!find_option(all_options(), name).many) to.clear();
    to.insert(to.end(), texts.begin(), texts.end());
  }
  if (over.has("style") || !over.style_text.empty()) {
    all.style_text = over.style_text;
    all.style_source = over.style_source;
  }
  all.looks.insert(all.looks.end(), over.looks.begin(), over.looks.end());
  if (!over.lights.empty()) all.lights = over.lights;
  all.sections.insert(all.sections.end(), over.sections.begin(), over.sections.end());
  all.breaks.insert(all.breaks.end(), over.breaks.begin(), over.breaks.end());
  all.details.insert(all.details.end(), over.details.begin(), over.details.end());
  all.threads.insert(all.threads.end(), over.threads.begin(), over.threads.end());
  all.dimensions.insert(all.dimensions.end(), over.dimensions.begin(), over.dimensions.end());
  if (over.explode.wanted) all.explode = over.explode;
  if (!over.title.empty()) all.title = over.title;
  if (!over.items.empty()) all.items = over.items;
  return all;
}

}  // namespace burin
