#include <burin/base/error.h>

#include "cairo_loader.h"
#include "own_formats.h"
#include "png_options.h"
#include "sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

void check_pdf(double width, double height, const WriteOptions& /*options*/) {
  if (std::max(width, height) <= kLargestPdf) return;
  throw UsageError(
      fmt::format("a sheet of {} x {} mm is too large for PDF, which ends at {} mm; choose a "
                  "smaller one",
                  width, height, kLargestPdf));
}

void check_png(double width, double height, const WriteOptions& options) {
  const double side = std::max(width, height), dpi = values_in<PngOptions>(options.formats).dpi;
  if (side * dpi / kMmPerInch <= kMostPixels) return;
  throw UsageError(
      fmt::format("a picture of {:.0f} x {:.0f} pixels is too large, {} a side are the most; set "
                  "png.dpi to {}",
                  width * dpi / kMmPerInch, height * dpi / kMmPerInch, kMostPixels,
                  std::floor(kMostPixels * kMmPerInch / side)));
}

}  // namespace

Format pdf_format() {
  return {"pdf",
          {},
          [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
            const Drawing* const page = &d;
            cairo_library().write_pdf({&page, 1}, o, out, c);
          },
          check_pdf};
}

Format png_format() {
  return {"png",
          {"png."},
          [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
            cairo_library().write_png(d, o, out, c);
          },
          check_png};
}

}  // namespace burin::detail
