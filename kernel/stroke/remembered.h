#pragma once
// What strokes leave for the same ones in another light; internal to the module.

#include <burin/stroke/stroke_memory.h>

#include "level_lines.h"
#include "narrow_faces.h"
#include "view_raster.h"
#include "wave_graph.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace burin::detail {

/// A level line and the cell of the raster whose face it runs on.
struct CellLine {
  LevelLine line;
  std::uint32_t cell = 0;
};

/// Of the first family, whose lines stand where they do in any light that has the same narrow
/// faces.
struct FirstLines {
  /// Faces along which strokes run instead of across.
  FaceSet narrow;
  std::vector<CellLine> lines;
};

struct Remembered {
  /// No cell has a darkness.
  std::optional<ViewRaster> raster;
  /// Of the first family in the field as it is.
  std::optional<WaveGraph> graph;
  std::optional<FirstLines> first;
};

}  // namespace burin::detail

namespace burin {

struct StrokeMemory::Impl : detail::Remembered {};

}  // namespace burin
