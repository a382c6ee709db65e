#pragma once
/// Other programs and the pictures that they make, for tests of files.

#include <png.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace burin::test {

inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null").c_str()) == 0;
}

/// Runs a line of the shell, silently, for at most a minute; whether it succeeded.
inline bool shell(const std::string& line) {
  return std::system(("timeout 60 sh -c '" + line + "' </dev/null >/dev/null 2>&1").c_str()) == 0;
}

/// Grey, 0 black to 255 white, rows from the top.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> pixels;

  /// Ink, 0 to 1.
  double ink(std::size_t x, std::size_t y) const { return (255 - pixels[y * width + x]) / 255.0; }
};

/// An empty picture where the file is none.
inline Picture read_png(const std::string& path) {
  Picture p;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&image, path.c_str())) return p;
  image.format = PNG_FORMAT_GRAY;
  p.width = image.width;
  p.height = image.height;
  p.pixels.resize(PNG_IMAGE_SIZE(image));
  const png_color white{255, 255, 255};
  if (!png_image_finish_read(&image, &white, p.pixels.data(), 0, nullptr)) return {};
  return p;
}

/// The column about which the ink of columns [begin, end) lies.
inline double centre_of_ink(const Picture& p, std::size_t begin, std::size_t end) {
  double sum = 0, moment = 0;
  for (std::size_t y = 0; y < p.height; ++y) {
    for (std::size_t x = begin; x < end; ++x) {
      sum += p.ink(x, y);
      moment += p.ink(x, y) * (static_cast<double>(x) + 0.5);
    }
  }
  return sum > 0 ? moment / sum : -1;
}

/// The mean ink of a picture, and of the difference of two.
inline double mean_ink(const Picture& p) {
  double sum = 0;
  for (const std::uint8_t v : p.pixels) sum += 255 - v;
  return sum / 255 / static_cast<double>(p.pixels.size());
}
inline double mean_difference(const Picture& a, const Picture& b) {
  const std::size_t w = std::min(a.width, b.width), h = std::min(a.height, b.height);
  double sum = 0;
  for (std::size_t y = 0; y < h; ++y) {
    for (std::size_t x = 0; x < w; ++x) sum += std::abs(a.ink(x, y) - b.ink(x, y));
  }
  return sum / static_cast<double>(w * h);
}

}  // namespace burin::test
