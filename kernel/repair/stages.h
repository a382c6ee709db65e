#pragma once
/// The steps of `repair`, private to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin::repair_stages {

/// Triangles or polygons a range of the parallel loops.
constexpr std::size_t kFaceGrain = 16384;

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// What comes with the triangles, one each.
using Numbers = std::vector<std::int32_t>;

/// Triangles of the soup's polygons over its positions. Concave and slightly bent polygons are cut
/// along diagonals inside them. Throws GeometryError where a corner is no position.
/// `of`: from a number for each polygon to one for each triangle.
TriMesh triangulate(PolygonSoup soup, Numbers* of, Diagnostics& diagnostics,
                    const RunContext& context);

/// For each vertex the corners (3 * triangle + k) that lie at it.
struct CornersOfVertex {
  std::vector<std::uint32_t> start;  // one more than there are vertices
  std::vector<std::uint32_t> corner;
};
CornersOfVertex corners_of_vertices(const TriMesh& mesh);

/// What a look at each vertex finds.
struct Cleanness {
  bool manifold =
      true;  // every fan of triangles is one disc or half disc, oriented alike, no corner repeated
  bool flat = false;  // some triangle has no area
  std::int64_t boundary_edges = 0;
  /// For each vertex whether the surface ends there.
  std::vector<std::uint8_t> open;
  bool clean() const { return manifold && !flat; }
};
Cleanness inspect(const TriMesh& mesh, const RunContext& context);

/// Whether a triangle's height is below the rounding of its coordinates, so that its normal is
/// noise.
bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c);

/// Half-edges (3 * triangle + k, from corner k to the next) grouped by their edge: group g is
/// half_edge[start[g]] .. half_edge[start[g+1]-1].
struct EdgeGroups {
  std::vector<std::uint32_t> half_edge;
  std::vector<std::uint32_t> start;
  std::size_t size() const { return start.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t g) const {
    return std::span(half_edge).subspan(start[g], start[g + 1] - start[g]);
  }
};
EdgeGroups group_edges(const TriMesh& mesh, const RunContext& context);

inline std::uint32_t from(const TriMesh& m, std::uint32_t h) { return m.triangles[h / 3][h % 3]; }
inline std::uint32_t to(const TriMesh& m, std::uint32_t h) {
  return m.triangles[h / 3][(h + 1 - h / 3 * 3) % 3];
}
inline std::uint32_t apex(const TriMesh& m, std::uint32_t h) {
  return m.triangles[h / 3][(h + 2 - h / 3 * 3) % 3];
}
inline std::uint32_t next_half_edge(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline std::uint32_t prev_half_edge(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// What was found and done; the same defect in a later round counts once.
struct RepairCounts {
  std::int64_t repeated_corners = 0, duplicates = 0, flipped = 0, nonorientable_edges = 0;
  std::int64_t nonmanifold_edges = 0, nonmanifold_vertices = 0, flat = 0, flat_dropped = 0;
};

/// Removes triangles, order kept, and their numbers where there are any; returns how many.
template <class Predicate>
std::int64_t erase_triangles(TriMesh& mesh, Numbers* of, const Predicate& gone) {
  if (of) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!gone(mesh.triangles[t])) (*of)[kept++] = (*of)[t];
    }
    of->resize(kept);
  }
  return static_cast<std::int64_t>(std::erase_if(mesh.triangles, gone));
}

inline bool repeats_corner(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Gives the ends of edges that are shorter than the rounding of their coordinates one vertex.
void join_tiny_edges(TriMesh& mesh);

/// Drops triangles that repeat another one. Of two that face each other in one place both stay
/// where they are the wall between solids or hang on a body, and one where they are a sheet drawn
/// from both sides.
std::int64_t drop_duplicates(TriMesh& mesh, Numbers* of, const RunContext& context);

/// Turns triangles so that neighbours over edges of two triangles agree, each such patch as most of
/// its triangles were; remaps `edges`. Returns how many were turned and over how many edges no
/// agreement is possible.
void orient_patches(TriMesh& mesh, EdgeGroups& edges, RepairCounts& counts,
                    const RunContext& context);

/// For each half-edge its partner in the neighbouring triangle, or kNone. At an edge of more than
/// two triangles those are partners between which material lies, so that solids that touch there
/// stay closed and come apart; with `cut` all of them end there.
std::vector<std::uint32_t> match_half_edges(const TriMesh& mesh, const EdgeGroups& edges, bool cut,
                                            RepairCounts& counts);

/// Turns the long edge of each triangle without area over to its neighbour, which leaves no hole;
/// drops it where it has no neighbour or this would not be manifold, or always with `drop`. Drops
/// also pairs of triangles that only have each other. Dropped triangles become {0, 0, 0}. Both
/// triangles of such a turn have the number of the neighbour: they lie where it was.
void remove_flat(TriMesh& mesh, std::vector<std::uint32_t>& opposite, Numbers* of, bool drop,
                 RepairCounts& counts, const RunContext& context);

/// Gives each fan of triangles around a vertex a vertex of its own.
void split_fans(TriMesh& mesh, const std::vector<std::uint32_t>& opposite, const EdgeGroups& edges,
                RepairCounts& counts);

/// Orients, splits and drops until `inspect` finds nothing.
void make_manifold(TriMesh& mesh, Numbers* of, Diagnostics& diagnostics, const RunContext& context);

/// Turns closed components that are inside out; needs a manifold mesh. `open` as `inspect` gives
/// it.
void orient_outwards(TriMesh& mesh, std::span<const std::uint8_t> open, Diagnostics& diagnostics,
                     const RunContext& context);

/// Removes positions that no triangle uses, order kept.
void drop_unused_positions(TriMesh& mesh);

}  // namespace burin::repair_stages
