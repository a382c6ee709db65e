#pragma once
// Where the leaders of items begin; internal to the module.

#include <burin/annotate/options.h>
#include <burin/base/vec.h>
#include <burin/drawing/drawing.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin::detail {

struct Anchor {
  const DrawingItem* item = nullptr;
  std::int32_t part = -1;
  /// Paper mm.
  Vec2 at{0};
  /// Else an arrow: the part is too narrow there.
  bool dot = true;
};

/// One an item, in their order: the middle of the largest disc in what is seen of one of its parts
/// that no line passes through. Without one of over 0.8 mm it is the largest disc whatever lines
/// there are, and where that is no larger the middle of the part's longest line. Of parts that are
/// seen about as well the outermost is taken, as seen from `middle`. A part that is looked through
/// has its dot where it alone is seen, and two dots on one place are parted, where there is room.
/// `seen`: what is seen of each part, those that are looked through first. Items that are not seen
/// go to `not_shown`. Cost: `largest_disc` for each part, and for each that is looked through up to
/// 1,600 places times the sides of all borders.
std::vector<Anchor> find_anchors(const Drawing& drawing, std::span<const Area> seen,
                                 const std::vector<DrawingItem>& items, Vec2 middle,
                                 CalloutOptions::Layout layout,
                                 std::vector<const DrawingItem*>& not_shown);

}  // namespace burin::detail
