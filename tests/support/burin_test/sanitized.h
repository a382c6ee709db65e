#pragma once
/// Whether a test runs in a build with a sanitizer, which takes memory and addresses of its own: a
/// test that limits or measures memory says nothing there.

// GCC has macros of its own, clang asks for features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BURIN_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define BURIN_SANITIZED 1
#endif
#endif

namespace burin::test {

#ifdef BURIN_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace burin::test
