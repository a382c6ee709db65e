#pragma once
// The lines of a drawing that are no strokes, as polylines; internal to the module.

#include <burin/drawing/drawing.h>
#include <burin/planar/near_lines.h>

namespace burin {

/// Calls `each(layer, path, polyline)` for every visible feature line; a closed one repeats its
/// first point.
template <class F>
void each_feature_line(const Drawing& drawing, const F& each) {
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!path.visible || path.kind == LineClass::Stroke || path.kind == LineClass::Pattern ||
          path.kind == LineClass::Trail || path.kind == LineClass::Centre ||
          path.kind == LineClass::Thread || path.kind == LineClass::ThreadEnd ||
          path.points.size() < 2) {
        continue;
      }
      Polyline line = path.points;
      if (path.closed) line.push_back(line.front());
      each(layer, path, std::move(line));
    }
  }
}

}  // namespace burin
