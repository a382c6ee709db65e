#pragma once
/// The sheet that is drawn on.

#include <string_view>

namespace burin {

/// Width and height of the sheet in millimetres.
struct Paper {
  double width = 297;
  double height = 210;

  /// "A0".."A6" (landscape), with a trailing "p" portrait, "letter", or "WxH" in mm.
  /// Throws UsageError, naming what is allowed, for anything else.
  static Paper named(std::string_view name);
};

}  // namespace burin
