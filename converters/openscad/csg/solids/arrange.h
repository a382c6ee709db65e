#pragma once
// What all facets of one plane that touch come to: pieces, and which facets cover them; for
// csg/solids alone.

#include "pairs.h"
#include "triangulate.h"

#include <functional>

namespace burin::csg {

/// Facets of one plane whose boxes overlap, and where facets of other planes meet them.
struct Sheet {
  Id plane = 0;
  std::vector<const Facet*> facets;
  std::vector<Meeting> meetings;
};

/// What becomes of a piece: nothing (0), or a facet whose outside is where the plane's normal
/// points (1) or not (-1), standing for a surface.
struct Piece {
  int way = 0;
  std::int32_t surface = -1;
  bool operator==(const Piece&) const = default;
};

/// Asked once for each piece that at least one facet covers: a triangle of it, and which facets of
/// the sheet cover it.
using Judge = std::function<Piece(const std::array<Id, 3>& triangle,
                                  std::span<const std::uint32_t> covering)>;

/// The facets that are left, pieces side by side joined.
void arrange(Space& space, const Sheet& sheet, const Judge& judge, std::vector<Facet>& out);

}  // namespace burin::csg
