#pragma once
#include <burin/converters/irit_tree.h>

#include <optional>
#include <string>

namespace burin::irit {

/// "#rrggbb" of the attribute RGB ("r,g,b", 0 to 255) or COLOR (an index into the sixteen colours
/// of IRIT); none where neither can be read.
std::optional<std::string> color_of(const IritObject& object);

}  // namespace burin::irit
