#include "encoding.h"
#include "text.h"

#include <cstdint>

namespace burin {
namespace {

constexpr std::size_t kLongestName = 200;

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xc2 ? 0
                             : lead < 0xe0 ? 2
                             : lead < 0xf0 ? 3
                             : lead < 0xf5 ? 4
                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  // Overlong forms, surrogates and what lies beyond the last code point.
  if ((lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xed && byte(1) > 0x9f)) return 0;
  if ((lead == 0xf0 && byte(1) < 0x90) || (lead == 0xf4 && byte(1) > 0x8f)) return 0;
  return length;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string clean_name(std::string_view name) {
  const bool utf8 = is_utf8(name);
  std::string out;
  while (!name.empty() && out.size() < kLongestName) {
    const std::size_t length = utf8 ? utf8_length(name) : 1;
    const auto lead = static_cast<std::uint8_t>(name[0]);
    const bool control = lead < 0x20 || lead == 0x7f || (!utf8 && lead >= 0x80 && lead < 0xa0);
    if (control) {
      out += ' ';
    } else if (lead < 0x80 || utf8) {
      out += name.substr(0, length);
    } else {
      out += static_cast<char>(0xc0 | lead >> 6);
      out += static_cast<char>(0x80 | (lead & 0x3f));
    }
    name.remove_prefix(length);
  }
  const std::size_t begin = out.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return out.substr(begin, out.find_last_not_of(' ') + 1 - begin);
}

}  // namespace burin
