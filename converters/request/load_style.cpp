#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/missing_file.h>
#include <burin/converters/request.h>

#include "named_files.h"
#include "style_files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace burin {

namespace {

/// The text of the file that a style is named by; nothing for a built-in one. Throws MissingFile,
/// InputError.
std::optional<std::string> text_of_style(const std::string& name) {
  const auto builtin = builtin_styles();
  if (std::ranges::find(builtin, name, &StyleInfo::name) != builtin.end()) return std::nullopt;
  InputFiles::opens(name);
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error)) {
    const bool path = name.find('/') != std::string::npos || name.ends_with(".json");
    if (path) throw MissingFile("there is no such style file; check the path", name);
    return std::nullopt;
  }
  std::ifstream in(name, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) throw InputError("the style file cannot be read", name);
  return text;
}

}  // namespace

namespace detail {

bool is_said_opaque(const std::string& style_text) {
  const auto style = nlohmann::json::parse(style_text, nullptr, false, true);
  const auto is_one = [](const nlohmann::json& value) {
    Style read = builtin_style("technical");
    read.fill.opacity = 0;
    set_style_key(read, "fill.opacity",
                  value.is_string() ? value.get<std::string>() : value.dump());
    return read.fill.opacity == 1;
  };
  if (style.contains("fill.opacity") && is_one(style["fill.opacity"])) return true;
  return style.contains("fill") && style["fill"].contains("opacity") &&
         is_one(style["fill"]["opacity"]);
}

LoadedStyle load_with_text(const std::string& name, const Style* whole) {
  const auto text = text_of_style(name);
  if (!text) return {builtin_style(name)};
  Style style = parse_style(*text, name, whole ? *whole : builtin_style("technical"), whole);
  find_named_files(style, std::filesystem::path(name).parent_path());
  return {std::move(style), *text, name};
}

}  // namespace detail

Style load_style(const std::string& name, const Style* whole) {
  return detail::load_with_text(name, whole).style;
}

}  // namespace burin
