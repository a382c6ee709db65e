#include <burin/base/ascii.h>
#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/converters/output.h>
#include <burin/converters/write.h>
#include <burin/drawing/added_formats.h>

#include "own_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace burin {
namespace {

// Keys of styles, or how they begin, that several formats look at.
constexpr std::array<std::string_view, 3> kFileKeys{"svg.", "line.dash", "line.gap"};

template <class Keys>
bool among(std::string_view key, const Keys& keys) {
  return std::ranges::any_of(keys, [&](std::string_view k) { return key.starts_with(k); });
}

Format made_of(const AddedFormat& added) {
  return {added.name,
          {std::string(added.name) + "."},
          [added](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
            added.write(d, values_of(o.formats, added.name, added.options), out, c);
          }};
}

}  // namespace

const std::vector<Format>& formats() {
  static MadeOfCatalogues<std::vector<Format>> all;
  return all.get([] {
    std::vector<Format> rows = detail::own_formats();
    for (const AddedFormat& added : added_formats()) {
      if (!is_own_format(added.name)) rows.push_back(made_of(added));
    }
    return rows;
  });
}

bool is_own_format(std::string_view name) {
  static const std::vector<Format> own = detail::own_formats();
  return std::ranges::find(own, name, &Format::name) != own.end();
}

const Format* format_named(std::string_view name) {
  const std::string wanted = lowered(name);
  auto found = std::ranges::find(formats(), wanted, &Format::name);
  // A plug-in may have what is only another suffix of ours.
  if (found == formats().end()) {
    found = std::ranges::find_if(formats(), [&](const Format& f) {
      return std::ranges::find(f.other_suffixes, wanted) != f.other_suffixes.end();
    });
  }
  return found == formats().end() ? nullptr : &*found;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.emplace_back(format.name);
  return names;
}

const Format* only_format_of(std::string_view key) {
  const auto found =
      std::ranges::find_if(formats(), [&](const Format& f) { return among(key, f.keys); });
  return found == formats().end() ? nullptr : &*found;
}

bool is_about_files(std::string_view key) { return only_format_of(key) || among(key, kFileKeys); }

std::string format_list(std::string_view before) {
  std::string list;
  const std::vector<Format>& all = formats();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) list += i + 1 == all.size() ? " or " : ", ";
    list += std::string(before) + std::string(all[i].name);
  }
  return list;
}

WriteOptions write_options(const Style& style) {
  WriteOptions options;
  options.svg = values_in<SvgOptions>(style.formats);
  options.svg.dashes = style.dashes;
  options.formats = style.formats;
  return options;
}

void check_sheet(double width, double height, const Format& format, const WriteOptions& options) {
  if (!(std::min(width, height) > 0)) {
    throw UsageError(
        fmt::format("a sheet of {} x {} mm has no area; give both sides a length", width, height));
  }
  if (format.check_sheet) format.check_sheet(width, height, options);
}

void write_drawing(const Drawing& drawing, const Format& format, const WriteOptions& options,
                   std::ostream& out, const RunContext& context) {
  check_sheet(drawing.paper_width, drawing.paper_height, format, options);
  format.write(drawing, options, out, context);
}

void write_file(const Drawing& drawing, const std::filesystem::path& path,
                const WriteOptions& options, const RunContext& context) {
  std::vector<Output> outputs = plan_outputs({path.string()}, "", {});
  Output& file = outputs.front();
  file.write(
      [&](std::ostream& out) { write_drawing(drawing, file.format(), options, out, context); });
  context.check();
  file.commit();
}

}  // namespace burin
