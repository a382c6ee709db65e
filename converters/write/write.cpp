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
#include <cctype>
#include <cmath>

namespace burin {
namespace {

struct Row {
  const char* name;
  Format format;
};
constexpr std::array kFormats{Row{"svg", Format::Svg}, Row{"pdf", Format::Pdf},
                              Row{"eps", Format::Eps}, Row{"png", Format::Png},
                              Row{"dxf", Format::Dxf}, Row{"json", Format::Json}};

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
  WriteOptions options;
  options.svg = {.flatten_polylines = style.svg.flatten,
                 .fit_tolerance = style.svg.fit_tolerance,
                 .dash = style.line.dash,
                 .gap = style.line.gap,
                 .merge = style.svg.merge};
  options.json = {.points3 = style.json.points3};
  options.png = {.dpi = style.png.dpi, .transparent = style.png.background == "transparent"};
  options.dxf = {.splines = style.dxf.splines};
  return options;
}

void check_sheet(double width, double height, Format format, const WriteOptions& options) {
  const double side = std::max(width, height);
  if (!(std::min(width, height) > 0)) {
    throw UsageError(fmt::format("a sheet of {} x {} mm has no room", width, height));
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
  switch (format) {
    case Format::Svg:
      return write_svg(drawing, options.svg, out, context);
    case Format::Pdf:
      return cairo_library().write_pdf(drawing, options, out, context);
    case Format::Eps:
      return write_eps(drawing, options, out, context);
    case Format::Png:
      return cairo_library().write_png(drawing, options, out, context);
    case Format::Dxf:
      return write_dxf(drawing, options, out, context);
    case Format::Json:
      return write_json(drawing, options.json, out, context);
  }
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
