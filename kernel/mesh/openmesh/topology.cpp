#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/mesh/topology.h>

#include "../build_steps.h"
#include "openmesh_glm.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <mutex>

namespace burin {

namespace {

/// OpenMesh builds serially; slices of the mesh this large are built side by side and stitched.
constexpr std::size_t kSlice = 1 << 17;  // triangles
constexpr std::uint32_t kNone = 0xffffffffu;

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

[[noreturn]] void throw_not_manifold(std::size_t face) {
  throw GeometryError(fmt::format(
      "triangle {} meets an edge that has two triangles already or is turned against its "
      "neighbour; repair the mesh",
      face));
}

/// A half-edge without an opposite in its slice, with its edge: the lower vertex first.
struct OpenEdge {
  std::uint32_t low, high;
  HalfEdge h;

  bool same_edge(const OpenEdge& e) const { return low == e.low && high == e.high; }
  friend auto operator<=>(const OpenEdge&, const OpenEdge&) = default;
};

/// Some consecutive triangles of the mesh, as an OpenMesh of their own.
class Slice {
 public:
  Slice(const TriMesh& mesh, std::size_t begin, std::size_t end)
      : mesh_(mesh), begin_(begin), end_(end) {}

  void build(std::vector<HalfEdge>& opposite, const RunContext& context) {
    add_faces(context);
    if (bad_face == kNone) read_opposites(opposite);
    openmesh_ = {};
  }

  /// The first triangle that OpenMesh does not take, or kNone.
  std::uint32_t bad_face = kNone;
  std::vector<OpenEdge> open;

 private:
  void add_faces(const RunContext& context) {
    const std::size_t faces = end_ - begin_;
    openmesh_.reserve(std::min(mesh_.positions.size(), faces), 2 * faces, faces);
    std::vector<int> local(mesh_.positions.size(), -1);
    for (std::size_t f = begin_; f < end_; ++f) {
      if (f % kFaceGrain == 0) context.check();
      std::array<OpenMesh::VertexHandle, 3> corner;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh_.triangles[f][k];
        if (local[v] < 0) local[v] = openmesh_.add_vertex(mesh_.positions[v]).idx();
        corner[k] = OpenMesh::VertexHandle(local[v]);
      }
      if (!openmesh_.add_face(corner[0], corner[1], corner[2]).is_valid()) {
        bad_face = static_cast<std::uint32_t>(f);
        return;
      }
      first_corner_.push_back(corner[0].idx());
    }
  }

  void read_opposites(std::vector<HalfEdge>& opposite) {
    std::vector<HalfEdge> to_flat(openmesh_.n_halfedges(), kNoHalfEdge);
    std::vector<int> to_openmesh(3 * (end_ - begin_));
    for (std::size_t i = 0; i < end_ - begin_; ++i) {
      auto h = openmesh_.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(i)));
      while (openmesh_.from_vertex_handle(h).idx() != first_corner_[i]) {
        h = openmesh_.next_halfedge_handle(h);
      }
      for (std::size_t k = 0; k < 3; ++k, h = openmesh_.next_halfedge_handle(h)) {
        to_flat[static_cast<std::size_t>(h.idx())] = static_cast<HalfEdge>(3 * (begin_ + i) + k);
        to_openmesh[3 * i + k] = h.idx();
      }
    }
    for (std::size_t i = 0; i < to_openmesh.size(); ++i) {
      const auto h = static_cast<HalfEdge>(3 * begin_ + i);
      // OpenMesh numbers the two half-edges of an edge 2 e and 2 e + 1.
      const HalfEdge o = to_flat[static_cast<std::size_t>(to_openmesh[i] ^ 1)];
      opposite[static_cast<std::size_t>(h)] = o;
      if (o != kNoHalfEdge) continue;
      const std::uint32_t a = origin(mesh_, h), b = origin(mesh_, next_in_face(h));
      open.push_back({std::min(a, b), std::max(a, b), h});
    }
  }

  const TriMesh& mesh_;
  std::size_t begin_, end_;
  OpenMeshTriMesh openmesh_;
  std::vector<int> first_corner_;
};

/// Joins half-edges of different slices; returns those at the boundary of the mesh, sorted.
std::vector<OpenEdge> stitch(const TriMesh& mesh, std::vector<OpenEdge> open,
                             std::vector<HalfEdge>& opposite) {
  std::ranges::sort(open);
  std::vector<OpenEdge> boundary;
  for (std::size_t i = 0; i < open.size();) {
    std::size_t end = i + 1;
    while (end < open.size() && open[i].same_edge(open[end])) ++end;
    if (end == i + 1) {
      boundary.push_back(open[i]);
    } else {
      const HalfEdge a = open[i].h, b = open[i + 1].h;
      if (end > i + 2 || origin(mesh, a) == origin(mesh, b)) throw_not_manifold(face_of(b));
      opposite[static_cast<std::size_t>(a)] = b;
      opposite[static_cast<std::size_t>(b)] = a;
    }
    i = end;
  }
  return boundary;
}

/// Throws where an edge of the boundary has two more triangles in another slice.
void check_boundary(const TriMesh& mesh, const std::vector<OpenEdge>& boundary,
                    const std::vector<HalfEdge>& opposite) {
  if (boundary.empty()) return;
  std::vector<std::uint8_t> marked(mesh.positions.size(), 0);
  for (const OpenEdge& e : boundary) marked[e.low] = marked[e.high] = 1;
  for (std::size_t i = 0; i < opposite.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    const std::uint32_t a = origin(mesh, h), b = origin(mesh, next_in_face(h));
    if (opposite[i] == kNoHalfEdge || !marked[a] || !marked[b]) continue;
    const OpenEdge wanted{std::min(a, b), std::max(a, b), kNoHalfEdge};
    const auto it = std::ranges::lower_bound(boundary, wanted);
    if (it != boundary.end() && it->same_edge(wanted)) throw_not_manifold(face_of(it->h));
  }
}

}  // namespace

std::vector<HalfEdge> find_opposites(const TriMesh& mesh, const RunContext& context) {
  check_corners(mesh);
  static std::once_flag quiet;
  std::call_once(quiet, [] { omerr().disable(); });
  const std::size_t faces = mesh.triangles.size();
  std::vector<HalfEdge> opposite(3 * faces, kNoHalfEdge);
  std::vector<Slice> slices;
  for (std::size_t begin = 0; begin < faces; begin += kSlice) {
    slices.emplace_back(mesh, begin, std::min(faces, begin + kSlice));
  }
  parallel_for(
      slices.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) slices[i].build(opposite, context);
      },
      &context);
  std::vector<OpenEdge> open;
  for (const Slice& slice : slices) {
    if (slice.bad_face != kNone) throw_not_manifold(slice.bad_face);
    open.insert(open.end(), slice.open.begin(), slice.open.end());
  }
  if (slices.size() > 1) {
    check_boundary(mesh, stitch(mesh, std::move(open), opposite), opposite);
  }
  return opposite;
}

Topology build_topology(const TriMesh& mesh, const RunContext& context) {
  Topology topology;
  topology.opposite = find_opposites(mesh, context);
  find_components(topology);
  return topology;
}

}  // namespace burin
