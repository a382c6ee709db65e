#pragma once
/// What a user chooses of callouts and of the parts list on the sheet.

#include <burin/options/row.h>

#include <vector>

namespace burin {

/// A corner of the sheet within its margin.
enum class Corner { BottomRight, BottomLeft, TopRight, TopLeft };

struct CalloutOptions {
  /// Paper mm, of the numbers; those of patents have at least 3.2.
  double height = 5;
  /// A circle about each number; patents have none.
  bool circle = true;
  enum class Layout {
    Columns,  // left and right, then above and below
    Rows,     // above and below, then left and right
    Around,   // on all sides alike
  };
  Layout layout = Layout::Columns;
  /// Paper mm, of leaders and circles: narrow, after ISO 128.
  double line = 0.18;
  /// Paper mm of letters in the parts list and in the legend.
  double list_height = 2.5;
  /// The corner in which the legend stands.
  Corner legend = Corner::BottomRight;

  bool operator==(const CalloutOptions&) const = default;
};

/// "height", "circle", "layout", "line", "list_height", "legend".
std::vector<OptionRow<CalloutOptions>> callout_option_rows();

}  // namespace burin
