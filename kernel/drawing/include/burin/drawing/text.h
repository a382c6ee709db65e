#pragma once
/// Text of fixed form: the same number gives the same bytes everywhere.

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace burin {

using Buffer = fmt::memory_buffer;

inline void append(Buffer& out, std::string_view text) {
  out.append(text.data(), text.data() + text.size());
}

/// `value` / 10^decimals without trailing zeros, "-0" or an exponent; with `short_form` without the
/// zero before the point.
void append_scaled(Buffer& out, std::int64_t value, int decimals, bool short_form = false);

/// A finite number rounded to `decimals` (at most 15) places. Numbers too large for that get their
/// shortest exact form.
void append_fixed(Buffer& out, double value, int decimals);

/// The shortest text that reads back as the same number; "0" where it is not finite.
void append_exact(Buffer& out, double value);

/// The characters of UTF-8; broken bytes become U+FFFD.
std::u32string code_points(std::string_view text);
/// One character as UTF-8.
std::string utf8_of(char32_t character);

/// A quoted JSON string. Bytes that are no UTF-8 become U+FFFD.
void append_json(Buffer& out, std::string_view text);
/// A list of them.
void append_json(Buffer& out, std::span<const std::string> texts);

/// Text or attribute value of XML; what XML cannot hold becomes U+FFFD.
void append_xml(Buffer& out, std::string_view text);

}  // namespace burin
