#pragma once
/// A drawing as a file of any format that Burin writes: the one door of the command line, the
/// Python module and whoever else has a drawing in hand.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/writers.h>
#include <burin/illustrate/style.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

enum class Format { Svg, Json };

/// The format of a suffix or name in any case ("svg", "SVG"); nothing where there is none.
std::optional<Format> format_named(std::string_view name);
/// The suffixes without their dots.
std::vector<std::string> format_names();
/// For messages: ".svg or .json".
std::string format_list();

/// What the formats leave open.
struct WriteOptions {
  SvgOptions svg;
  JsonOptions json;
};
/// What a style says about files.
WriteOptions write_options(const Style& style);

/// Writes the drawing. Does not test the stream for errors. Throws Cancelled.
void write_drawing(const Drawing& drawing, Format format, const WriteOptions& options,
                   std::ostream& out, const RunContext& context);

}  // namespace burin
