#include "pen_options.h"

#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace burin {

namespace {

constexpr const char* kPens = "auto, layers, one or LAYER=PEN;...";
/// Lines of G-code that some controllers cut off are longer.
constexpr std::size_t kLongestCommand = 200;

bool is_rule(std::string_view pens) {
  constexpr std::array<std::string_view, 3> kRules{"auto", "layers", "one"};
  return std::ranges::find(kRules, pens) != kRules.end();
}

/// The pairs of a list. Throws UsageError that says what is wrong with one.
std::vector<std::pair<std::string_view, std::uint32_t>> parsed_pens(std::string_view list) {
  std::vector<std::pair<std::string_view, std::uint32_t>> pairs;
  const auto trimmed = [](std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
  };
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(';', at), list.size());
    const std::string_view entry = trimmed(list.substr(at, end - at));
    at = end + 1;
    if (entry.empty()) continue;
    const std::size_t equals = entry.rfind('=');
    if (equals == std::string_view::npos || equals == 0) {
      throw UsageError(fmt::format("'{}' is no LAYER=PEN", entry));
    }
    const std::string_view number = trimmed(entry.substr(equals + 1));
    std::uint32_t pen = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), pen);
    if (read.ec != std::errc{} || read.ptr != number.data() + number.size() || pen > kMostPens) {
      throw UsageError(fmt::format("'{}': pens are numbers from 0 to {}", entry, kMostPens));
    }
    pairs.emplace_back(trimmed(entry.substr(0, equals)), pen);
  }
  if (pairs.empty()) throw UsageError("no pen is named");
  return pairs;
}

}  // namespace

std::vector<OptionRow<PenOptions>> pen_option_rows() {
  return {
      options::text(
          "pens", &PenOptions::pens,
          "which pen draws which layer: auto (layers of equal width and colour share one), layers "
          "(one each), one, or a list such as outline=1;stroke-*=3;*=2 (pen 0 draws "
          "nothing)",
          kPens),
      options::number("join", &PenOptions::join, {0, 1, "mm"},
                      "ends that lie no farther apart are drawn without lifting the pen, in mm"),
      options::flag("arcs", &PenOptions::arcs,
                    "circles and their arcs as such; false = short lines, for machines that know "
                    "no arcs"),
  };
}

std::optional<std::uint32_t> listed_pen(std::string_view pens, std::string_view layer) {
  for (const auto& [name, pen] : parsed_pens(pens)) {
    const bool begins = name.ends_with('*') && layer.starts_with(name.substr(0, name.size() - 1));
    if (begins || name == layer) return pen;
  }
  return std::nullopt;
}

void check_pens(std::string_view format, const PenOptions& options) {
  if (is_rule(options.pens)) return;
  try {
    parsed_pens(options.pens);
  } catch (const UsageError& e) {
    throw UsageError(fmt::format("style key '{}.pens' takes {}, not '{}': {}", format, kPens,
                                 options.pens, e.what()));
  }
}

void check_commands(std::string_view format, std::string_view option, const std::string& text) {
  const bool plain = std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
  if (plain && text.size() <= kLongestCommand) return;
  throw UsageError(fmt::format("style key '{}.{}' takes {}: up to {} printable ASCII characters",
                               format, option, kCommands, kLongestCommand));
}

}  // namespace burin
