#include <burin/base/parallel.h>

#include "build_steps.h"

namespace burin {

namespace {

/// The corner at the same vertex on the other side of half-edge `h`'s edge (clockwise), or
/// kNoHalfEdge across a crease or boundary.
HalfEdge clockwise(const ProxyMesh& proxy, HalfEdge h) {
  if (proxy.edge_kind[static_cast<std::size_t>(h)] != EdgeKind::Smooth) return kNoHalfEdge;
  return next_in_face(proxy.topology.opposite[static_cast<std::size_t>(h)]);
}

HalfEdge counter_clockwise(const ProxyMesh& proxy, HalfEdge h) {
  const HalfEdge in = prev_in_face(h);
  if (proxy.edge_kind[static_cast<std::size_t>(in)] != EdgeKind::Smooth) return kNoHalfEdge;
  return proxy.topology.opposite[static_cast<std::size_t>(in)];
}

constexpr std::uint32_t kUnset = 0xffffffffu;

std::uint32_t& wedge_slot(ProxyMesh& proxy, HalfEdge h) {
  return proxy.wedges[face_of(h)][static_cast<std::size_t>(h % 3)];
}

/// Marks every corner that smooth edges connect with `start` around its vertex.
void mark_wedge(ProxyMesh& proxy, HalfEdge start, std::uint32_t wedge) {
  for (HalfEdge h = start; h != kNoHalfEdge; h = counter_clockwise(proxy, h)) {
    if (wedge_slot(proxy, h) == wedge) return;  // all the way round
    wedge_slot(proxy, h) = wedge;
  }
  for (HalfEdge h = clockwise(proxy, start); h != kNoHalfEdge; h = clockwise(proxy, h)) {
    wedge_slot(proxy, h) = wedge;
  }
}

}  // namespace

void find_wedges(ProxyMesh& proxy, const Corners& corners, const RunContext& context) {
  const std::size_t vertices = proxy.mesh.positions.size();
  proxy.wedges.assign(proxy.mesh.triangles.size(), {kUnset, kUnset, kUnset});
  std::vector<std::uint32_t> first(vertices + 1, 0);
  parallel_for(
      vertices, kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          std::uint32_t count = 0;
          for (const HalfEdge h : corners[v]) {
            if (wedge_slot(proxy, h) == kUnset) mark_wedge(proxy, h, count++);
          }
          first[v + 1] = count;
        }
      },
      &context);
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  proxy.wedge_vertex.resize(first[vertices]);
  parallel_for(
      vertices, kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (std::uint32_t w = first[v]; w < first[v + 1]; ++w) {
            proxy.wedge_vertex[w] = static_cast<std::uint32_t>(v);
          }
        }
      },
      &context);
  parallel_for(
      proxy.wedges.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          for (std::size_t k = 0; k < 3; ++k) {
            proxy.wedges[f][k] += first[proxy.mesh.triangles[f][k]];
          }
        }
      },
      &context);
}

}  // namespace burin
