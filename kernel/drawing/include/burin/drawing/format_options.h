#pragma once
/// What a user chooses of the files that a drawing becomes: of all formats, and of the two that the
/// kernel writes. Writers elsewhere add the options of theirs to the catalogue.

#include <burin/options/declared.h>

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Dashes of hidden lines, in paper mm; for every format.
struct DashOptions {
  double dash = 2.0;
  double gap = 1.0;

  bool operator==(const DashOptions&) const = default;
};

/// Which line of a layer comes after which.
enum class LineOrder {
  Drawing,  // as the drawing has them, part by part
  Travel,   // so that a pen travels little (burin/drawing/pen_order.h); those that meet are joined
};

struct SvgOptions {
  static constexpr std::string_view kRow = "svg";
  static std::vector<OptionRow<SvgOptions>> rows();

  /// Plain polylines of constant width instead of fitted curves and outlined strokes: for plotters
  /// and lasers; for every format that has curves.
  bool flatten = false;
  /// One element per layer and pen, for programs that are slow where there are many, and more only
  /// where one would be too long for Qt; says nothing of sources.
  bool merge = false;
  /// Largest distance in paper mm between a fitted cubic Bezier and the polyline it stands for; for
  /// every format that has curves.
  double fit_tolerance = 0.02;
  DashOptions dashes{};
  /// Travel: there is no group a part.
  LineOrder order = LineOrder::Drawing;
  /// What every id begins with, so that several drawings can stand in one page. Of a file, not of a
  /// style: it has no row.
  std::string id_prefix = {};

  bool operator==(const SvgOptions&) const = default;
};

struct JsonOptions {
  static constexpr std::string_view kRow = "json";
  static std::vector<OptionRow<JsonOptions>> rows();

  /// Model coordinates beside the paper coordinates.
  bool points3 = true;

  bool operator==(const JsonOptions&) const = default;
};

/// Names without a group: "dash", "gap".
std::vector<OptionRow<DashOptions>> dash_option_rows();

/// The words of `LineOrder`, and what the option means.
std::vector<std::string> line_order_words();
std::string line_order_meaning();

/// The options of a format, whether or not this build writes it: keys of styles "png.dpi" and so
/// on.
struct FormatOptions {
  /// The suffix without its dot.
  std::string_view name;
  std::vector<DeclaredOption> options;
  /// Tests texts that are more than text; empty: there are none. Throws UsageError.
  std::function<void(const DeclaredValues&)> check = {};
  /// Options, and what people look for who know them by other names.
  std::map<std::string, std::vector<std::string>> other_names = {};
};

/// Those of the kernel's formats (svg, json), then all that were added, in that order.
std::span<const FormatOptions> format_options();

/// Throws UsageError where the name is that of a format of the kernel.
void add(FormatOptions options);

/// The options of a format from its struct; `T::check(const T&)`, where there is one, tests texts,
/// and `T::other_names()` gives those.
template <Declared T>
FormatOptions options_of() {
  FormatOptions out{T::kRow, declared<T>()};
  if constexpr (requires(const T& options) { T::check(options); }) {
    out.check = [](const DeclaredValues& values) { T::check(values_in<T>(values)); };
  }
  if constexpr (requires { T::other_names(); }) out.other_names = T::other_names();
  return out;
}

}  // namespace burin
