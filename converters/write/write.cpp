#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/converters/output.h>
#include <burin/converters/write.h>

#include "cairo_loader.h"
#include "dxf.h"
#include "eps.h"
#include "sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace burin {
namespace {

using Keys = std::span<const std::string_view>;

// Keys of styles, or how they begin, that concern one format alone.
constexpr std::array<std::string_view, 2> kSvgKeys{"svg.flatten", "svg.merge"};
constexpr std::array<std::string_view, 1> kPngKeys{"png."}, kDxfKeys{"dxf."}, kJsonKeys{"json."};
// ... and those that all formats look at.
constexpr std::array<std::string_view, 3> kFileKeys{"svg.", "line.dash", "line.gap"};

bool among(std::string_view key, Keys keys) {
  return std::ranges::any_of(keys, [&](std::string_view k) { return key.starts_with(k); });
}

/// A new format is a row here and a source that writes it.
struct Writer {
  std::string_view name;
  Format format;
  Keys keys;
  void (*write)(const Drawing&, const WriteOptions&, std::ostream&, const RunContext&);
};

constexpr std::array kWriters{
    Writer{"svg", Format::Svg, kSvgKeys,
           [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
             write_svg(d, o.svg, out, c);
           }},
    Writer{"pdf",
           Format::Pdf,
           {},
           [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
             cairo_library().write_pdf(d, o, out, c);
           }},
    Writer{"eps", Format::Eps, {}, write_eps},
    Writer{"png", Format::Png, kPngKeys,
           [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
             cairo_library().write_png(d, o, out, c);
           }},
    Writer{"dxf", Format::Dxf, kDxfKeys, write_dxf},
    Writer{"json", Format::Json, kJsonKeys,
           [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
             write_json(d, o.json, out, c);
           }},
};

const Writer& writer_of(Format format) {
  return *std::ranges::find(kWriters, format, &Writer::format);
}

}  // namespace

std::optional<Format> format_named(std::string_view name) {
  const std::string lower = lowered(name);
  const auto found = std::ranges::find(kWriters, lower, &Writer::name);
  return found == kWriters.end() ? std::nullopt : std::optional(found->format);
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Writer& writer : kWriters) names.emplace_back(writer.name);
  return names;
}

std::string_view name_of(Format format) { return writer_of(format).name; }

std::optional<Format> only_format_of(std::string_view key) {
  const auto found =
      std::ranges::find_if(kWriters, [&](const Writer& w) { return among(key, w.keys); });
  return found == kWriters.end() ? std::nullopt : std::optional(found->format);
}

bool is_about_files(std::string_view key) {
  return only_format_of(key).has_value() || among(key, kFileKeys);
}

std::string format_list(std::string_view before) {
  std::string list;
  for (std::size_t i = 0; i < kWriters.size(); ++i) {
    if (i > 0) list += i + 1 == kWriters.size() ? " or " : ", ";
    list += std::string(before) + std::string(kWriters[i].name);
  }
  return list;
}

WriteOptions write_options(const Style& style) {
  WriteOptions options;
  options.svg = style.svg;
  options.json = style.json;
  options.png = style.png;
  options.dxf = style.dxf;
  return options;
}

void check_sheet(double width, double height, Format format, const WriteOptions& options) {
  const double side = std::max(width, height);
  if (!(std::min(width, height) > 0)) {
    throw UsageError(
        fmt::format("a sheet of {} x {} mm has no area; give both sides a length", width, height));
  }
  if (format == Format::Pdf && side > kLargestPdf) {
    throw UsageError(
        fmt::format("a sheet of {} x {} mm is too large for PDF, which ends at {} mm; choose a "
                    "smaller one",
                    width, height, kLargestPdf));
  }
  const double dpi = options.png.dpi;
  if (format == Format::Png && side * dpi / kMmPerInch > kMostPixels) {
    throw UsageError(
        fmt::format("a picture of {:.0f} x {:.0f} pixels is too large, {} a side are the most; set "
                    "png.dpi to {}",
                    width * dpi / kMmPerInch, height * dpi / kMmPerInch, kMostPixels,
                    std::floor(kMostPixels * kMmPerInch / side)));
  }
}

void write_drawing(const Drawing& drawing, Format format, const WriteOptions& options,
                   std::ostream& out, const RunContext& context) {
  check_sheet(drawing.paper_width, drawing.paper_height, format, options);
  writer_of(format).write(drawing, options, out, context);
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
