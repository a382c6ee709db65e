#pragma once
/// The parts list as a file.

#include <burin/drawing/drawing.h>

#include <span>
#include <string>

namespace burin {

/// A heading and a line an item: number,name,quantity,colour,source,parts; the last holds a
/// selector a part, with ";" between them. Texts with a comma, a quote or the end of a line stand
/// in quotes, quotes in them twice; lines end with CR LF. UTF-8.
/// @cite RFC4180
std::string parts_list_csv(std::span<const DrawingItem> items);

/// {"items": [{"number", "name", "quantity", "colour", "source", "parts": [selector a part]}]}.
std::string parts_list_json(std::span<const DrawingItem> items);

}  // namespace burin
