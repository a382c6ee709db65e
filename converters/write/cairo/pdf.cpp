#include <burin/base/error.h>
#include <burin/drawing/color.h>
#include <burin/drawing/near_sheet.h>
#include <burin/drawing/title.h>

#include "letters.h"
#include "pdf_date.h"
#include "shapes.h"
#include "writers.h"

#include <cairo-pdf.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <ostream>
#include <string>

namespace burin {
namespace {

/// Shapes from which on neighbours become one path: cairo keeps a kilobyte for each.
constexpr std::size_t kMany = 50'000;
constexpr std::size_t kTogether = 64;

/// Where cairo's bytes go. They stop when the run is cancelled.
struct Sink {
  std::ostream& out;
  const RunContext& context;
};

cairo_status_t write_bytes(void* sink, const unsigned char* bytes, unsigned int n) {
  const Sink& to = *static_cast<Sink*>(sink);
  if (to.context.cancelled()) return CAIRO_STATUS_WRITE_ERROR;
  to.out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(n));
  return CAIRO_STATUS_SUCCESS;
}

void set_metadata(cairo_surface_t* surface, const Drawing& drawing) {
  const auto set = [&](cairo_pdf_metadata_t what, const std::string& text) {
    cairo_pdf_surface_set_metadata(surface, what, text.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, title_of(drawing));
  set(CAIRO_PDF_METADATA_SUBJECT, subject_of(drawing));
  set(CAIRO_PDF_METADATA_CREATOR, creator());
  const std::string date = asked_date("%Y-%m-%dT%H:%M:%SZ");
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                 date.empty() ? nullptr : date.c_str());
}

/// Paints shapes, up to `together` neighbours of one pen as one path, and drops their ink.
/// `used`: the colour that the pen has.
void paint_all(cairo_t* pen, std::span<Shape> shapes, std::size_t together, Rgb& used) {
  std::size_t traced = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].area && shapes[i].area->opacity < 1) {
      use(pen, shapes[i].color, shapes[i].area->opacity);
      trace(pen, shapes[i]);
      paint_traced(pen, shapes[i]);
      use(pen, used);
      continue;
    }
    if (shapes[i].color != used) use(pen, used = shapes[i].color);
    if (shapes[i].text) {
      show_letters(pen, *shapes[i].text);
      continue;
    }
    trace(pen, shapes[i]);
    shapes[i].ink.chains = {};
    ++traced;
    const bool last = i + 1 == shapes.size() || !same_pen(shapes[i], shapes[i + 1]);
    if (!last && traced < together) continue;
    paint_traced(pen, shapes[i]);
    traced = 0;
  }
}

/// The shares of the work that are done when a page begins and ends.
struct Progress {
  const WriteOptions& options;
  double from = 0, to = 1;

  void report(double share) const {
    constexpr double kPainted = 0.8;  // the rest is writing
    if (options.progress) options.progress(kPainted * (from + share * (to - from)));
  }
};

void paint_page(cairo_surface_t* surface, const Drawing& drawing, const WriteOptions& options,
                const Progress& progress, const RunContext& context) {
  const NearSheet sheet(drawing);
  std::vector<Shape> shapes = shapes_of(sheet.layers(), drawing, options.svg.dashes);
  const Pen pen = pen_on(surface, drawing.paper_height, kPointsPerMm, 0);
  Rgb used{};
  if (drawing.paper_color != Drawing().paper_color) {
    use(pen.get(), used = rgb_of(drawing.paper_color).value_or(Rgb{}));
    cairo_paint(pen.get());
  }
  for (std::size_t begin = 0; begin < shapes.size(); begin += kAtOnce) {
    const auto some = std::span(shapes).subspan(begin, std::min(kAtOnce, shapes.size() - begin));
    fit_ink(some, options.svg.fit_tolerance, TextsAs::Letters, context);
    paint_all(pen.get(), some, shapes.size() > kMany ? kTogether : 1, used);
    context.check();
    progress.report(static_cast<double>(begin) / static_cast<double>(shapes.size()));
  }
  check(cairo_status(pen.get()));
}

}  // namespace

std::string asked_date(const char* form) {
  const char* text = std::getenv("SOURCE_DATE_EPOCH");
  long long seconds = 0;
  if (!text || std::from_chars(text, text + std::strlen(text), seconds).ec != std::errc())
    return {};
  const auto time = static_cast<std::time_t>(seconds);
  std::tm date{};
  if (!::gmtime_r(&time, &date)) return {};
  std::array<char, 32> out{};
  std::strftime(out.data(), out.size(), form, &date);
  return out.data();
}

void write_pdf(std::span<const Drawing* const> pages, const WriteOptions& options,
               std::ostream& out, const RunContext& context) {
  const auto has_inks = [](const Drawing* page) { return !page->inks.empty(); };
  if (std::ranges::any_of(pages, has_inks))
    return write_pdf_with_inks(pages, options, out, context);
  const auto points = [](double mm) { return mm * kPointsPerMm; };
  const Drawing& first = *pages.front();
  Sink sink{out, context};
  const Surface surface(cairo_pdf_surface_create_for_stream(
      write_bytes, &sink, points(first.paper_width), points(first.paper_height)));
  check(cairo_surface_status(surface.get()));
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_5);
  set_metadata(surface.get(), first);
  const auto count = static_cast<double>(pages.size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (i > 0) {
      cairo_surface_show_page(surface.get());
      cairo_pdf_surface_set_size(surface.get(), points(pages[i]->paper_width),
                                 points(pages[i]->paper_height));
    }
    const auto done = static_cast<double>(i);
    paint_page(surface.get(), *pages[i], options, {options, done / count, (done + 1) / count},
               context);
  }
  cairo_surface_finish(surface.get());
  context.check();
  check(cairo_surface_status(surface.get()));
}

}  // namespace burin
