#pragma once
// Lines, texts and areas as entities of DXF.

#include <burin/drawing/arcs.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/format_options.h>

#include "dxf_frame.h"
#include "dxf_groups.h"
#include "dxf_options.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace burin::dxf {

struct Chosen {
  DxfOptions dxf;
  SvgOptions svg;
};

/// One path, or text, and where it belongs.
struct Item {
  const Path* path = nullptr;
  const LayerRow* layer = nullptr;
  const Text* text = nullptr;
  const Area* area = nullptr;
  /// Of a path with arcs in it.
  std::vector<CurvePiece> pieces = {};
  /// That of its first entity; the others follow.
  std::uint64_t handle = 0;

  std::size_t entities() const { return std::max<std::size_t>(1, pieces.size()); }
};

/// Of the weights that DXF knows the nearest to the width of a path, in 1/100 mm.
int weight_of(const Path& path);

/// The arcs in a path, and what is between them; nothing where there are none.
std::vector<CurvePiece> pieces_of(const Path& path, const Chosen& options);

/// Whether a ring is one circle or ellipse. B-reps have them in halves.
bool is_whole_arc(const Path& ring, const Chosen& options);

/// Appends the entities of an item, from its handle on.
void append(Groups& out, const Item& item, const Chosen& options);

}  // namespace burin::dxf
