#include "ring_mesh.h"

#include <burin/base/parallel.h>

#include "../build_steps.h"

#include <algorithm>

namespace burin {

namespace {

/// Of an edge the half-edge that counts for both.
bool is_first(const std::vector<HalfEdge>& opposite, std::size_t h) {
  return opposite[h] == kNoHalfEdge || static_cast<HalfEdge>(h) < opposite[h];
}

/// The OpenMesh handle of each flat half-edge: edges in order of their first half-edges, which is
/// the one inside at a boundary.
std::vector<RingHandle> pair_edges(const std::vector<HalfEdge>& opposite) {
  std::vector<RingHandle> handles(opposite.size());
  int next = 0;
  for (std::size_t h = 0; h < opposite.size(); ++h) {
    if (!is_first(opposite, h)) continue;
    const OpenMesh::EdgeHandle edge(next++);
    handles[h] = RingMesh::s_halfedge_handle(edge, 0);
    if (opposite[h] != kNoHalfEdge) {
      handles[static_cast<std::size_t>(opposite[h])] = RingMesh::s_halfedge_handle(edge, 1);
    }
  }
  return handles;
}

/// Finds the ring of one wedge after another; keeps its buffer between them.
class WedgeWalk {
 public:
  WedgeWalk(const RingMesh& rings, const ProxyMesh& proxy) : rings_(rings), proxy_(proxy) {}

  /// Fills the ring from its first half-edge on: around the vertex as far as the next creases.
  void fill(std::span<RingHandle> ring) {
    const RingHandle first = ring[0];
    wedge_ = wedge_of(proxy_, rings_.corner(first));
    found_.clear();
    RingHandle h = first;
    do {
      take(h);
      if (!smooth(rings_.prev_halfedge_handle(h))) break;
      h = rings_.ccw_rotated_halfedge_handle(h);
    } while (h != first);
    const bool all_round = smooth(rings_.prev_halfedge_handle(h));
    for (h = first; !all_round && smooth(h); take(h)) h = rings_.cw_rotated_halfedge_handle(h);
    std::ranges::sort(found_, {}, &Found::corner);
    std::ranges::transform(found_, ring.begin(), &Found::h);
  }

 private:
  struct Found {
    HalfEdge corner;
    RingHandle h;
  };

  bool smooth(RingHandle h) const {
    return proxy_.edge_kind[static_cast<std::size_t>(rings_.corner(h))] == EdgeKind::Smooth;
  }
  /// Leaves out what a fan has of other wedges: at the tip of a cone it has several.
  void take(RingHandle h) {
    const HalfEdge corner = rings_.corner(h);
    if (wedge_of(proxy_, corner) == wedge_) found_.push_back({corner, h});
  }

  const RingMesh& rings_;
  const ProxyMesh& proxy_;
  std::uint32_t wedge_ = 0;
  std::vector<Found> found_;
};

}  // namespace

// add_face has paired the half-edges already, in slices side by side (topology.cpp). One OpenMesh
// of them all is filled in parallel: every range of triangles writes to its own half-edges.
RingMesh::RingMesh(const TriMesh& mesh, const std::vector<HalfEdge>& opposite,
                   const RunContext& context) {
  const auto boundary = static_cast<std::size_t>(std::ranges::count(opposite, kNoHalfEdge));
  std::vector<RingHandle> handles;
  parallel_invoke(
      [&] {
        add_property(corner_);
        resize(mesh.positions.size(), (opposite.size() + boundary) / 2, mesh.triangles.size());
        add_points(mesh);
      },
      [&] { handles = pair_edges(opposite); });
  parallel_invoke([&] { connect(mesh, opposite, handles, context); },
                  [&] { enter_vertices(mesh, opposite, handles); });
}

void RingMesh::add_points(const TriMesh& mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    set_point(OpenMesh::VertexHandle(static_cast<int>(v)), mesh.positions[v]);
  }
}

void RingMesh::connect(const TriMesh& mesh, const std::vector<HalfEdge>& opposite,
                       const std::vector<RingHandle>& handles, const RunContext& context) {
  const auto at = [&](HalfEdge h) { return handles[static_cast<std::size_t>(h)]; };
  const auto vertex = [&](HalfEdge h) {
    return OpenMesh::VertexHandle(static_cast<int>(origin(mesh, h)));
  };
  // The half-edge after the one outside the boundary edge `h`: outside the last edge of the fan.
  const auto next_outside = [&](HalfEdge h) {
    HalfEdge in = prev_in_face(h);
    while (opposite[static_cast<std::size_t>(in)] != kNoHalfEdge) {
      in = prev_in_face(opposite[static_cast<std::size_t>(in)]);
    }
    return opposite_halfedge_handle(at(in));
  };
  parallel_for(
      mesh.triangles.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          const auto first = static_cast<HalfEdge>(3 * f);
          const OpenMesh::FaceHandle face(static_cast<int>(f));
          set_halfedge_handle(face, at(first));
          for (HalfEdge h = first; h < first + 3; ++h) {
            set_face_handle(at(h), face);
            set_vertex_handle(at(h), vertex(next_in_face(h)));
            set_next_halfedge_handle(at(h), at(next_in_face(h)));
            property(corner_, at(h)) = h;
            if (opposite[static_cast<std::size_t>(h)] != kNoHalfEdge) continue;
            const RingHandle outside = opposite_halfedge_handle(at(h));
            set_vertex_handle(outside, vertex(h));
            set_next_halfedge_handle(outside, next_outside(h));
            property(corner_, outside) = kNoHalfEdge;
          }
        }
      },
      &context);
}

/// Gives each vertex a half-edge to walk from: at a boundary the one outside, as OpenMesh wants.
void RingMesh::enter_vertices(const TriMesh& mesh, const std::vector<HalfEdge>& opposite,
                              const std::vector<RingHandle>& handles) {
  const auto enter = [&](HalfEdge at, RingHandle h) {
    set_halfedge_handle(OpenMesh::VertexHandle(static_cast<int>(origin(mesh, at))), h);
  };
  for (std::size_t h = 0; h < handles.size(); ++h) enter(static_cast<HalfEdge>(h), handles[h]);
  for (std::size_t h = 0; h < handles.size(); ++h) {
    if (opposite[h] != kNoHalfEdge) continue;
    enter(next_in_face(static_cast<HalfEdge>(h)), opposite_halfedge_handle(handles[h]));
  }
}

Groups<RingHandle> wedge_rings(const RingMesh& rings, const ProxyMesh& proxy,
                               const RunContext& context) {
  Groups<RingHandle> out;
  out.first.assign(proxy.wedge_vertex.size() + 1, 0);
  for (const Triangle& wedges : proxy.wedges) {
    for (const std::uint32_t w : wedges) ++out.first[w + 1];
  }
  for (std::size_t w = 1; w < out.first.size(); ++w) out.first[w] += out.first[w - 1];
  out.list.resize(out.first.back());
  for (std::size_t f = 0; f < proxy.wedges.size(); ++f) {
    RingHandle h = rings.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(f)));
    for (const std::uint32_t w : proxy.wedges[f]) {
      out.list[out.first[w]] = h;
      h = rings.next_halfedge_handle(h);
    }
  }
  parallel_for(
      proxy.wedge_vertex.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        WedgeWalk walk(rings, proxy);
        for (std::size_t w = begin; w < end; ++w) {
          const std::span ring(out.list.data() + out.first[w], out.list.data() + out.first[w + 1]);
          if (!ring.empty()) walk.fill(ring);
        }
      },
      &context);
  return out;
}

}  // namespace burin
