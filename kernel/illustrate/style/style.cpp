#include <burin/base/error.h>
#include <burin/drawing/color.h>
#include <burin/illustrate/style.h>
#include <burin/options/meant.h>

#include "style_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {

std::size_t stroke_kind_count(const Style& style) { return 1 + style.strokes.size(); }

const HatchStyle& hatch_of(const Style& style, std::size_t number) {
  return number == 1 ? style.hatch : style.strokes.at(number - 2).hatch;
}

const tone::ToneOptions& tone_of(const Style& style, std::size_t number) {
  return number == 1 ? style.tone : style.strokes.at(number - 2).tone;
}

bool has_strokes(const Style& style) {
  return style.hatch.enabled || std::any_of(style.strokes.begin(), style.strokes.end(),
                                            [](const StrokeKind& k) { return k.hatch.enabled; });
}

namespace detail {

StrokeKind next_kind(const Style& style) {
  if (stroke_kind_count(style) >= kMostStrokeKinds) {
    throw UsageError(fmt::format("a style has at most {} kinds of strokes", kMostStrokeKinds));
  }
  StrokeKind kind{style.hatch, style.tone};
  kind.hatch.enabled = true;
  kind.hatch.select = HatchStyle().select;
  kind.hatch.share = HatchStyle().share;
  return kind;
}

}  // namespace detail

namespace {

template <class S>
void set_row(const OptionRow<S>& row, const std::string& name, std::string_view text, S& to) {
  const auto value = parse_value(row, text);
  if (!value) {
    throw UsageError(fmt::format("style key '{}' takes {}, not '{}'", name, takes_text(row), text));
  }
  row.set(to, *value);
}

// The kind whose number is one more than that of the last is made.
void set_kind_key(Style& style, const detail::KindKey& key, std::string_view text) {
  StrokeKind kind = key.number == 1                          ? StrokeKind{style.hatch, style.tone}
                    : key.number <= stroke_kind_count(style) ? style.strokes[key.number - 2]
                                                             : detail::next_kind(style);
  if (key.number > stroke_kind_count(style) + 1) {
    throw UsageError(
        fmt::format("style key 'strokes.{}.{}': the style has {} kinds of strokes; "
                    "the next is number {}",
                    key.number, key.name, stroke_kind_count(style), stroke_kind_count(style) + 1));
  }
  if (key.name == "kind") {
    detail::become(text, kind);
  } else {
    set_row(detail::find_kind_row(key.name, key.number),
            fmt::format("strokes.{}.{}", key.number, key.name), text, kind);
  }
  if (key.number == 1) {
    style.hatch = std::move(kind.hatch);
    style.tone = std::move(kind.tone);
  } else if (key.number <= stroke_kind_count(style)) {
    style.strokes[key.number - 2] = std::move(kind);
  } else {
    style.strokes.push_back(std::move(kind));
  }
}

}  // namespace

void set_style_key(Style& style, std::string_view key, std::string_view text) {
  if (const auto kind = detail::kind_key(key)) return set_kind_key(style, *kind, text);
  const detail::StyleRow& row = detail::find_row(key);
  set_row(row, row.name, text, style);
}

int setting_rank(std::string_view key) {
  if (!key.starts_with("strokes.")) return 0;
  return key.ends_with(".kind") ? 1 : 2;
}

namespace {

std::optional<std::string> first_fault(const Style& style) {
  const std::vector<detail::StyleRow> rows = detail::all_rows_of(style);
  return options::first_fault(std::vector<OptionRow<Style>>(rows.begin(), rows.end()), style);
}

/// What a colour may be, and the nearest to what it is: names of colours, and `words` that the key
/// takes beside them.
[[noreturn]] void refuse_color(const std::string& key, const std::string& color,
                               std::string_view others,
                               const std::vector<std::string>& words = {}) {
  std::vector<KnownWord> known;
  for (const std::string& word : words) known.push_back({word});
  for (const std::string& name : color_names()) known.push_back({name});
  const std::string alpha = hint_of_alpha(color);
  throw UsageError(fmt::format("style key '{}' takes a colour #rrggbb, {}{}, not '{}'{}", key,
                               said_color_names(), others, color,
                               alpha.empty() ? hint(color, known) : alpha));
}

/// `nothing`: how the error names it that there may be none; empty: there must be a colour.
void check_color(const std::string& key, const std::string& color,
                 std::string_view nothing = " or nothing") {
  if (rgb_of(color) || (!nothing.empty() && color.empty())) return;
  refuse_color(key, color, nothing);
}

}  // namespace

void check_style(const Style& style) {
  if (stroke_kind_count(style) > kMostStrokeKinds) {
    throw UsageError(fmt::format("a style has at most {} kinds of strokes", kMostStrokeKinds));
  }
  const auto fault = first_fault(style);
  if (fault) throw UsageError("style key " + *fault);
  check_color("sheet.ink", style.sheet.ink, "");
  check_color("sheet.paper", style.sheet.paper, "");
  check_color("line.color", style.line.color);
  check_color("shadow.color", style.shadow.color);
  if (style.fill.color != "part" && style.fill.color != "none" && !rgb_of(style.fill.color)) {
    refuse_color("fill.color", style.fill.color, ", part or none", {"part", "none"});
  }
  if (const std::string wrong = fault_of_ink(style.fill.ink);
      !style.fill.ink.empty() && !wrong.empty()) {
    throw UsageError("style key 'fill.ink' " + wrong);
  }
  if (style.fill.hatch.color != "fill") {
    check_color("fill.hatch_color", style.fill.hatch.color, ", fill or nothing");
  }
  for (const FormatOptions& format : format_options()) {
    if (format.check) format.check(style.formats);
  }
  for (std::size_t number = 1; number <= stroke_kind_count(style); ++number) {
    check_color(detail::kind_group(number) + "color", hatch_of(style, number).color);
    check_texts(hatch_of(style, number), detail::kind_group(number));
    field::check_texts(hatch_of(style, number).field, detail::kind_group(number));
  }
}

std::vector<StyleKey> style_keys(const Style& style) {
  std::vector<StyleKey> keys;
  for (const detail::StyleRow& row : detail::all_rows_of(style)) {
    keys.push_back(
        {row, value_text(row, row.get(style)), row.of_whole, detail::other_names_of(row.name)});
  }
  return keys;
}

std::vector<std::string> keys_without_effect(const Style& style, const Style& whole) {
  const Style plain;
  std::vector<std::string> keys;
  for (const detail::StyleRow& row : detail::style_rows()) {
    const OptionValue value = row.get(style);
    if (row.of_whole && value != row.get(whole) && value != row.get(plain)) {
      keys.push_back(row.name);
    }
  }
  return keys;
}

}  // namespace burin
