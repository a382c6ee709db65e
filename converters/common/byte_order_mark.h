#pragma once
/// The mark of UTF-8 that some programs put before a text.

#include <cstddef>
#include <string_view>

namespace burin {

/// How many bytes of a text are its byte order mark: 3 or 0.
inline std::size_t byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.starts_with(kMark) ? kMark.size() : 0;
}

}  // namespace burin
