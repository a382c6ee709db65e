#include <burin/drawing/clip.h>
#include <burin/drawing/near_sheet.h>

#include <algorithm>
#include <utility>

namespace burin {

NearSheet::NearSheet(const Drawing& drawing) : layers_(ink_layers(drawing)) {
  const Vec2 sheet(drawing.paper_width, drawing.paper_height);
  const Vec2 room(std::max(sheet.x, sheet.y));
  const Box2 window{-room, sheet + room};
  for (InkLayer& layer : layers_) {
    for (auto& [part, paths] : layer.parts) {
      std::vector<const Path*> kept;
      kept.reserve(paths.size());
      for (const Path* path : paths) {
        if (lies_in(*path, window)) {
          kept.push_back(path);
          continue;
        }
        for (Path& piece : clipped(*path, window)) {
          pieces_.push_back(std::move(piece));
          kept.push_back(&pieces_.back());
        }
      }
      paths = std::move(kept);
    }
  }
}

}  // namespace burin
