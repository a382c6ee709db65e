#pragma once
/// Keys of styles that change nothing of a drawing.

#include <burin/illustrate/illustrate.h>

#include <span>
#include <string>
#include <string_view>

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

}  // namespace burin
