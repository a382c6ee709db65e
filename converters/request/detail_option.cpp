#include "detail_option.h"

#include <burin/base/error.h>
#include <burin/converters/values.h>

#include "draw_options.h"

#include <algorithm>

namespace burin::detail {

DetailView detail_option(const std::string& spelled, const std::string& text) {
  DetailView detail;
  std::string what = text;
  // Selectors may have the sign: @color=#ff0000.
  const std::size_t equals = text.rfind('=');
  const bool attribute = text.front() == '@' && text.find('=') == equals;  // @index=2
  if (equals != std::string::npos && equals > 0 && !attribute) {
    try {
      detail.scale = scale_option(spelled, text.substr(equals + 1), 1 / kLarge, kLarge);
    } catch (const UsageError&) {
      detail.scale.reset();
    }
    if (detail.scale) what = text.substr(0, equals);
  }
  if (std::ranges::count(what, ',') == 3) {
    const std::size_t last = what.rfind(',');
    try {
      const auto at = point_option(spelled, what.substr(0, last));
      const auto radius = scale_option(spelled, what.substr(last + 1), 1 / kLarge, kLarge);
      if (at && radius) {
        detail.at = *at;
        detail.radius = *radius;
        return detail;
      }
    } catch (const UsageError&) {
      // A name with commas.
    }
    double numbers[4];
    if (parse_list(what, numbers)) refuse_value(spelled, "X,Y,Z,R with a radius R over 0", text);
  }
  if (what.empty()) refuse_value(spelled, "NAME or X,Y,Z,R, and =A:B behind it", text);
  detail.select = {what};
  return detail;
}

}  // namespace burin::detail
