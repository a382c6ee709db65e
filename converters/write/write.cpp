#include <burin/converters/write.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace burin {
namespace {

struct Row {
  const char* name;
  Format format;
};
constexpr std::array kFormats{Row{"svg", Format::Svg}, Row{"json", Format::Json}};

}  // namespace

std::optional<Format> format_named(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Row& row : kFormats) {
    if (lower == row.name) return row.format;
  }
  return std::nullopt;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Row& row : kFormats) names.emplace_back(row.name);
  return names;
}

std::string format_list() {
  std::string list;
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    if (i > 0) list += i + 1 == kFormats.size() ? " or " : ", ";
    list += std::string(".") + kFormats[i].name;
  }
  return list;
}

WriteOptions write_options(const Style& style) {
  return {.svg = {.flatten_polylines = style.svg.flatten,
                  .fit_tolerance = style.svg.fit_tolerance,
                  .dash = style.line.dash,
                  .gap = style.line.gap,
                  .merge = style.svg.merge},
          .json = {.points3 = style.json.points3}};
}

void write_drawing(const Drawing& drawing, Format format, const WriteOptions& options,
                   std::ostream& out, const RunContext& context) {
  switch (format) {
    case Format::Svg:
      return write_svg(drawing, options.svg, out, context);
    case Format::Json:
      return write_json(drawing, options.json, out, context);
  }
}

}  // namespace burin
