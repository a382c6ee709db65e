#include <burin/base/error.h>
#include <burin/converters/values.h>
#include <burin/drawing/color.h>

#include "draw_options.h"
#include "highlight_option.h"
#include "named_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace burin::detail {
namespace {

constexpr const char* kLook = "The look";

/// Errors of a text that a program made have no line.
Style style_of_text(const std::string& text, const std::string& source) {
  if (!source.empty()) {
    Style style = parse_style(text, source);
    find_named_files(style, std::filesystem::path(source).parent_path());
    return style;
  }
  try {
    Style style = parse_style(text, "style");
    find_named_files(style, {});
    return style;
  } catch (const UsageError& e) {
    const std::string message = e.what();
    const std::size_t place = message.find(": ");
    throw UsageError(place == std::string::npos ? message : message.substr(place + 2));
  }
}

/// Options are no style keys: "view=top".
void refuse_option(const std::string& key, const std::string& set) {
  const Spelling spelling = set.starts_with("--") ? Spelling::Options : Spelling::Keywords;
  for (const RequestOption& option : all_options()) {
    if (option.option.name != key) continue;
    throw UsageError(fmt::format("'{}' is no style key; it is the {}", key, called(key, spelling)));
  }
}

void set_keys(Draft& draft, const Asked& asked) {
  std::vector<std::pair<std::string, std::string>> assignments;
  for (const std::string& assignment : asked.texts) {
    assignments.push_back(parted_assignment(assignment));
    draft.plan.style_keys.push_back(assignments.back().first);
  }
  std::ranges::stable_sort(assignments, {}, [](const auto& a) { return setting_rank(a.first); });
  for (const auto& [key, value] : assignments) {
    refuse_option(key, asked.spelled);
    set_style_key(draft.plan.style, key, value);
  }
  find_named_files(draft.plan.style, {});
}

/// A look changes no key by itself: "lid=line.color=red".
void refuse_key(const Asked& asked, const std::string& text) {
  const std::size_t value = text.rfind('=');
  const std::size_t key =
      value == 0 || value == std::string::npos ? value : text.rfind('=', value - 1);
  if (key == std::string::npos) return;
  const std::string name = text.substr(key + 1, value - key - 1);
  const auto keys = style_keys(builtin_style("technical"));
  if (std::ranges::find(keys, name, &StyleKey::name) == keys.end()) return;
  throw UsageError(fmt::format(
      "{} takes NAME=STYLE, not '{}': write the keys into a style file, such as part.json that "
      "holds {{\"{}\": \"{}\"}}, and then {}={}=part.json",
      asked.spelled, text, name, text.substr(value + 1), asked.spelled, text.substr(0, key)));
}

/// "lid=red" is a highlight, or a style file that says what is red.
void refuse_color(const Asked& asked, const std::string& parts, const std::string& style) {
  if (!rgb_of(without_name(style))) return;
  const Spelling spelling =
      asked.spelled.starts_with("--") ? Spelling::Options : Spelling::Keywords;
  throw UsageError(fmt::format(
      "{0} takes NAME=STYLE, and '{1}' is a colour: {2} {3}={1} draws these parts in it, or write "
      "a style file, such as part.json that holds {{\"fill.color\": \"{1}\"}}, and then {0} "
      "{3}=part.json",
      asked.spelled, style, spelling == Spelling::Options ? "--highlight" : "highlight", parts));
}

void set_looks(Draft& draft, const Asked& asked) {
  for (const std::string& text : asked.texts) {
    refuse_key(asked, text);
    const auto [name, style] = name_and_value(asked.spelled, "NAME=STYLE", text);
    refuse_color(asked, name, style);
    draft.looks.push_back(
        {.look = {.select = {name}, .asked = fmt::format("{} '{}'", asked.spelled, text)},
         .style = style});
  }
}

std::vector<std::string> style_names() {
  std::vector<std::string> names;
  for (const StyleInfo& style : builtin_styles()) names.push_back(style.name);
  return names;
}

/// Adds a look of the parts that each text names.
void add_looks(Draft& draft, const Asked& asked, Look look) {
  for (const std::string& selector : asked.texts) {
    look.select = {selector};
    draft.looks.push_back({.look = look});
  }
}

}  // namespace

