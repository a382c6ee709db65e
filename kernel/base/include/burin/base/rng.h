#pragma once
/// Counter-based random numbers: the n-th number of a stream is a pure function of its key and n.

#include <cstdint>

namespace burin {

/// A stream keyed by (seed, part, face): adding a part never reshuffles another one.
/// Each number is a mix of key and counter by the finaliser of SplitMix64. @cite Steele2014
class Rng {
 public:
  explicit Rng(std::uint64_t seed, std::uint64_t part = 0, std::uint64_t face = 0)
      : key_(mix(mix(mix(seed) + part) + face)) {}

  /// The 64 random bits at `counter`.
  std::uint64_t bits(std::uint64_t counter) const { return mix(key_ + counter * kGolden); }
  /// The uniform number in [0,1) at `counter`.
  double uniform(std::uint64_t counter) const {
    return static_cast<double>(bits(counter) >> 11) * 0x1.0p-53;
  }

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ull;
  static std::uint64_t mix(std::uint64_t z) {
    z += kGolden;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  std::uint64_t key_;
};

}  // namespace burin
