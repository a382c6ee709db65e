#pragma once
/// What the formats for pen plotters, and for what draws like them, let a user choose.

#include <burin/options/declared.h>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Which pens draw what, for plotters and what works like them.
struct PenOptions {
  /// "auto": layers whose lines are equally wide share a pen; "layers": one each; "one"; or
  /// "outline=1;stroke-*=3;*=2": LAYER=PEN, of which the first that fits counts; pen 0 draws
  /// nothing.
  std::string pens = "auto";
  /// Paper mm: ends that lie no farther apart are drawn as one line.
  double join = 0.02;
  /// Circles and their arcs as such, for a machine that knows them.
  bool arcs = true;

  bool operator==(const PenOptions&) const = default;
};

/// Pens that a plotter may have.
constexpr std::uint32_t kMostPens = 64;

/// What an option that holds commands of a machine takes.
constexpr const char* kCommands = "G-code";

/// Tests the text of pens of a format ("hpgl"). Throws UsageError.
void check_pens(std::string_view format, const PenOptions& options);
/// Tests the text of an option that holds commands. Throws UsageError.
void check_commands(std::string_view format, std::string_view option, const std::string& text);

/// The pen of a layer in a text of `PenOptions::pens` that is a list; nothing where none fits.
std::optional<std::uint32_t> listed_pen(std::string_view pens, std::string_view layer);

/// "pens", "join" and "arcs".
std::vector<OptionRow<PenOptions>> pen_option_rows();

/// The same for a struct that has more.
template <std::derived_from<PenOptions> T>
std::vector<OptionRow<T>> pen_rows() {
  std::vector<OptionRow<T>> rows;
  for (const OptionRow<PenOptions>& row : pen_option_rows()) {
    rows.push_back({row, row.get, row.set});
  }
  return rows;
}

}  // namespace burin
