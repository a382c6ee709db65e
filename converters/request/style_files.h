#pragma once
// Styles as files; internal to the module.

#include <burin/illustrate/style.h>

#include <string>

namespace burin::detail {

/// A style as its name or its text has it.
struct LoadedStyle {
  Style style{};
  /// Empty: a built-in one.
  std::string text = {};
  /// The file of the text; empty: a program made it.
  std::string source = {};
};

/// As `load_style`.
LoadedStyle load_with_text(const std::string& name, const Style* whole = nullptr);

/// Whether the text of a style, which `parse_style` takes, says itself that fills are opaque: such
/// parts are not of glass. That its "base" has such fills says nothing.
bool is_said_opaque(const std::string& style_text);

}  // namespace burin::detail
