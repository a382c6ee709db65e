#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/camera/sheet.h>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <string>

namespace burin {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Long and short side in mm.
struct Sheet {
  std::string_view name;
  double longer, shorter;
};
constexpr std::array kSheets{
    // ISO 216.
    Sheet{"a0", 1189, 841}, Sheet{"a1", 841, 594}, Sheet{"a2", 594, 420}, Sheet{"a3", 420, 297},
    Sheet{"a4", 297, 210}, Sheet{"a5", 210, 148}, Sheet{"a6", 148, 105}, Sheet{"b0", 1414, 1000},
    Sheet{"b1", 1000, 707}, Sheet{"b2", 707, 500}, Sheet{"b3", 500, 353}, Sheet{"b4", 353, 250},
    Sheet{"b5", 250, 176}, Sheet{"b6", 176, 125},
    // ANSI Y14.1 and American offices.
    Sheet{"letter", 279.4, 215.9}, Sheet{"legal", 355.6, 215.9}, Sheet{"tabloid", 431.8, 279.4}};

}  // namespace

Paper Paper::named(std::string_view name) {
  const std::string lower = lowered(name);
  for (const Sheet& sheet : kSheets) {
    if (lower == sheet.name) return {sheet.longer, sheet.shorter};
    if (lower == std::string(sheet.name) + "p") return {sheet.shorter, sheet.longer};
  }
  if (const auto x = lower.find('x'); x != std::string::npos) {
    const std::string_view text = lower;
    const auto w = number(text.substr(0, x));
    const auto h = number(text.substr(x + 1));
    const auto sane = [](double s) { return s >= kLeastSheet && s <= kLargestSheet; };
    if (w && h && sane(*w) && sane(*h)) return {*w, *h};
  }
  throw UsageError(fmt::format(
      "unknown paper '{}': use A0..A6, B0..B6, letter, legal, tabloid (A4p is portrait), fit, or "
      "WIDTHxHEIGHT in mm ({} to {})",
      name, kLeastSheet, kLargestSheet));
}

}  // namespace burin
