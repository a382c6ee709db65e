#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/missing_file.h>
#include <burin/converters/pictures.h>

#include <fmt/format.h>
#include <png.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

constexpr std::uint64_t kMostPixels = 16'000'000;
constexpr std::size_t kSignature = 8;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// libpng must not return from this: it throws through C frames that hold nothing of ours.
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  throw InputError(fmt::format("the picture is damaged or cut off ({}); save it again", message),
                   *static_cast<const std::string*>(png_get_error_ptr(png)));
}
void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// The structures of libpng, which are freed whatever happens.
struct Reader {
  explicit Reader(std::string& name)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &name, on_error, on_warning)) {
    if (png == nullptr) throw std::bad_alloc();
    info = png_create_info_struct(png);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  png_structp png;
  png_infop info = nullptr;
};

}  // namespace

Image read_png(const std::filesystem::path& path) {
  InputFiles::opens(path);
  std::string name = path.string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw MissingFile("there is no such picture; check the path", name);
  }
  const File file(std::fopen(name.c_str(), "rb"));
  if (!file) throw InputError("the picture cannot be read", name);
  png_byte signature[kSignature];
  if (std::fread(signature, 1, kSignature, file.get()) != kSignature ||
      png_sig_cmp(signature, 0, kSignature) != 0) {
    throw InputError("the picture is no PNG; convert it", name);
  }
  const Reader reader(name);
  png_structp png = reader.png;
  png_infop info = reader.info;
  if (info == nullptr) throw std::bad_alloc();
  png_init_io(png, file.get());
  png_set_sig_bytes(png, kSignature);
  png_read_info(png, info);
  const std::uint64_t width = png_get_image_width(png, info),
                      height = png_get_image_height(png, info);
  if (width * height > kMostPixels) {
    throw InputError(
        fmt::format("the picture has {} x {} pixels, 16 million are the most; make it smaller",
                    width, height),
        name);
  }
  png_set_expand(png);
  png_set_strip_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  constexpr std::size_t kBytes = 4;
  if (png_get_rowbytes(png, info) != kBytes * width) {
    throw InputError("the picture has an unknown kind of pixels; save it as RGB", name);
  }
  Image image{static_cast<std::int32_t>(width), static_cast<std::int32_t>(height),
              std::vector<float>(width * height)};
  const auto take = [&](const png_byte* row, std::size_t y) {
    float* to = image.values.data() + (height - 1 - y) * width;
    for (std::size_t x = 0; x < width; ++x) {
      const png_byte* p = row + kBytes * x;
      const double alpha = p[3] / 255.0;
      const double grey = (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) / 255;
      to[x] = static_cast<float>(1 - alpha + alpha * grey);
    }
  };
  // Interlaced pictures are made of rows in several passes.
  std::vector<png_byte> pixels((passes > 1 ? height : 1) * kBytes * width);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < height; ++y) {
      png_byte* row = pixels.data() + (passes > 1 ? y * kBytes * width : 0);
      png_read_row(png, row, nullptr);
      if (pass + 1 == passes) take(row, y);
    }
  }
  return image;
}

}  // namespace burin
