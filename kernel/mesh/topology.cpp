#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/mesh/topology.h>

#include "flood.h"
#include "openmesh_glm.h"

#include <fmt/format.h>

#include <limits>
#include <mutex>

namespace burin {

namespace {

constexpr std::size_t kGrain = 8192;  // triangles a range: 0.1 to 1 ms

/// OpenMesh takes a triangle with a repeated corner and then aborts, so none may reach it.
void check_corners(const TriMesh& mesh) {
  if (mesh.triangles.size() > std::numeric_limits<HalfEdge>::max() / 3) {
    throw GeometryError(fmt::format("a mesh of {} triangles is too large; at most {} are possible",
                                    mesh.triangles.size(),
                                    std::numeric_limits<HalfEdge>::max() / 3));
  }
  const std::size_t vertices = mesh.positions.size();
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    if (t[0] >= vertices || t[1] >= vertices || t[2] >= vertices) {
      throw GeometryError(fmt::format("triangle {} has a corner that is not in the mesh", f));
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      throw GeometryError(fmt::format("triangle {} has a repeated corner; repair the mesh", f));
    }
  }
}

OpenMeshTriMesh to_openmesh(const TriMesh& mesh, const RunContext& context) {
  static std::once_flag quiet;
  std::call_once(quiet, [] { omerr().disable(); });
  OpenMeshTriMesh om;
  const std::size_t faces = mesh.triangles.size();
  om.reserve(mesh.positions.size(), faces + faces / 2 + 16, faces);
  for (const Vec3& p : mesh.positions) om.add_vertex(p);
  for (std::size_t f = 0; f < faces; ++f) {
    if (f % kGrain == 0) context.check();
    const Triangle& t = mesh.triangles[f];
    const auto vertex = [](std::uint32_t v) { return OpenMesh::VertexHandle(static_cast<int>(v)); };
    if (!om.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])).is_valid()) {
      throw GeometryError(fmt::format(
          "triangle {} meets an edge that has two triangles already or is turned against its "
          "neighbour; repair the mesh",
          f));
    }
  }
  return om;
}

std::vector<HalfEdge> flat_opposites(const TriMesh& mesh, const OpenMeshTriMesh& om,
                                     const RunContext& context) {
  const std::size_t faces = mesh.triangles.size();
  std::vector<HalfEdge> to_flat(om.n_halfedges(), kNoHalfEdge);
  std::vector<HalfEdge> opposite(3 * faces, kNoHalfEdge);
  std::vector<int> to_openmesh(3 * faces);
  parallel_for(
      faces, kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          auto h = om.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(f)));
          const auto from = static_cast<std::uint32_t>(om.from_vertex_handle(h).idx());
          std::size_t k = from == mesh.triangles[f][0] ? 0 : from == mesh.triangles[f][1] ? 1 : 2;
          for (int i = 0; i < 3; ++i, k = (k + 1) % 3, h = om.next_halfedge_handle(h)) {
            to_flat[static_cast<std::size_t>(h.idx())] = static_cast<HalfEdge>(3 * f + k);
            to_openmesh[3 * f + k] = h.idx();
          }
        }
      },
      &context);
  parallel_for(
      3 * faces, 3 * kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = begin; h < end; ++h) {
          opposite[h] =
              to_flat[static_cast<std::size_t>(to_openmesh[h] ^ 1)];  // OpenMesh pairs them
        }
      },
      &context);
  return opposite;
}

}  // namespace

Topology build_topology(const TriMesh& mesh, const RunContext& context) {
  check_corners(mesh);
  Topology topology;
  topology.opposite = flat_opposites(mesh, to_openmesh(mesh, context), context);
  const std::int32_t components = flood(
      topology.opposite, [](HalfEdge) { return true; }, topology.face_component);
  topology.component_closed.assign(static_cast<std::size_t>(components), 1);
  for (std::size_t h = 0; h < topology.opposite.size(); ++h) {
    if (topology.opposite[h] != kNoHalfEdge) continue;
    topology.component_closed[static_cast<std::size_t>(topology.face_component[h / 3])] = 0;
  }
  return topology;
}

}  // namespace burin
