#pragma once
// Hidden places that belong together, and what a mesh has of them.

#include "exact_mesh.h"
#include "hidden.h"
#include "specks.h"

#include <unordered_map>
#include <vector>

namespace burin {

/// Places in cells that touch one another.
struct Cluster {
  std::vector<Cell> cells;
  Box3 box;
  double side = 0;  // of the largest place in a cell, the median of all cells
  std::vector<HiddenPlace> places;
};

std::vector<Cluster> clusters_of(const std::vector<HiddenPlace>& places);

/// Which components of a mesh have vertices in the cells of places and beside them.
class PassedCells {
 public:
  PassedCells(const ExactMesh& mesh, const std::vector<HiddenPlace>& places,
              const GridLayout& layout);

  /// The share of the cells of a cluster that the mesh passes through.
  double share(const Cluster& cluster) const;

  /// The longest side of the places of a cluster that no component passes by that is as long as the
  /// cluster: fragments of a thing are not the thing. Model mm.
  double longest_missing(const Cluster& cluster) const;

 private:
  bool spans(std::uint32_t component, const Box3& box) const;

  MeshComponents parts_;
  double step_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> in_cell_;
};

}  // namespace burin
