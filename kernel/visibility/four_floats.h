#pragma once
// Four numbers in single precision at once; internal to the module. Both classes round each
// operation as IEEE 754 says, so that they give the same bits.

#include <array>
#include <cstddef>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace burin::detail {

/// For every processor.
class PlainFloats {
 public:
  explicit PlainFloats(float all) { v_.fill(all); }
  /// `from`: four numbers at a multiple of 16 bytes.
  static PlainFloats load(const float* from) {
    return each([&](std::size_t i) { return from[i]; });
  }

  friend PlainFloats operator+(const PlainFloats& a, const PlainFloats& b) {
    return each([&](std::size_t i) { return a.v_[i] + b.v_[i]; });
  }
  friend PlainFloats operator-(const PlainFloats& a, const PlainFloats& b) {
    return each([&](std::size_t i) { return a.v_[i] - b.v_[i]; });
  }
  friend PlainFloats operator*(const PlainFloats& a, const PlainFloats& b) {
    return each([&](std::size_t i) { return a.v_[i] * b.v_[i]; });
  }
  /// Of two numbers of which one is none, `b`.
  static PlainFloats min(const PlainFloats& a, const PlainFloats& b) {
    return each([&](std::size_t i) { return a.v_[i] < b.v_[i] ? a.v_[i] : b.v_[i]; });
  }
  static PlainFloats max(const PlainFloats& a, const PlainFloats& b) {
    return each([&](std::size_t i) { return a.v_[i] > b.v_[i] ? a.v_[i] : b.v_[i]; });
  }
  static PlainFloats abs(const PlainFloats& a) {
    return each([&](std::size_t i) { return __builtin_fabsf(a.v_[i]); });
  }
  /// Bit i: a[i] < b[i].
  static unsigned int less(const PlainFloats& a, const PlainFloats& b) {
    unsigned int bits = 0;
    for (std::size_t i = 0; i < 4; ++i) bits |= static_cast<unsigned int>(a.v_[i] < b.v_[i]) << i;
    return bits;
  }

 private:
  PlainFloats() = default;
  template <class F>
  static PlainFloats each(const F& f) {
    PlainFloats out;
    for (std::size_t i = 0; i < 4; ++i) out.v_[i] = f(i);
    return out;
  }
  std::array<float, 4> v_;
};

#ifdef __SSE2__
/// For processors of Intel's family.
class SseFloats {
 public:
  explicit SseFloats(float all) : v_(_mm_set1_ps(all)) {}
  static SseFloats load(const float* from) { return SseFloats(_mm_load_ps(from)); }

  friend SseFloats operator+(SseFloats a, SseFloats b) { return SseFloats(_mm_add_ps(a.v_, b.v_)); }
  friend SseFloats operator-(SseFloats a, SseFloats b) { return SseFloats(_mm_sub_ps(a.v_, b.v_)); }
  friend SseFloats operator*(SseFloats a, SseFloats b) { return SseFloats(_mm_mul_ps(a.v_, b.v_)); }
  static SseFloats min(SseFloats a, SseFloats b) { return SseFloats(_mm_min_ps(a.v_, b.v_)); }
  static SseFloats max(SseFloats a, SseFloats b) { return SseFloats(_mm_max_ps(a.v_, b.v_)); }
  static SseFloats abs(SseFloats a) { return SseFloats(_mm_andnot_ps(_mm_set1_ps(-0.0F), a.v_)); }
  static unsigned int less(SseFloats a, SseFloats b) {
    return static_cast<unsigned int>(_mm_movemask_ps(_mm_cmplt_ps(a.v_, b.v_)));
  }

 private:
  explicit SseFloats(__m128 v) : v_(v) {}
  __m128 v_;
};
using FourFloats = SseFloats;
#else
using FourFloats = PlainFloats;
#endif

}  // namespace burin::detail
