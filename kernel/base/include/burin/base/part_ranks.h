#pragma once
/// Which of two parts is seen where they lie on each other.

#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Whether part `a` is: the one of the higher rank, of equal ones the first. `ranks`: one a part;
/// those beyond its end have 0.
inline bool precedes(std::span<const double> ranks, std::int32_t a, std::int32_t b) {
  const auto rank = [&](std::int32_t part) {
    const auto i = static_cast<std::size_t>(part);
    return i < ranks.size() ? ranks[i] : 0;
  };
  return rank(a) != rank(b) ? rank(a) > rank(b) : a < b;
}

}  // namespace burin
