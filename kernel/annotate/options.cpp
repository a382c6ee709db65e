#include <burin/annotate/options.h>

namespace burin {

using options::flag;
using options::number;

std::vector<OptionRow<CalloutOptions>> callout_option_rows() {
  return {
      number("height", &CalloutOptions::height, {1, 50, "mm"},
             "height of the numbers of callouts, in mm"),
      flag("circle", &CalloutOptions::circle, "a circle about each number; patents have none"),
      options::word("layout", &CalloutOptions::layout, {"columns", "rows", "around"},
                    "where callouts go first: left and right of the drawing, above and below "
                    "it, or on all sides"),
      number("line", &CalloutOptions::line, {0.01, 10, "mm"},
             "width of the leaders and circles of callouts, in mm"),
      number("list_height", &CalloutOptions::list_height, {1, 20, "mm"},
             "height of the letters of a parts list and a legend on the sheet, in mm"),
      options::word("legend", &CalloutOptions::legend,
                    {"bottom-right", "bottom-left", "top-right", "top-left"},
                    "corner of the sheet for the legend of colours"),
  };
}

}  // namespace burin
