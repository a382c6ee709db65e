#include <burin/drawing/color.h>

#include <charconv>
#include <cstddef>

namespace burin {

std::optional<Rgb> rgb_of(std::string_view text) {
  constexpr std::size_t kLength = 7;
  constexpr int kHexadecimal = 16;
  if (text.size() != kLength || text[0] != '#') return std::nullopt;
  Rgb rgb{};
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    const char* begin = text.data() + 1 + 2 * i;
    const auto read = std::from_chars(begin, begin + 2, rgb[i], kHexadecimal);
    if (read.ec != std::errc{} || read.ptr != begin + 2) return std::nullopt;
  }
  return rgb;
}

}  // namespace burin
