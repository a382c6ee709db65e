#pragma once
/// The sheet that is drawn on.

#include <string_view>

namespace burin {

/// Width and height of the sheet in millimetres.
struct Paper {
  double width = 297;
  double height = 210;

  /// "A0".."A6", "B0".."B6", "letter", "legal", "tabloid" (landscape; with a trailing "p"
  /// portrait), or "WxH" in mm; in any case. Throws UsageError, naming what is allowed, for
  /// anything else.
  static Paper named(std::string_view name);

  bool operator==(const Paper&) const = default;
};

}  // namespace burin
