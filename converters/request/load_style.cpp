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

namespace burin {

namespace detail {

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

Style read_style(const std::string& text, const std::string& file, const Style* whole) {
  Style style = parse_style(text, file, whole ? *whole : builtin_style("technical"), whole);
  find_named_files(style, std::filesystem::path(file).parent_path());
  return style;
}

}  // namespace detail

Style load_style(const std::string& name, const Style* whole) {
  const auto text = detail::text_of_style(name);
  return text ? detail::read_style(*text, name, whole) : builtin_style(name);
}

}  // namespace burin
