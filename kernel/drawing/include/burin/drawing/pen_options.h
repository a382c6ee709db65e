#pragma once
/// What a user chooses of files for pen plotters, and for what draws like them.

#include <burin/options/row.h>

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

struct HpglOptions : PenOptions {
  /// cm/s with the pen down; 0: as the plotter is set.
  double speed = 0;

  bool operator==(const HpglOptions&) const = default;
};

struct GcodeOptions : PenOptions {
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

  bool operator==(const GcodeOptions&) const = default;
};

/// Tests the texts; `group` ("hpgl.") goes before their names. Throws UsageError.
void check_texts(const PenOptions& options, const std::string& group);
void check_texts(const GcodeOptions& options, const std::string& group);

/// The pen of a layer in a text of `PenOptions::pens` that is a list; nothing where none fits.
std::optional<std::uint32_t> listed_pen(std::string_view pens, std::string_view layer);

/// Names without a group: "pens", "join"; "speed"; "tool", "feed" ...
std::vector<OptionRow<HpglOptions>> hpgl_option_rows();
std::vector<OptionRow<GcodeOptions>> gcode_option_rows();

}  // namespace burin
