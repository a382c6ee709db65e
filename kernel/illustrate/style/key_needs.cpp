#include "key_needs.h"

#include <burin/field/catalogue.h>
#include <burin/tone/catalogue.h>

#include "../hatch_parts.h"

#include <algorithm>

namespace burin::detail {
namespace {

bool colored(const KeyPlace& p) { return p.part.fill.color != "none"; }
bool hatched(const KeyPlace& p) {
  return p.part.fill.hatch.lines != FillHatch::Lines::None && !p.transparent;
}
bool lines_in_fill(const KeyPlace& p) { return hatched(p) && p.part.fill.hatch.color == "fill"; }
bool seen(const KeyPlace& p) { return p.part.fill.opacity > 0; }
bool painted(const KeyPlace& p) { return colored(p) && seen(p); }
bool toned(const KeyPlace& p) { return p.part.fill.steps > 1 || p.whole.shadow.cast; }
bool stroked(const KeyPlace& p) {
  // Kinds after the first begin as that is.
  return p.kind == 1 ? has_strokes(p.part) : hatch_of(p.part, p.kind).enabled;
}
bool ground_shadow(const KeyPlace& p) { return p.whole.shadow.ground && p.around.ground_seen; }
const tone::ToneOptions& tone_of(const KeyPlace& p) { return burin::tone_of(p.part, p.kind); }

bool lit_without_strokes(const KeyPlace& p) {
  const bool areas = painted(p) || hatched(p);
  return (p.part.fill.steps > 1 && areas && !p.transparent) || p.part.feature.isophotes > 0 ||
         p.whole.shadow.cast || ground_shadow(p);
}
bool strokes_look_at_light(const KeyPlace& p) {
  for (std::size_t k = 1; k <= stroke_kind_count(p.part); ++k) {
    if (tone::find(burin::tone_of(p.part, k).law).uses_light ||
        field::find(hatch_of(p.part, k).field.name).uses_light)
      return true;
  }
  return false;
}

template <std::size_t n>
struct Name {
  // NOLINTNEXTLINE(google-explicit-constructor): a text as a template argument
  constexpr Name(const char (&text)[n]) { std::copy_n(text, n, value); }
  char value[n];
};
template <Name option>
bool law_uses(const KeyPlace& p) {
  return std::ranges::count(tone::find(tone_of(p).law).looks_at, std::string_view(option.value)) >
         0;
}

constexpr KeyNeed kColored{colored,
                           ": style '{style}' gives parts no colour (fill.color=part does)"};
constexpr KeyNeed kAreas{
    [](const KeyPlace& p) { return colored(p) || hatched(p); },
    ": style '{style}' gives parts no colour and no hatching (fill.color=part or fill.hatch=lines "
    "does)"};
constexpr KeyNeed kSeen{[](const KeyPlace& p) { return seen(p) || lines_in_fill(p); },
                        ": fill.opacity is 0"};
constexpr KeyNeed kSeenAreas{[](const KeyPlace& p) { return painted(p) || hatched(p); },
                             ": fill.opacity is 0"};
constexpr KeyNeed kInk{[](const KeyPlace& p) { return !p.part.fill.ink.empty(); },
                       ": it is for a spot ink, and fill.ink names none"};
constexpr KeyNeed kNoInk{[](const KeyPlace& p) { return p.part.fill.ink.empty(); },
                         ": tones of the spot ink '{ink}' are tints of it (fill.tint)"};
constexpr KeyNeed kSolid{
    [](const KeyPlace& p) { return !p.transparent; },
    ": parts of glass (`ghost`) have no tones, shadows, hatching and areas of faces"};
constexpr KeyNeed kHatched{hatched, ": fill.hatch is none (fill.hatch=lines hatches areas)"};
constexpr KeyNeed kToned{toned, ": there is one tone alone (tone.steps=2 or more gives others)"};
constexpr KeyNeed kPartColor{
    [](const KeyPlace& p) { return p.part.fill.hatch.color != "fill" || colored(p); },
    ": lines have the colour of their part, which fill.color=none takes from it (fill.color=part "
    "and fill.opacity=0 colour the lines alone)"};
constexpr KeyNeed kUnlikeArea{
    [](const KeyPlace& p) {
      return !lines_in_fill(p) || !colored(p) || p.part.fill.opacity < 1 || toned(p) ||
             !p.part.fill.ink.empty();
    },
    ": lines in the colour of their area are not seen on it (fill.opacity=0 leaves the lines "
    "alone; tone.steps=2 makes areas darker in the shade)"};
constexpr KeyNeed kLegend{[](const KeyPlace& p) { return p.around.legend; }, " without `legend`"};
constexpr KeyNeed kGround{
    [](const KeyPlace& p) { return p.around.ground_seen; },
    ": the ground under the parts has no shadow that this `view` shows: it is seen from above, in "
    "a light from above"};
constexpr KeyNeed kShadow{
    [](const KeyPlace& p) { return p.whole.shadow.ground || p.whole.shadow.cast; },
    ": no shadow is asked for (shadow.ground=true)"};
constexpr KeyNeed kSeenShadow{
    [](const KeyPlace& p) { return p.whole.shadow.cast || ground_shadow(p); },
    ": no shadow is asked for that this `view` shows (shadow.cast=true; shadow.ground=true, seen "
    "from above)"};
constexpr KeyNeed kShadowOfOwnColor{
    [](const KeyPlace& p) { return ground_shadow(p) || (p.whole.shadow.cast && !painted(p)); },
    ": it is for shadows on the ground (shadow.ground=true, seen from above) and on parts without "
    "a colour; on others they have the darkest tone (tone.darkest)"};

constexpr KeyNeed kCentreLines{
    [](const KeyPlace& p) { return p.part.feature.centre_lines; },
    ": style '{style}' draws no centre lines (feature.centre_lines=true does)"};
constexpr KeyNeed kThreads{[](const KeyPlace& p) { return p.part.feature.threads; },
                           ": style '{style}' draws no threads (feature.threads=true does)"};
constexpr KeyNeed kStrokes{stroked, ": style '{style}' draws no strokes (hatch.enabled=true does)"};
constexpr KeyNeed kBare{[](const KeyPlace& p) { return p.hatched; },
                        ": all parts are drawn without strokes (`ghost`, `highlight`)"};
constexpr KeyNeed kStrokesOrTones{
    [](const KeyPlace& p) { return has_strokes(p.part) || lit_without_strokes(p); },
    ": style '{style}' draws no strokes, tones or shadows (hatch.enabled=true, tone.steps=2 or "
    "shadow.ground=true does)"};
constexpr KeyNeed kOtherThanGround{[](const KeyPlace& p) {
                                     return has_strokes(p.part) || lit_without_strokes(p) ||
                                            !p.whole.shadow.ground;
                                   },
                                   ": it would light the shadow on the ground alone, which this "
                                   "`view` and this light do not show"};
constexpr KeyNeed kLooksAtLight{
    [](const KeyPlace& p) {
      return lit_without_strokes(p) ||
             (has_strokes(p.part) && p.hatched && strokes_look_at_light(p));
    },
    ": tone.law {law} does not look at it"};
constexpr std::string_view kOtherLaw = ": tone.law {law} does not look at it";
constexpr KeyNeed kShadowed{[](const KeyPlace& p) { return tone_of(p).shadow > 0; },
                            ": tone.shadow is 0"};
constexpr KeyNeed kBalanced{
    [](const KeyPlace& p) { return balances(tone_of(p)); },
    ": it is for light and shade, not for tone.law {law} with tone.ink {toneink}"};

struct Row {
  std::string_view key;
  std::vector<KeyNeed> needs;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all = {
      {"line.centre", {kCentreLines}},
      {"line.centre_over", {kCentreLines}},
      {"line.thread", {kThreads}},
      {"line.thread_gap", {kThreads}},
      {"fill.color", {kSeen}},
      {"fill.opacity", {kColored}},
      {"fill.ink", {kColored, kSeen}},
      {"fill.tint", {kColored, kInk, kSeen}},
      {"fill.legend", {kAreas, kLegend}},
      {"fill.faces", {kSolid}},
      {"fill.shadow", {kSolid, kSeenShadow}},
      {"fill.hatch", {kSolid, kUnlikeArea}},
      {"fill.hatch_angle", {kHatched}},
      {"fill.hatch_distance", {kHatched}},
      {"fill.hatch_width", {kHatched}},
      {"fill.hatch_tones", {kHatched, kToned}},
      {"fill.hatch_color", {kHatched, kPartColor, kUnlikeArea}},
      {"shadow.cast", {kSolid}},
      {"shadow.ground", {kSolid, kGround}},
      {"shadow.color", {kShadow, kShadowOfOwnColor}},
      {"tone.law", {kStrokes, kBare}},
      {"tone.light", {kOtherThanGround, kStrokesOrTones, kLooksAtLight}},
      {"tone.ambient", {kStrokes, kBare, {law_uses<"ambient">, kOtherLaw}}},
      {"tone.diffuse", {kStrokes, kBare, {law_uses<"diffuse">, kOtherLaw}}},
      {"tone.reflected", {kStrokes, kBare, {law_uses<"reflected">, kOtherLaw}}},
      {"tone.specular", {kStrokes, kBare, {law_uses<"specular">, kOtherLaw}}},
      {"tone.shininess", {kStrokes, kBare, {law_uses<"shininess">, kOtherLaw}}},
      {"tone.decay", {kStrokes, kBare, {law_uses<"decay">, kOtherLaw}}},
      {"tone.shadow", {kStrokes, kBare}},  // of its law `report_unused` tells
      {"tone.shadow_width", {kStrokes, kBare, {law_uses<"shadow">, kOtherLaw}, kShadowed}},
      {"tone.highlight", {kStrokes, kBare}},
      {"tone.rim", {kStrokes, kBare}},
      {"tone.ink", {kStrokes, kBare}},
      {"tone.median_min", {kStrokes, kBare, kBalanced}},
      {"tone.median_max", {kStrokes, kBare, kBalanced}},
      {"tone.contrast", {kStrokes, kBare, kBalanced}},
      {"tone.gradient", {kStrokes, kBare, kBalanced}},
      {"tone.steps", {kAreas, kSeenAreas, kSolid}},
      {"tone.darkest", {kColored, kSeen, kNoInk, kSolid, kToned}},
  };
  return all;
}

}  // namespace

std::vector<KeyNeed> needs_of(std::string_view key) {
  const auto row = std::ranges::find(rows(), key, &Row::key);
  if (row != rows().end()) return row->needs;
  const bool of_strokes = key.starts_with("hatch.") || key.starts_with("tone.");
  if (of_strokes && key != "hatch.enabled") return {kStrokes, kBare};
  return {};
}

}  // namespace burin::detail
