#pragma once
// Whether a processor takes numbers that are nearly zero as zero; internal to the module.

#include <cstdint>

#ifdef __SSE2__
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace burin::detail {

/// Embree asks for it; the mode belongs to the thread and goes back to what it was. On processors
/// that are neither of Intel's family nor 64-bit ARM it stays as it is, which is slower alone.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(mode()) { set(flushed(saved_)); }
  ~FlushDenormals() { set(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE2__)
  using Mode = unsigned int;
  static Mode mode() { return _mm_getcsr(); }
  static void set(Mode mode) { _mm_setcsr(mode); }
  static Mode flushed(Mode mode) { return mode | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON; }
#elif defined(__aarch64__)
  using Mode = std::uint64_t;
  static Mode mode() {
    Mode mode = 0;
    asm volatile("mrs %0, fpcr" : "=r"(mode));
    return mode;
  }
  static void set(Mode mode) { asm volatile("msr fpcr, %0" : : "r"(mode)); }
  static Mode flushed(Mode mode) { return mode | (Mode{1} << 24); }  // FZ
#else
  using Mode = unsigned int;
  static Mode mode() { return 0; }
  static void set(Mode /*mode*/) {}
  static Mode flushed(Mode mode) { return mode; }
#endif

  Mode saved_;
};

}  // namespace burin::detail
