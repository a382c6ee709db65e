#include <burin/base/rng.h>

#include <four_floats.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace burin::detail {
namespace {

#ifdef __SSE2__
struct alignas(16) Four {
  std::array<float, 4> v;
};

/// Every kind of number, nearly zero, infinite and none among them.
Four fours(const Rng& rng, std::uint64_t i) {
  constexpr std::array kOdd{0.0F,
                            -0.0F,
                            std::numeric_limits<float>::denorm_min(),
                            std::numeric_limits<float>::max(),
                            std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()};
  Four out{};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint64_t bits = rng.bits(4 * i + k);
    out.v[k] = bits % 8 == 0 ? kOdd[(bits >> 8) % kOdd.size()]
                             : static_cast<float>(static_cast<double>(bits >> 11) * 0x1p-51 - 2.0);
  }
  return out;
}

/// A bit for each pair that compares less, of what all operations make of three.
template <class T>
std::array<unsigned int, 4> compared(const Four& a, const Four& b, const Four& c) {
  const T x = T::load(a.v.data()), y = T::load(b.v.data()), z = T::load(c.v.data());
  const T made = T::max(T::abs(x - y * z), T::min(x + y, z * T(0.3F)));
  return {T::less(x, y), T::less(made, T(0.25F)), T::less(made, z), T::less(y * z - x, made)};
}

// What other processors compute is what this one does.
TEST(FourFloats, AreTheSameWithAndWithoutSse) {
  const Rng rng(11);
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const Four a = fours(rng, 3 * i), b = fours(rng, 3 * i + 1), c = fours(rng, 3 * i + 2);
    ASSERT_EQ(compared<SseFloats>(a, b, c), compared<PlainFloats>(a, b, c)) << i;
  }
}
#endif

TEST(FourFloats, CompareEachForItself) {
  alignas(16) const std::array<float, 4> v{-1, 2, -3, 4};
  const PlainFloats x = PlainFloats::load(v.data());
  EXPECT_EQ(PlainFloats::less(x, PlainFloats(0)), 0b0101U);
  EXPECT_EQ(PlainFloats::less(PlainFloats(2.5F), PlainFloats::abs(x)), 0b1100U);
}

}  // namespace
}  // namespace burin::detail
