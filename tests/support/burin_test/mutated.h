#pragma once
/// Damage for tests of readers.

#include <burin/base/rng.h>

#include <span>
#include <string>
#include <string_view>

namespace burin::test {

/// `bytes` with one to four changes: a byte, a cut, a word of `spice`, a repeated piece or an end
/// cut off. `n` counts the random numbers used.
inline std::string mutated(std::string bytes, std::span<const std::string_view> spice,
                           const Rng& rng, std::uint64_t& n) {
  const auto below = [&](std::size_t limit) {
    return static_cast<std::size_t>(rng.uniform(n++) * static_cast<double>(limit));
  };
  const std::size_t changes = 1 + below(4);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes.erase(at, 1 + below(8));
        break;
      case 2:
        bytes.insert(at, spice[below(spice.size())]);
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(60)));
        break;
      case 4:
        bytes.resize(at);
        break;
    }
  }
  return bytes;
}

}  // namespace burin::test
