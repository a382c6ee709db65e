#pragma once
// Burin's own symbols; internal to the module.

#include <burin/annotate/symbols.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

/// Of surface texture, after ISO 1302.
SymbolKind surface_symbol();
/// Of a weld, after ISO 2553.
SymbolKind weld_symbol();
/// A text in a circle.
SymbolKind balloon_symbol();
/// Safety signs in the shapes and colours of ISO 3864, with words beside.
SymbolKind warning_symbol();
SymbolKind mandatory_symbol();
SymbolKind prohibition_symbol();

/// The lines of a text as one, with a blank between two.
std::string in_one_line(std::string text);
/// An open or closed line of a label.
Path label_line(std::vector<Vec2> points, double width, bool closed = false);
/// Puts words to the right of what stands in a label, both in the middle of its height.
void put_beside(std::string_view words, const LabelPens& pens, Label& label);

}  // namespace burin::detail
