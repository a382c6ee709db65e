#include "highlight_option.h"

#include <burin/base/error.h>
#include <burin/converters/values.h>
#include <burin/drawing/color.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace burin::detail {
namespace {

using UnorderedJson = nlohmann::json;

constexpr const char* kHighlight = "orange";

/// The colour of the paper with a share of ink.
std::string pale(const Style& whole, double share) {
  const Rgb white{255, 255, 255};
  return to_text(over(rgb_of(whole.sheet.ink).value_or(Rgb{}), share,
                      rgb_of(whole.sheet.paper).value_or(white)));
}

/// The look of all parts but the highlighted ones: thin grey lines, no strokes, hardly any shade;
/// on white paper pale grey. Hatching over their colours is as grey, in the tones that have it.
std::string in_background(const Style& whole) {
  constexpr double kFill = 11 / 255.0, kLine = 115 / 255.0;
  UnorderedJson look = {{"line.color", pale(whole, kLine)},
                        {"line.outer", 0.25},
                        {"line.contour", 0.15},
                        {"line.crease", 0.12},
                        {"line.boundary", 0.15},
                        {"line.smooth", 0.09},
                        {"line.intersection", 0.12},
                        {"fill.color", pale(whole, kFill)},
                        {"fill.ink", ""},
                        {"fill.legend", false},
                        {"tone.darkest", 0.92}};
  if (whole.fill.hatch.lines == FillHatch::Lines::None) {
    look["tone.steps"] = "none";
  } else {
    look["fill.hatch_color"] = "";
  }
  return look.dump();
}

/// The look of parts in a colour as it is called; empty: none is. A style that prints in a spot ink
/// has that one for them then, more of it than elsewhere. Another colour is an ink of its own, but
/// for greys: those are black. Lines are seen on all tones of a colour. The contour has one width
/// all round: wider against the paper, the bit of a part that stands out beyond pale ones is a
/// blot.
std::string highlighted(const Style& whole, const std::string& called) {
  constexpr double kLeastTint = 0.6;
  const FillOptions& fill = whole.fill;
  const bool has_ink = !fill.ink.empty();
  const bool own_ink = called.empty() && has_ink && rgb_of(fill.color);
  const std::string color =
      own_ink ? fill.color : without_name(called.empty() ? kHighlight : called);
  const Rgb rgb = rgb_of(color).value_or(Rgb{});
  UnorderedJson look = {{"fill.color", color}, {"line.outer", whole.line.contour}};
  std::string ink = fill.ink;
  if (!called.empty()) ink = has_ink && !is_grey(rgb) ? "Highlight " + called : "";
  look["fill.ink"] = ink;
  if (!ink.empty()) {
    look["fill.tint"] = std::max(fill.tint, kLeastTint);
  } else {
    const std::string& lines = whole.line.color.empty() ? whole.sheet.ink : whole.line.color;
    look["tone.darkest"] = readable_darkest({rgb, fill.darkest}, rgb_of(lines).value_or(Rgb{}));
  }
  return look.dump();
}

}  // namespace

// A selector may have an equals sign itself: @color=#ff0000.
void set_highlights(Draft& draft, const Asked& asked) {
  const Style& whole = draft.plan.style;
  draft.looks.push_back({.look = {.select = {"*"}, .hatched = false},
                         .style_text = in_background(whole),
                         .style_source = "highlight",
                         .is_made = true});
  for (const std::string& text : asked.texts) {
    const std::size_t equals = text.rfind('=');
    if (const std::string alpha = hint_of_alpha(text.substr(equals + 1));
        equals != std::string::npos && !text.starts_with('@') && !alpha.empty()) {
      throw UsageError(fmt::format("{} takes NAME=COLOUR, not '{}'{} in a style file, as of {}",
                                   asked.spelled, text, alpha,
                                   asked.spelled.starts_with("--") ? "--look" : "look"));
    }
    const bool is_selector =
        equals == std::string::npos || (text.starts_with('@') && text.find('=') == equals);
    const std::string called = is_selector ? std::string() : text.substr(equals + 1);
    if ((!is_selector && !rgb_of(without_name(called))) || equals == 0) {
      refuse_value(asked.spelled,
                   fmt::format("NAME or NAME=COLOUR, a colour #rrggbb, {}", said_color_names()),
                   text);
    }
    draft.looks.push_back({.look = {.select = {is_selector ? text : text.substr(0, equals)},
                                    .hatched = true,
                                    .highlight = true,
                                    .asked = fmt::format("{} '{}'", asked.spelled, text)},
                           .style_text = highlighted(whole, called),
                           .style_source = "highlight",
                           .is_made = true});
  }
}

}  // namespace burin::detail
