#include "model_parts.h"

#include <array>

namespace burin {
namespace {

/// The two uses of an edge by two different faces; false where there are others.
bool two_faces(const ModelParts& parts, const ModelEdge& e, std::array<const ModelCoedge*, 2>& c) {
  if (e.degenerate || e.coedges.size() != 2) return false;
  for (std::size_t k = 0; k < 2; ++k) c[k] = &parts.coedges[static_cast<std::size_t>(e.coedges[k])];
  return c[0]->face != c[1]->face && !c[0]->internal && !c[1]->internal;
}

}  // namespace

void orient_faces(ModelParts& parts) {
  std::vector<std::uint8_t> seen(parts.faces.size(), 0);
  std::vector<std::int32_t> stack;
  const auto visit_neighbours = [&](std::int32_t face) {
    const auto first =
        static_cast<std::size_t>(parts.faces[static_cast<std::size_t>(face)].first_coedge);
    for (std::size_t i = first; i < parts.coedges.size() && parts.coedges[i].face == face; ++i) {
      const ModelEdge& e = parts.edges[static_cast<std::size_t>(parts.coedges[i].edge)];
      std::array<const ModelCoedge*, 2> c{};
      if (!two_faces(parts, e, c)) continue;
      const ModelCoedge& other = c[0]->face == face ? *c[1] : *c[0];
      const ModelCoedge& own = c[0]->face == face ? *c[0] : *c[1];
      const auto o = static_cast<std::size_t>(other.face);
      if (seen[o]) continue;
      seen[o] = 1;
      stack.push_back(other.face);
      // Neighbours agree where they run along the edge in opposite directions.
      const bool own_way = own.reversed != parts.faces[static_cast<std::size_t>(face)].reversed;
      parts.faces[o].reversed = other.reversed == own_way;
    }
  };
  for (std::size_t f = 0; f < parts.faces.size(); ++f) {
    if (seen[f]) continue;
    seen[f] = 1;
    stack.push_back(static_cast<std::int32_t>(f));
    while (!stack.empty()) {
      const std::int32_t face = stack.back();
      stack.pop_back();
      visit_neighbours(face);
    }
  }
}

}  // namespace burin
