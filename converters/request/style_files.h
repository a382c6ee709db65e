#pragma once
// Styles as files; internal to the module.

#include <burin/illustrate/style.h>

#include <optional>
#include <string>

namespace burin::detail {

/// The text of the file that a style is named by; nothing for a built-in one. Throws MissingFile,
/// InputError.
std::optional<std::string> text_of_style(const std::string& name);

/// The style in the text of a file; `whole` as `load_style` takes it. Throws as `parse_style` does.
Style read_style(const std::string& text, const std::string& file, const Style* whole);

/// Whether the text of a style, which `parse_style` takes, says itself that fills are opaque: such
/// parts are not of glass. That its "base" has such fills says nothing.
bool is_said_opaque(const std::string& style_text);

}  // namespace burin::detail
