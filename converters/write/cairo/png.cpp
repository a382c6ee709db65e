#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/color.h>
#include <burin/drawing/font.h>
#include <burin/drawing/near_sheet.h>
#include <burin/drawing/title.h>

#include "../png_options.h"
#include "../sheet.h"
#include "shapes.h"
#include "writers.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>

namespace burin {
namespace {

constexpr int kBandPixels = 1 << 22;
constexpr int kMostBandRows = 256;
constexpr int kBandsAtOnce = 16;

/// The picture in pixels and how it is cut into bands, each painted on its own.
struct Grid {
  double scale;  // pixels a mm
  int width, height, rows, bands;

  Grid(const Drawing& drawing, double dpi)
      : scale(dpi / kMmPerInch),
        width(pixels(drawing.paper_width, dpi)),
        height(pixels(drawing.paper_height, dpi)) {
    rows = std::clamp(kBandPixels / width, 16, kMostBandRows);
    bands = (height + rows - 1) / rows;
  }
};

/// The shapes that show in each band.
std::vector<std::vector<std::uint32_t>> by_band(const std::vector<Shape>& shapes, const Grid& grid,
                                                double paper_height) {
  std::vector<std::vector<std::uint32_t>> bands(static_cast<std::size_t>(grid.bands));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    double low = 0, high = 0, width = 0;
    if (const Area* area = shapes[i].area) {
      Box2 box;
      for (const std::vector<Vec2>& ring : area->rings) {
        for (const Vec2& p : ring) box.add(p);
      }
      low = box.min.y, high = box.max.y, width = kTrap;
    } else if (const Path* path = shapes[i].path) {
      low = high = path->points[0].y;
      for (const Vec2& p : path->points) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
      }
      for (const double w : path->width) width = std::max(width, w);
    } else {
      const Box2 box = text_box(*shapes[i].text);
      low = box.min.y, high = box.max.y;
    }
    const double room = width + 2 / grid.scale + 0.1;  // half of it and the fit, amply
    const auto band = [&](double y) {
      const double at = std::floor((paper_height - y) * grid.scale / grid.rows);
      return static_cast<int>(std::clamp(at, -1.0, static_cast<double>(grid.bands)));
    };
    const int first = std::max(band(high + room), 0);
    const int last = std::min(band(low - room), grid.bands - 1);
    for (int b = first; b <= last; ++b) {
      bands[static_cast<std::size_t>(b)].push_back(static_cast<std::uint32_t>(i));
    }
  }
  return bands;
}

/// How the pixels of a picture are held.
enum class Pixels {
  Gray,     // one ink, black on white or on nothing
  Palette,  // one ink of another colour, or coloured paper
  Colors,   // layers or lines have colours of their own
};

Pixels pixels_of(const Drawing& drawing, const PngOptions& options) {
  const auto has_color = [](const Layer& layer) {
    return !layer.color.empty() ||
           std::ranges::any_of(layer.paths, [](const Path& p) { return !p.color.empty(); });
  };
  if (std::ranges::any_of(drawing.layers, has_color) || !painted_areas(drawing).empty()) {
    return Pixels::Colors;
  }
  const bool transparent = options.background == PngOptions::Background::Transparent;
  const bool plain = drawing.ink_color == Drawing().ink_color &&
                     (transparent || drawing.paper_color == Drawing().paper_color);
  return plain ? Pixels::Gray : Pixels::Palette;
}

/// The ink of one band, 0 to 255 a pixel; with colours on its paper, or on nothing, as cairo has
/// it, premultiplied.
Surface painted_sheet(const std::vector<Shape>& shapes, const std::vector<std::uint32_t>& chosen,
                      const Grid& grid, int band, const Drawing& drawing, const PngOptions& options,
                      const RunContext& context) {
  constexpr std::size_t kBetweenPolls = 256;
  const bool colors = pixels_of(drawing, options) == Pixels::Colors;
  const int top = band * grid.rows;
  Surface surface(cairo_image_surface_create(colors ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_A8,
                                             grid.width, std::min(grid.rows, grid.height - top)));
  check(cairo_surface_status(surface.get()));
  const Pen pen = pen_on(surface.get(), drawing.paper_height, grid.scale, top);
  cairo_set_antialias(pen.get(), CAIRO_ANTIALIAS_BEST);
  if (colors && options.background == PngOptions::Background::White) {
    use(pen.get(), rgb_of(drawing.paper_color).value_or(Rgb{}));
    cairo_paint(pen.get());
  }
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (k % kBetweenPolls == 0) context.check();
    const Shape& shape = shapes[chosen[k]];
    if (colors) use(pen.get(), shape.color, shape.area ? shape.area->opacity : 1);
    trace(pen.get(), shape);
    paint_traced(pen.get(), shape);
  }
  check(cairo_status(pen.get()));
  cairo_surface_flush(surface.get());
  return surface;
}

