#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/missing_file.h>
#include <burin/converters/request.h>

#include "named_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace burin {

Style load_style(const std::string& name, const Style* whole) {
  const auto builtin = builtin_styles();
  if (std::any_of(builtin.begin(), builtin.end(),
                  [&](const StyleInfo& s) { return s.name == name; })) {
    return builtin_style(name);
  }
  InputFiles::opens(name);
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error)) {
    const bool path = name.find('/') != std::string::npos || name.ends_with(".json");
    if (path) throw MissingFile("there is no such style file; check the path", name);
    return builtin_style(name);
  }
  std::ifstream in(name, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) throw InputError("the style file cannot be read", name);
  Style style = parse_style(text, name, builtin_style("technical"), whole);
  detail::find_named_files(style, std::filesystem::path(name).parent_path());
  return style;
}

}  // namespace burin
