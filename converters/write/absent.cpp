#include "absent.h"

#include <burin/base/ascii.h>

#include "own_formats.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {

std::string needed_to_write(std::string_view format) {
  std::string name = lowered(format);
  const std::span<const std::string_view> known = known_formats();
  if (is_own_format(name) || std::ranges::find(known, name) == known.end()) return {};
  const bool by_cairo = name == "pdf" || name == "png";
  const std::string piece =
      by_cairo ? std::string(kWithPictures) : fmt::format("the writer {} (BURIN_WRITERS)", name);
  std::ranges::transform(name, name.begin(),
                         [](char c) { return static_cast<char>(c - 'a' + 'A'); });
  return needs(name + " files", piece);
}

}  // namespace burin::detail
