#include <burin/base/error.h>
#include <burin/drawing/pen_options.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace burin {

using options::number;

namespace {

constexpr const char* kPens = "auto, layers, one or LAYER=PEN;...";
constexpr const char* kCommands = "G-code";
/// Lines of G-code that some controllers cut off are longer.
constexpr std::size_t kLongestCommand = 200;

template <class T>
std::vector<OptionRow<T>> pen_rows() {
  std::vector<OptionRow<PenOptions>> rows = {
      options::text(
          "pens", &PenOptions::pens,
          "which pen draws which layer: auto (layers of equal width and colour share one), layers "
          "(one each), one, or a list such as outline=1;stroke-*=3;*=2 (pen 0 draws "
          "nothing)",
          kPens),
      number("join", &PenOptions::join, {0, 1, "mm"},
             "ends that lie no farther apart are drawn without lifting the pen, in mm"),
      options::flag("arcs", &PenOptions::arcs,
                    "circles and their arcs as such; false = short lines, for machines that know "
                    "no arcs"),
  };
  std::vector<OptionRow<T>> out;
  for (const OptionRow<PenOptions>& row : rows) out.push_back({row, row.get, row.set});
  return out;
}

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

std::vector<OptionRow<HpglOptions>> hpgl_option_rows() {
  std::vector<OptionRow<HpglOptions>> rows = pen_rows<HpglOptions>();
  rows.push_back(number("speed", &HpglOptions::speed, {0, 200, "cm/s"},
                        "of the pen on the paper, in cm/s; 0 = as the plotter is set"));
  return rows;
}

std::vector<OptionRow<GcodeOptions>> gcode_option_rows() {
  using Options = GcodeOptions;
  std::vector<OptionRow<Options>> rows = {
      options::word("tool", &Options::tool, {"pen", "laser"},
                    "what draws: a pen that Z moves, or a laser that M3 and M5 switch"),
      number("feed", &Options::feed, {1, 100'000, "mm/min"}, "speed of drawing, in mm a minute"),
      number("travel_feed", &Options::travel_feed, {1, 100'000, "mm/min"},
             "speed of travelling, in mm a minute"),
      number("z_up", &Options::z_up, {-1000, 1000, "mm"}, "Z of a pen that travels, in mm"),
      number("z_down", &Options::z_down, {-1000, 1000, "mm"}, "Z of a pen that draws, in mm"),
      number("power", &Options::power, {0, 100'000}, "S of a laser that is on"),
      options::text("down", &Options::down,
                    "commands that put the pen down, with ; between them; empty = by gcode.tool",
                    kCommands),
      options::text("up", &Options::up,
                    "commands that lift the pen, with ; between them; empty = by gcode.tool",
                    kCommands),
      options::text("pen_change", &Options::pen_change,
                    "commands before every pen but the first; {pen} is its number", kCommands),
      options::word("origin", &Options::origin, {"corner", "middle"},
                    "where the sheet has its zero: lower left, or in the middle"),
  };
  std::vector<OptionRow<Options>> pens = pen_rows<Options>();
  pens.insert(pens.end(), rows.begin(), rows.end());
  return pens;
}

std::optional<std::uint32_t> listed_pen(std::string_view pens, std::string_view layer) {
  for (const auto& [name, pen] : parsed_pens(pens)) {
    const bool begins = name.ends_with('*') && layer.starts_with(name.substr(0, name.size() - 1));
    if (begins || name == layer) return pen;
  }
  return std::nullopt;
}

void check_texts(const PenOptions& options, const std::string& group) {
  if (is_rule(options.pens)) return;
  try {
    parsed_pens(options.pens);
  } catch (const UsageError& e) {
    throw UsageError(fmt::format("style key '{}pens' takes {}, not '{}': {}", group, kPens,
                                 options.pens, e.what()));
  }
}

void check_texts(const GcodeOptions& options, const std::string& group) {
  check_texts(static_cast<const PenOptions&>(options), group);
  const auto check = [&](const char* name, const std::string& text) {
    const bool plain = std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
    if (plain && text.size() <= kLongestCommand) return;
    throw UsageError(fmt::format("style key '{}{}' takes {}: up to {} printable ASCII characters",
                                 group, name, kCommands, kLongestCommand));
  };
  check("down", options.down);
  check("up", options.up);
  check("pen_change", options.pen_change);
}

}  // namespace burin
