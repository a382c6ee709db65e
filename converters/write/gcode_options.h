#pragma once
/// What a user chooses of G-code.

#include "pen_options.h"

#include <string>

namespace burin {

struct GcodeOptions : PenOptions {
  static constexpr std::string_view kRow = "gcode";
  static std::vector<OptionRow<GcodeOptions>> rows();
  /// Throws UsageError.
  static void check(const GcodeOptions& options) {
    check_pens(kRow, options);
    check_commands(kRow, "down", options.down);
    check_commands(kRow, "up", options.up);
    check_commands(kRow, "pen_change", options.pen_change);
  }

  enum class Tool { Pen, Laser };
  Tool tool = Tool::Pen;
  /// mm a minute, drawing and travelling.
  double feed = 1500, travel_feed = 6000;
  /// Of a pen: mm above and below its zero.
  double z_up = 3, z_down = 0;
  /// Of a laser: what S says.
  double power = 1000;
  /// Commands with ; between them; empty: by `tool`.
  std::string down = {}, up = {};
  /// Before a pen that is not the first one; `{pen}` is its number.
  std::string pen_change = "M0";
  /// Where the sheet has its zero.
  enum class Origin { Corner, Middle };
  Origin origin = Origin::Corner;
};

inline std::vector<OptionRow<GcodeOptions>> GcodeOptions::rows() {
  using Options = GcodeOptions;
  using options::number;
  std::vector<OptionRow<Options>> rows = pen_rows<Options>();
  const std::vector<OptionRow<Options>> own = {
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
  rows.insert(rows.end(), own.begin(), own.end());
  return rows;
}

}  // namespace burin
