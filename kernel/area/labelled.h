#pragma once
/// Triangles of the sheet with what is seen in each; internal to the module.

#include <burin/planar/growing_triangulation.h>

#include "network.h"

namespace burin::detail {

struct LabelledMesh {
  PlanarMesh mesh;
  std::vector<AreaLabel> labels;
  std::size_t mixed = 0;
  double mixed_area = 0;
};

double area_of(const PlanarMesh& mesh, std::size_t triangle);

/// Triangulates the network and labels the triangles. Where a triangle holds two labels, segments
/// between them are added to the network, in so many rounds as the options say.
LabelledMesh label_triangles(Network& network, const LabelAt& label_at,
                             const PartitionOptions& options, const RunContext& context);

}  // namespace burin::detail
