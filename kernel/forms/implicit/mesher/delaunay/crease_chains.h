#pragma once
// The creases of a mesh as curves.

#include "../exact_mesh.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace burin {

/// Chains of vertices that follow the creases and meet at their ends alone; first equal to last:
/// closed.
using CreaseChains = std::vector<std::vector<std::uint32_t>>;

/// The sharp edges of a mesh, chained between corners. Edges that the crease itself does not pass
/// by are left out.
CreaseChains chain_creases(const ExactMesh& mesh, const ImplicitFunction& f);

/// Finds the edge of the chains next to a point of theirs.
class ChainFinder {
 public:
  /// Keeps references. `cell`: about the length of the edges.
  ChainFinder(const ExactMesh& mesh, const CreaseChains& chains, double cell);

  struct Place {
    std::uint32_t from = 0, to = 0;  // the edge
    std::uint32_t nearest = 0;       // the end of it nearer to the point
  };
  /// The nearest one; false where none is within a cell.
  bool find(Vec3 p, Place& place) const;

 private:
  glm::ivec3 cell_of(Vec3 p) const;

  const ExactMesh& mesh_;
  double cell_;
  Vec3 origin_{0};
  std::vector<Place> edges_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// The sides that both vertices of an edge along a crease have.
std::vector<CreaseVertex::Side> common_sides(const ExactMesh& mesh, std::uint32_t u,
                                             std::uint32_t v);

/// A cell's key for hashing; coordinates within a million of zero.
std::uint64_t cell_key(glm::ivec3 c);

}  // namespace burin
