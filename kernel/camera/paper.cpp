#include <burin/base/error.h>
#include <burin/camera/paper.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace burin {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Sheets in mm between these sides are real ones; beyond, somebody mistook the unit.
constexpr double kMinSide = 5;
constexpr double kMaxSide = 10000;

}  // namespace

Paper Paper::named(std::string_view name) {
  // ISO 216: the shorter and longer side of A0..A6.
  static constexpr double kSeries[][2] = {{841, 1189}, {594, 841}, {420, 594}, {297, 420},
                                          {210, 297},  {148, 210}, {105, 148}};
  if ((name.size() == 2 || (name.size() == 3 && name[2] == 'p')) &&
      (name[0] == 'A' || name[0] == 'a') && name[1] >= '0' && name[1] <= '6') {
    const auto& side = kSeries[name[1] - '0'];
    return name.size() == 3 ? Paper{side[0], side[1]} : Paper{side[1], side[0]};
  }
  if (name == "letter") return {279.4, 215.9};
  if (name == "letterp") return {215.9, 279.4};
  if (const auto x = name.find('x'); x != std::string_view::npos) {
    const auto w = number(name.substr(0, x));
    const auto h = number(name.substr(x + 1));
    const auto sane = [](double s) { return s >= kMinSide && s <= kMaxSide; };
    if (w && h && sane(*w) && sane(*h)) return {*w, *h};
  }
  throw UsageError(fmt::format(
      "unknown paper '{}': use A0..A6 (A4p is portrait), letter, or WIDTHxHEIGHT in mm ({} to {})",
      name, kMinSide, kMaxSide));
}

}  // namespace burin
