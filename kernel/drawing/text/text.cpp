#include <burin/drawing/text.h>

#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr std::array<double, 16> kPowers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Length of the valid UTF-8 sequence that text begins with, 0 where there is none (overlong forms,
/// surrogates and numbers past U+10FFFF are none).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char b = byte(0);
  const std::size_t n = b < 0x80                ? 1
                        : b >= 0xC2 && b < 0xE0 ? 2
                        : b >= 0xE0 && b < 0xF0 ? 3
                        : b >= 0xF0 && b < 0xF5 ? 4
                                                : 0;
  if (n == 0 || n > text.size()) return 0;
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  if ((b == 0xE0 && byte(1) < 0xA0) || (b == 0xED && byte(1) > 0x9F) ||
      (b == 0xF0 && byte(1) < 0x90) || (b == 0xF4 && byte(1) > 0x8F)) {
    return 0;
  }
  return n;
}

/// Calls `one` for each character (as bytes) of text, the replacement for each broken byte.
template <class F>
void for_each_character(std::string_view text, const F& one) {
  while (!text.empty()) {
    const std::size_t n = utf8_length(text);
    one(n > 0 ? text.substr(0, n) : kReplacement);
    text.remove_prefix(n > 0 ? n : 1);
  }
}

bool is_control(std::string_view c) {
  return c.size() == 1 && static_cast<unsigned char>(c[0]) < 0x20;
}

}  // namespace

void append_scaled(Buffer& out, std::int64_t value, int decimals, bool short_form) {
  std::array<char, 40> digits;
  char* const end = digits.data() + digits.size();
  char* at = end;
  auto rest = static_cast<std::uint64_t>(value < 0 ? -value : value);
  bool any = false;
  for (int i = 0; i < decimals; ++i, rest /= 10) {
    const auto digit = rest % 10;
    if (digit == 0 && !any) continue;
    any = true;
    *--at = static_cast<char>('0' + digit);
  }
  if (any) *--at = '.';
  if (rest > 0 || !any || !short_form) {
    do {
      *--at = static_cast<char>('0' + rest % 10);
      rest /= 10;
    } while (rest > 0);
  }
  if (value < 0) *--at = '-';
  out.append(at, end);
}

void append_fixed(Buffer& out, double value, int decimals) {
  const double scaled = value * kPowers[static_cast<std::size_t>(decimals)];
  // 2^53: beyond it a double has no such decimals to round.
  if (!(std::abs(scaled) < 9007199254740992.0)) return append_exact(out, value);
  append_scaled(out, std::llround(scaled), decimals);
}

void append_exact(Buffer& out, double value) {
  fmt::format_to(fmt::appender(out), "{}", std::isfinite(value) ? value + 0.0 : 0.0);
}

std::u32string code_points(std::string_view text) {
  std::u32string out;
  for_each_character(text, [&](std::string_view c) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(c[i]); };
    char32_t point = c.size() == 1 ? byte(0) : byte(0) & (0x7F >> c.size());
    for (std::size_t i = 1; i < c.size(); ++i) point = point << 6 | (byte(i) & 0x3F);
    out.push_back(point);
  });
  return out;
}

std::string utf8_of(char32_t c) {
  const auto last = [&](int shift) { return static_cast<char>(0x80 | (c >> shift & 0x3F)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xC0 | c >> 6), last(0)};
  if (c < 0x10000) return {static_cast<char>(0xE0 | c >> 12), last(6), last(0)};
  return {static_cast<char>(0xF0 | c >> 18), last(12), last(6), last(0)};
}

void append_json(Buffer& out, std::string_view text) {
  out.push_back('"');
  for_each_character(text, [&](std::string_view c) {
    if (c == "\"" || c == "\\") out.push_back('\\');
    if (is_control(c)) {
      fmt::format_to(fmt::appender(out), "\\u{:04x}", static_cast<unsigned>(c[0]));
    } else {
      append(out, c);
    }
  });
  out.push_back('"');
}

void append_json(Buffer& out, std::span<const std::string> texts) {
  out.push_back('[');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) append(out, ", ");
    append_json(out, texts[i]);
  }
  out.push_back(']');
}

void append_xml(Buffer& out, std::string_view text) {
  for_each_character(text, [&](std::string_view c) {
    if (c == "&") {
      append(out, "&amp;");
    } else if (c == "<") {
      append(out, "&lt;");
    } else if (c == ">") {
      append(out, "&gt;");
    } else if (c == "\"") {
      append(out, "&quot;");
    } else if (is_control(c) || c == "\xEF\xBF\xBE" || c == "\xEF\xBF\xBF") {
      append(out, kReplacement);
    } else {
      append(out, c);
    }
  });
}

}  // namespace burin
