#pragma once
/// A drawing as a file of any format that Burin writes: used by the command line, the Python module
/// and other programs.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/writers.h>
#include <burin/illustrate/style.h>

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

struct WriteOptions;

/// What drawings are written as: one row of the catalogue.
struct Format {
  /// The suffix without its dot.
  std::string_view name;
  /// Keys of a style, or how they begin, that concern this format alone.
  std::vector<std::string> keys;
  std::function<void(const Drawing&, const WriteOptions&, std::ostream&, const RunContext&)> write;
  /// Whether it holds a sheet of that many mm; empty: of any size. Throws UsageError.
  std::function<void(double width, double height, const WriteOptions&)> check_sheet = {};
  /// Whether it shows the items of a drawing, so that they are worth finding.
  bool lists_items = false;
  /// What files of it are called as well, without dots: machines know them by these.
  std::vector<std::string_view> other_suffixes = {};
};

/// All formats; those of plug-ins last.
const std::vector<Format>& formats();
/// Whether a suffix names a format of our own, which no plug-in can have.
bool is_own_format(std::string_view name);
/// The format of a name or suffix in any case ("svg", "SVG", "plt"); null where there is none.
const Format* format_named(std::string_view name);
/// The suffixes without their dots.
std::vector<std::string> format_names();
/// For messages: ".svg, .pdf, .eps, .png, .dxf, .hpgl, .gcode, .json or .html", or with something
/// else before each.
std::string format_list(std::string_view before = ".");

struct HtmlOptions {
  /// Whether the page loads itself anew when `note_drawn` says so.
  bool live = false;
};

/// What the formats leave open.
struct WriteOptions {
  /// Every format that has curves and dashes looks at some of these.
  SvgOptions svg;
  HtmlOptions html;
  /// The options that formats declare, by key of a style ("png.dpi"); those of svg are in `svg`.
  DeclaredValues formats;
  /// Called now and then by the thread that writes, with the share that is done.
  std::function<void(double)> progress;
  /// Called with what the format cannot show of the drawing, in words for the user.
  std::function<void(const Diagnostic&)> report;
};
/// What a style says about files.
WriteOptions write_options(const Style& style);

/// The one format that a key of a style concerns ("png.dpi"); null where it concerns several, or no
/// file.
const Format* only_format_of(std::string_view key);

/// Whether a key of a style says something about files alone, so that it may be changed when the
/// drawing is done: those that `write_options` looks at.
bool is_about_files(std::string_view key);

/// What `write_drawing` tests first, for programs that want to know before a long run: whether the
/// format holds a sheet of that many mm. Throws UsageError, one sentence that says what to do.
void check_sheet(double width, double height, const Format& format, const WriteOptions& options);

/// Writes the drawing, in every format in true millimetres and the same bytes for the same drawing,
/// for any number of threads (the date in a PDF is that of SOURCE_DATE_EPOCH, else there is none).
/// Does not test the stream for errors. Throws Cancelled; UsageError as `check_sheet`; Error where
/// libburin_cairo, which writes PDF and PNG, cannot be loaded.
void write_drawing(const Drawing& drawing, const Format& format, const WriteOptions& options,
                   std::ostream& out, const RunContext& context);

/// Writes a file that appears whole or not at all, in the format of its suffix. Throws UsageError
/// where the suffix names none, OutputError where it cannot be written, and what `write_drawing`
/// does.
void write_file(const Drawing& drawing, const std::filesystem::path& path,
                const WriteOptions& options, const RunContext& context);

}  // namespace burin
