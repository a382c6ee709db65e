#include "keyed.h"

#include <burin/base/missing_file.h>
#include <burin/options/meant.h>
#include <burin/plugin/sources.h>

#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>

namespace burin::detail {

namespace fs = std::filesystem;

namespace {

/// "/parts/0/place" as people say it.
std::string named(const std::string& path) {
  std::string name = path.substr(path.rfind('/') + 1);
  if (!name.empty() && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; })) {
    const std::string list = path.substr(0, path.rfind('/'));
    return "each of \"" + list.substr(list.rfind('/') + 1) + "\"";
  }
  return "\"" + name + "\"";
}

}  // namespace

std::string option_text(const Json& value) {
  // A whole number that is written 1.0.
  constexpr double kExact = 9007199254740992;
  if (value.is_number_float() && std::abs(value.get<double>()) < kExact &&
      value.get<double>() == std::floor(value.get<double>())) {
    return fmt::format("{:.0f}", value.get<double>() + 0.0);
  }
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::vector<std::string> texts;
  for (const Json& element : value) texts.push_back(option_text(element));
  // Names among which are such with commas: views, of which some are directions.
  const bool names = std::ranges::any_of(value, [](const Json& v) { return v.is_string(); });
  const bool commas = std::ranges::any_of(
      texts, [](const std::string& text) { return text.find(',') != std::string::npos; });
  return fmt::format("{}", fmt::join(texts, names && commas ? ";" : ","));
}

KeyedFile::KeyedFile(std::string_view text, std::string source)
    : source_(std::move(source)), folder_(fs::path(source_).parent_path()), lines_(text) {}

KeyedFile KeyedFile::of_mark(const std::string& source, const std::string& what) {
  KeyedFile in("{}", source);
  in.mark_ = fmt::format("{}: {}: ", source, what);
  return in;
}

std::string KeyedFile::place(const std::string& path) const {
  if (!mark_.empty()) return mark_;
  return fmt::format("{}:{}: ", source_, lines_.line(path));
}

void KeyedFile::fail(const std::string& path, const std::string& what) const {
  throw UsageError(fmt::format("{}{}", place(path), what));
}

void KeyedFile::unknown(const std::string& path, const std::string& key,
                        const std::vector<std::string>& known) const {
  std::vector<KnownWord> words = known_words(known);
  for (KnownWord& word : words) {
    for (const RequestOption& option : all_options()) {
      if (option.option.name == word.name) word.also = option.also;
    }
  }
  if (const KnownWord* near = meant(key, words)) {
    fail(path, fmt::format("unknown key '{}'; did you mean '{}'?", key, near->name));
  }
  fail(path, fmt::format("unknown key '{}'; known here are {}", key, fmt::join(known, ", ")));
}

void KeyedFile::check_object(const Json& value, const std::string& path) const {
  if (!value.is_object()) fail(path, named(path) + " takes an object, {...}");
}

void KeyedFile::check_array(const Json& value, const std::string& path) const {
  if (!value.is_array()) fail(path, named(path) + " takes a list, [...]");
}

std::string KeyedFile::text(const Json& value, const std::string& path) const {
  if (!value.is_string() || value.get<std::string>().empty()) {
    fail(path, named(path) + " takes text");
  }
  return value.get<std::string>();
}

std::vector<std::string> KeyedFile::text_list(const Json& value, const std::string& path) const {
  std::vector<std::string> texts;
  const Json list = value.is_array() ? value : Json::array({value});
  for (const Json& element : list) texts.push_back(text(element, path));
  return texts;
}

bool KeyedFile::flag(const Json& value, const std::string& path) const {
  if (!value.is_boolean()) fail(path, named(path) + " takes true or false");
  return value.get<bool>();
}

double KeyedFile::number(const Json& value, const std::string& path) const {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    fail(path, named(path) + " takes a number");
  }
  return value.get<double>();
}

double KeyedFile::within(const Json& value, const std::string& path, double least, double most,
                         const char* takes) const {
  const double given = number(value, path);
  if (!(given >= least && given <= most)) {
    fail(path, fmt::format("{} takes {}, not {}", named(path), takes, value.dump()));
  }
  return given;
}

void KeyedFile::check_type(const Json& value, const std::string& path, const Json& schema) const {
  const Json type = schema.value("type", Json());
  if (type == "boolean") flag(value, path);
  if (type == "number") number(value, path);
  if (type == "integer" && number(value, path) != std::floor(value.get<double>())) {
    fail(path, named(path) + " takes a whole number");
  }
  if (type == "array") vector(value, path);
  if (!type.is_array()) return;
  const auto takes = [&](const char* name) {
    return std::ranges::find(type, Json(name)) != type.end();
  };
  const bool right = (value.is_string() && takes("string")) ||
                     (value.is_number() && takes("number")) ||
                     (value.is_array() && takes("array")) || (value.is_object() && takes("object"));
  if (right) return;
  fail(path, fmt::format("{} takes {}", named(path),
                         takes("object") ? "text, a list of texts, or an object"
                                         : "text, a number or a list"));
}

void KeyedFile::check_repeated() const {
  if (!lines_.repeated()) return;
  const auto& [key, line] = *lines_.repeated();
  throw UsageError(fmt::format("{}:{}: the key '{}' is here a second time; keep one of them",
                               source_, line, key));
}

Vec3 KeyedFile::vector(const Json& value, const std::string& path) const {
  if (!value.is_array() || value.size() != 3) fail(path, named(path) + " takes [x, y, z]");
  Vec3 v;
  for (int k = 0; k < 3; ++k) v[k] = number(value[static_cast<std::size_t>(k)], path);
  return v;
}

std::string KeyedFile::text_at_lines(const Json& object, const std::string& path) const {
  std::string out;
  std::int64_t line = 1;
  write_at_lines(object, path, out, line);
  return out;
}

void KeyedFile::write_at_lines(const Json& value, const std::string& path, std::string& out,
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

std::string KeyedFile::found_path(const std::string& name) const {
  const fs::path path(name);
  if (plugin::names_form(name)) return name;
  return path.is_absolute() || folder_.empty() ? name : (folder_ / path).string();
}

std::string KeyedFile::style_named(const Json& value, const std::string& path) const {
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

}  // namespace burin::detail
