#pragma once
/// Keys of styles that change nothing of a drawing.

#include <burin/illustrate/illustrate.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What beside styles decides whether keys have an effect.
struct KeySurroundings {
  /// Whether a legend is drawn.
  bool legend = false;
  /// Whether a shadow on the ground would be seen in any view (burin/illustrate/ground.h).
  bool ground_seen = true;
};

/// Why a key changes nothing where all parts are drawn as they are, as it goes on after "has no
/// effect": ": fill.hatch is none (...)", " without `legend`"; empty where it may change something.
/// `part_styles`: one a part of the drawing, those without a style of their own have `whole`. A
/// value of `whole` that every part has otherwise by a style of its own changes nothing either.
/// Keys that are not known: empty. Cost: styles of parts are compared.
std::string why_unused(std::string_view key, const Style& whole,
                       std::span<const PartStyle> part_styles, const KeySurroundings& around);

/// The same of a key in the style of some parts, whatever parts, view and legend a drawing has.
/// Keys that hold for the whole drawing: empty.
std::string why_unused_in_parts(std::string_view key, const Style& part, const Style& whole);

/// The keys that the text of a style, which `parse_style` takes, sets to other values than its
/// "base" has, without one than `start` has: as `style_keys` names them, in the order of the text.
std::vector<std::string> keys_written(std::string_view json, const std::string& source,
                                      const Style& start);

}  // namespace burin
