#pragma once
/// What a user chooses of HPGL.

#include "pen_options.h"

namespace burin {

struct HpglOptions : PenOptions {
  static constexpr std::string_view kRow = "hpgl";
  static std::vector<OptionRow<HpglOptions>> rows() {
    std::vector<OptionRow<HpglOptions>> rows = pen_rows<HpglOptions>();
    rows.push_back(options::number("speed", &HpglOptions::speed, {0, 200, "cm/s"},
                                   "of the pen on the paper, in cm/s; 0 = as the plotter is set"));
    return rows;
  }
  /// Throws UsageError.
  static void check(const HpglOptions& options) { check_pens(kRow, options); }

  /// cm/s with the pen down; 0: as the plotter is set.
  double speed = 0;
};

}  // namespace burin
