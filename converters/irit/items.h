#pragma once
/// The items of objects; the opening bracket and the keyword are already read.

#include <burin/converters/irit_tree.h>

#include "lexer.h"

namespace burin::irit {

/// Whether a raised word begins an item, and no attribute.
bool is_item(std::string_view keyword);
/// Up to and with the closing bracket.
IritItem read_item(Lexer& in, const Token& keyword);
/// All attribute blocks that stand here; with `until_item` none that begins as an item does.
IritAttributes read_attributes(Lexer& in, bool until_item = false);

/// SURFACE and CURVE.
IritItem read_surface(Lexer& in, const Token& keyword);
IritItem read_curve(Lexer& in, const Token& keyword);
/// TRIMSRF and MODEL.
IritItem read_trimmed(Lexer& in, const Token& keyword);
/// TRIVAR.
IritItem read_trivariate(Lexer& in, const Token& keyword);

}  // namespace burin::irit