std::vector<RequestRow<Draft>> look_option_rows() {
  return {
      {{.option = {.name = "style",
                   .meaning = fmt::format("{}, or a style file (default technical)",
                                          fmt::join(style_names(), ", ")),
                   .takes = FreeText{}},
        .group = kLook,
        .label = "NAME|FILE",
        .fallback = "technical",
        .choices = style_names(),
        .python = "str | PathLike[str] | Mapping[str, Any]",
        .also = {"theme", "preset", "mode", "render style", "shading", "technique", "template"}},
       [](Draft& d, const Asked& a) {
         d.named = d.style_text.empty() ? load_with_text(a.text())
                                        : LoadedStyle{style_of_text(d.style_text, d.style_source),
                                                      d.style_text, d.style_source};
         d.plan.style = d.named.style;
       }},
      {{.option = {.name = "light",
                   .meaning = "direction to the light: right, up, towards the viewer (default: "
                              "upper left front)",
                   .takes = Direction{},
                   .phrase = kDirectionPhrase},
        .group = kLook,
        .label = "X,Y,Z",
        .also = {"sun", "lamp", "light direction", "lighting", "illumination"}},
       [](Draft& d, const Asked& a) {
         for_each_tone(d.plan.style,
                       [&](tone::ToneOptions& t) { t.light = std::get<Vec3>(a.value); });
       }},
      {{.option = {.name = "set",
                   .meaning = "change one key of the style; repeatable; see burin styles --keys",
                   .takes = FreeText{}},
        .group = kLook,
        .label = "KEY=VALUE",
        .many = true,
        .python = "Mapping[str, Any]",
        .also = {"key", "config", "option", "param style", "define style"}},
       set_keys},
      {{.option = {.name = "hidden",
                   .meaning = "leave hidden lines out or draw them dashed (default none)",
                   .takes = WordList{{"none", "dashed"}}},
        .group = kLook,
        .label = "none|dashed",
        .fallback = "none",
        .also = {"hidden lines", "hidden line", "hlr", "show hidden", "dashed", "dash",
                 "dashed lines", "invisible", "no hidden", "remove hidden", "occluded"}},
       [](Draft& d, const Asked& a) {
         d.plan.illustrate.hidden =
             std::get<std::uint64_t>(a.value) == 0 ? HiddenLines::None : HiddenLines::Dashed;
       }},
      {{.option = {.name = "centre_lines",
                   .meaning = "draw the axes of round faces and marks where these are seen along "
                              "their axis: auto, or none (default: as the style has it)",
                   .takes = WordList{{"none", "auto"}}},
        .group = kLook,
        .label = "none|auto",
        .also = {"center lines", "centreline", "centerline", "centre marks", "center marks", "axes",
                 "axis", "axis lines"}},
       [](Draft& d, const Asked& a) {
         d.plan.style.feature.centre_lines = std::get<std::uint64_t>(a.value) == 1;
       }},
      {{.option = {.name = "tolerance",
                   .meaning =
                       "chord tolerance of any tessellation, in model mm (default: less than "
                       "0.05 mm on the sheet)",
                   .takes = NumberRange{1 / kLarge, kLarge, "mm"},
                   .phrase = "a number of mm from 1e-12 to 1e12"},
        .group = kLook,
        .label = "MM",
        .also = {"deflection", "linear deflection", "chord", "chordal tolerance", "accuracy",
                 "precision", "quality", "detail level", "lod", "mesh quality", "facets",
                 "fineness"}},
       [](Draft& d, const Asked& a) { d.plan.illustrate.tolerance = std::get<double>(a.value); }},
  };
}

std::vector<RequestRow<Draft>> part_option_rows() {
  constexpr const char* kPython = "str | Sequence[str]";
  return {
      {{.option = {.name = "part",
                   .meaning = "draw only the parts of this name or path (* and ? are wild); "
                              "repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "NAME",
        .many = true,
        .python = kPython,
        .also = {"only", "select", "include", "isolate", "component", "object name", "body", "show",
                 "filter", "solid"}},
       [](Draft& d, const Asked& a) { d.plan.only = a.texts; }},
      {{.option = {.name = "hide",
                   .meaning = "leave these parts out; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "NAME",
        .many = true,
        .python = kPython,
        .also = {"exclude", "without", "omit", "skip", "remove", "hidden parts",
                 "invisible parts"}},
       [](Draft& d, const Asked& a) { add_looks(d, a, {.drawn = false}); }},
      {{.option = {.name = "ghost",
                   .meaning =
                       "draw only the lines of these parts, and what is behind them; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "NAME",
        .many = true,
        .python = kPython,
        .also = {"transparent", "transparency", "opacity", "alpha", "glass", "xray", "x ray",
                 "see through", "translucent"}},
       [](Draft& d, const Asked& a) { add_looks(d, a, {.hatched = false, .transparent = true}); }},
      {{.option = {.name = "highlight",
                   .meaning = "these parts in colour (default orange), all others pale grey with "
                              "thin lines; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "NAME[=COLOUR]",
        .many = true,
        .python = "Mapping[str, str] | Sequence[str] | str",
        .also = {"emphasis", "emphasize", "accent", "spotlight", "mark part", "red part", "focus"}},
       set_highlights},
      {{.option = {.name = "look",
                   .meaning = "draw these parts in another style, a name or a file; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "NAME=STYLE",
        .many = true,
        .python = "Mapping[str, str] | Sequence[str]",
        .also = {"part style", "style of", "appearance", "override", "material"}},
       set_looks},
  };
}

}  // namespace burin::detail
