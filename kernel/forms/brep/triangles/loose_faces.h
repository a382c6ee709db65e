#pragma once
/// Faces that cannot be drawn from their charts: triangles of their own, joined to nothing.

#include <burin/forms/brep/loose_triangles.h>
#include <burin/forms/charted/atlas.h>
#include <burin/surface/scene.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// Moves the triangles of the faces that `loose` marks out of `mesh`, without (u,v). `corners`:
/// another array with an entry a half-edge.
LooseTriangles take_loose(ChartMesh& mesh, std::span<const std::uint8_t> loose,
                          std::vector<std::uint8_t>* corners = nullptr);

/// The triangles as a surface of its own, or nullptr where nothing of them can be drawn: repaired,
/// creases by angle, each triangle with its face.
std::shared_ptr<const Surface> loose_surface(const LooseTriangles& triangles,
                                             const RealiseOptions& options,
                                             const RunContext& context);

}  // namespace burin