/// libpng over a stream.
class PngFile {
 public:
  PngFile(std::ostream& out, const Grid& grid, const Drawing& drawing, const PngOptions& options)
      : transparent_(options.background == PngOptions::Background::Transparent),
        pixels_(pixels_of(drawing, options)),
        row_(static_cast<std::size_t>(grid.width) * 4) {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) throw std::bad_alloc();
    png_set_write_fn(png_, &out, write, [](png_structp) {});
    png_set_IHDR(
        png_, info_, static_cast<png_uint_32>(grid.width), static_cast<png_uint_32>(grid.height), 8,
        pixels_ == Pixels::Palette  ? PNG_COLOR_TYPE_PALETTE
        : pixels_ == Pixels::Colors ? (transparent_ ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB)
        : transparent_              ? PNG_COLOR_TYPE_GRAY_ALPHA
                                    : PNG_COLOR_TYPE_GRAY,
        PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (pixels_ == Pixels::Palette) set_palette(drawing);
    const auto per_metre = static_cast<png_uint_32>(std::lround(1000 * grid.scale));
    png_set_pHYs(png_, info_, per_metre, per_metre, PNG_RESOLUTION_METER);
    // Line art on empty paper: most bytes repeat, and filters only slow that down.
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE | PNG_FILTER_UP);
    std::string title = title_of(drawing), software = creator();
    std::array<png_text, 2> texts{};
    texts[0] = text("Title", title);
    texts[1] = text("Software", software);
    png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png_, info_);
  }
  ~PngFile() { png_destroy_write_struct(&png_, &info_); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  void append(cairo_surface_t* band) {
    const unsigned char* data = cairo_image_surface_get_data(band);
    const int rows = cairo_image_surface_get_height(band);
    const int width = cairo_image_surface_get_width(band);
    const int stride = cairo_image_surface_get_stride(band);
    for (int y = 0; y < rows; ++y) {
      const unsigned char* ink = data + static_cast<std::ptrdiff_t>(y) * stride;
      for (int x = 0; x < width; ++x) {
        const auto at = static_cast<std::size_t>(x);
        if (pixels_ == Pixels::Colors) {
          set_color(ink + 4 * at, at);
        } else if (pixels_ == Pixels::Palette) {
          row_[at] = ink[x];
        } else if (transparent_) {
          row_[2 * at] = 0;
          row_[2 * at + 1] = ink[x];
        } else {
          row_[at] = static_cast<unsigned char>(255 - ink[x]);
        }
      }
      png_write_row(png_, row_.data());
    }
  }
  void finish() { png_write_end(png_, nullptr); }

 private:
  // From cairo's premultiplied words to the bytes of PNG.
  void set_color(const unsigned char* from, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, from, sizeof word);
    const std::uint32_t alpha = word >> 24;
    unsigned char* to = row_.data() + (transparent_ ? 4 : 3) * at;
    for (int c = 0; c < 3; ++c) {
      const std::uint32_t value = (word >> (16 - 8 * c)) & 0xff;
      to[c] = static_cast<unsigned char>(alpha > 0 ? (255 * value + alpha / 2) / alpha : 0);
    }
    if (transparent_) to[3] = static_cast<unsigned char>(alpha);
  }
  // A colour for each share of ink, from the paper's to that of the ink.
  void set_palette(const Drawing& drawing) {
    const Rgb ink = rgb_of(drawing.ink_color).value_or(Rgb{}),
              paper = rgb_of(drawing.paper_color).value_or(Rgb{});
    constexpr int kShares = 256;
    std::array<png_color, kShares> colors{};
    std::array<png_byte, kShares> opaque{};
    for (std::size_t i = 0; i < colors.size(); ++i) {
      const auto mixed = [&](std::size_t c) {
        const double share = transparent_ ? 1 : static_cast<double>(i) / (kShares - 1);
        return static_cast<png_byte>(std::lround(paper[c] + share * (ink[c] - paper[c])));
      };
      colors[i] = {mixed(0), mixed(1), mixed(2)};
      opaque[i] = static_cast<png_byte>(i);
    }
    png_set_PLTE(png_, info_, colors.data(), kShares);
    if (transparent_) png_set_tRNS(png_, info_, opaque.data(), kShares, nullptr);
  }
  static png_text text(const char* key, std::string& value) {
    png_text t{};
    t.compression = PNG_ITXT_COMPRESSION_NONE;
    t.key = const_cast<char*>(key);  // libpng does not write to it
    t.text = value.data();
    t.itxt_length = value.size();
    return t;
  }
  static void write(png_structp png, png_bytep bytes, png_size_t n) {
    static_cast<std::ostream*>(png_get_io_ptr(png))
        ->write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(n));
  }
  [[noreturn]] static void fail(png_structp, png_const_charp what) {
    throw Error(std::string("libpng failed: ") + what);
  }

  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  bool transparent_;
  Pixels pixels_;
  std::vector<unsigned char> row_;
};

}  // namespace

void write_png(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
               const RunContext& context) {
  const auto png = values_in<PngOptions>(options.formats);
  const Grid grid(drawing, png.dpi);
  const NearSheet sheet(drawing);
  std::vector<Shape> shapes = shapes_of(sheet.layers(), drawing, options.svg.dashes);
  fit_ink(shapes, options.svg.fit_tolerance, TextsAs::Outlines, context);
  const auto chosen = by_band(shapes, grid, drawing.paper_height);
  PngFile file(out, grid, drawing, png);
  for (int begin = 0; begin < grid.bands; begin += kBandsAtOnce) {
    const int n = std::min(kBandsAtOnce, grid.bands - begin);
    std::vector<Surface> bands(static_cast<std::size_t>(n));
    parallel_for(
        bands.size(), 1,
        [&](std::size_t k, std::size_t) {
          const int band = begin + static_cast<int>(k);
          bands[k] = painted_sheet(shapes, chosen[static_cast<std::size_t>(band)], grid, band,
                                   drawing, png, context);
        },
        &context);
    for (const Surface& band : bands) {
      context.check();
      file.append(band.get());
    }
    if (options.progress) options.progress(static_cast<double>(begin + n) / grid.bands);
  }
  file.finish();
}

}  // namespace burin
