#pragma once
/// A parts list on sheets of its own.

#include <burin/annotate/options.h>
#include <burin/camera/paper.h>
#include <burin/camera/sheet.h>
#include <burin/drawing/drawing.h>

#include <span>
#include <vector>

namespace burin {

/// The items from the top down, as ISO 7573 has lists on a separate sheet, with as many sheets as
/// they need. Layer "parts_list".
std::vector<Drawing> list_pages(std::span<const DrawingItem> items, const CalloutOptions& style,
                                const Paper& paper, const Margin& margin);

}  // namespace burin
