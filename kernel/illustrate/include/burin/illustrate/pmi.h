#pragma once
/// The annotations that parts carry (`Part::pmi`) in a view: lines in space that lie over all else.

#include <burin/options/row.h>

#include <string>
#include <vector>

namespace burin {

struct PmiOptions {
  /// Paper mm of the lines: narrow, after ISO 128-2. Outlines of letters are half as wide.
  double line = 0.18;
  /// "#rrggbb"; empty: the ink of the sheet.
  std::string color = {};
  /// Degrees between the line of sight and the way that an annotation faces up to which it is
  /// drawn. An isometric view sees the planes of the axes at 54.7.
  double angle = 65;
  /// The saved view whose annotations alone are drawn; empty: all.
  std::string view = {};

  bool operator==(const PmiOptions&) const = default;
};

/// "line", "color", "angle", "view".
std::vector<OptionRow<PmiOptions>> pmi_option_rows();

}  // namespace burin
