#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/camera/sheet.h>
#include <burin/camera/standards.h>

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

constexpr std::array kPapers{
    // ISO 216.
    StandardPaper{"A0", 1189, 841}, StandardPaper{"A1", 841, 594}, StandardPaper{"A2", 594, 420},
    StandardPaper{"A3", 420, 297}, StandardPaper{"A4", 297, 210}, StandardPaper{"A5", 210, 148},
    StandardPaper{"A6", 148, 105}, StandardPaper{"B0", 1414, 1000}, StandardPaper{"B1", 1000, 707},
    StandardPaper{"B2", 707, 500}, StandardPaper{"B3", 500, 353}, StandardPaper{"B4", 353, 250},
    StandardPaper{"B5", 250, 176}, StandardPaper{"B6", 176, 125},
    // ANSI Y14.1 and American offices.
    StandardPaper{"letter", 279.4, 215.9}, StandardPaper{"legal", 355.6, 215.9},
    StandardPaper{"tabloid", 431.8, 279.4}};

}  // namespace

std::span<const StandardPaper> standard_papers() { return kPapers; }

Paper Paper::named(std::string_view name) {
  const std::string lower = lowered(name);
  for (const StandardPaper& sheet : kPapers) {
    const std::string known = lowered(sheet.name);
    if (lower == known) return {sheet.longer, sheet.shorter};
    if (lower == known + "p") return {sheet.shorter, sheet.longer};
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
