#include "break_option.h"

#include <burin/base/error.h>
#include <burin/converters/values.h>
#include <burin/options/request.h>

namespace burin::detail {
namespace {

constexpr const char* kTakes =
    "auto, or an axis x, y, z or X,Y,Z, and :FROM..TO in mm with FROM below TO";

[[noreturn]] void refuse(const std::string& spelled, const std::string& text) {
  refuse_value(spelled, kTakes, text);
}

}  // namespace

Vec3 break_axis(const std::string& spelled, const std::string& text) {
  const bool has_sign = text.starts_with('+') || text.starts_with('-');
  const bool is_named = text.find(',') == std::string::npos;
  if ((has_sign && is_named) || text.find('=') != std::string::npos) refuse(spelled, text);
  try {
    return cut_option(spelled, text).axis;
  } catch (const UsageError&) {
    refuse(spelled, text);
  }
}

Break break_option(const std::string& spelled, const std::string& text) {
  Break one;
  if (text == "auto") return one;
  const std::size_t colon = text.find(':');
  try {
    one.axis = break_axis(spelled, text.substr(0, colon));
  } catch (const UsageError&) {
    refuse(spelled, text);
  }
  if (colon == std::string::npos) return one;
  const std::string range = text.substr(colon + 1);
  const std::size_t dots = range.find("..");
  if (dots == std::string::npos) refuse(spelled, text);
  double from[1], to[1];
  const bool are_numbers =
      parse_list(range.substr(0, dots), from) && parse_list(range.substr(dots + 2), to);
  if (!are_numbers || !(from[0] < to[0])) refuse(spelled, text);
  one.stretch = {from[0], to[0]};
  return one;
}

}  // namespace burin::detail
