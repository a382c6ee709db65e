#pragma once
// Triangles of an implicit surface under way to its proxy.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/implicit/implicit_function.h>
#include <burin/mesh/tri_mesh.h>

#include "../function/work.h"
#include "surface_nets.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

/// The pieces that meet at a vertex on a crease, with their unit normals there.
struct CreaseVertex {
  struct Side {
    const ImplicitFunction* piece = nullptr;
    Vec3 normal{0};
    bool zero = false;  // this side's g is zero here, see cut_for_view
  };
  std::vector<Side> sides;
};

struct ExactMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// For each vertex its unit normal (one of them on creases), the name of its piece, and its entry
  /// in `creases` (-1 = none).
  std::vector<Vec3> normals;
  std::vector<std::uint64_t> pieces;
  std::vector<std::int32_t> crease;
  std::vector<CreaseVertex> creases;
  /// A vertex that is on no crease: nonzero where g is zero.
  std::vector<std::uint8_t> zero;
  /// A triangle that touches a crease: the piece it belongs to; nullptr elsewhere.
  std::vector<const ImplicitFunction*> side;
  /// Edge length of the grid, the size of the surface, and how near to f = 0 vertices have to be,
  /// in model mm.
  double step = 1, size = 1, accuracy = 1e-11;
  /// Graded meshes: the length of the edges around each vertex of those that were there first;
  /// `step` is then that of most edges. Empty: `step` everywhere.
  std::vector<double> spacing;
  /// Boxes of components smaller than half a step, which were left out.
  std::vector<Box3> chips;
  /// What may still be done to it.
  WorkBudget budget{10e9};

  bool on_crease(std::uint32_t v) const { return crease[v] >= 0; }
  double step_at(std::uint32_t v) const { return v < spacing.size() ? spacing[v] : step; }
  std::uint32_t add_vertex(Vec3 position, Vec3 normal, std::uint64_t piece);
  std::uint32_t add_crease_vertex(Vec3 position, CreaseVertex sides);
  /// The side of a crease vertex that triangle t lies on.
  const CreaseVertex::Side& side_at(std::size_t t, std::uint32_t v) const;
  /// The unit normal at corner k of triangle t, on its side, and whether g is zero there.
  Vec3 corner_normal(std::size_t t, std::size_t k) const;
  bool corner_zero(std::size_t t, std::size_t k) const;
};

/// New vertices on edges, found by the two ends of the edge.
class EdgePoints {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;
  void add(std::uint32_t u, std::uint32_t v, std::uint32_t point) {
    points_.push_back({key(u, v), point});
  }
  void sort();
  std::uint32_t find(std::uint32_t u, std::uint32_t v) const;
  bool empty() const { return points_.empty(); }

 private:
  static std::uint64_t key(std::uint32_t u, std::uint32_t v) {
    return (static_cast<std::uint64_t>(std::min(u, v)) << 32) | std::max(u, v);
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> points_;
};

/// Cuts every triangle at the points on its edges; `center(t)` gives the vertex inside triangle t
/// where three of its edges have points, or kNone for none. Parts of a triangle keep its side.
void cut_at_points(ExactMesh& mesh, const EdgePoints& points,
                   const std::function<std::uint32_t(std::size_t)>& center);

/// Flips the longest edges of triangles with a crease vertex that have next to no height.
void flip_slivers(ExactMesh& mesh);

/// Draws vertices that lie on no line (crease, contour) onto the line at the end of an edge that is
/// shorter than `limit` steps, where that folds nothing: cutting leaves slivers.
void collapse_slivers(ExactMesh& mesh, const ImplicitFunction& f, double limit,
                      const RunContext& context);

/// Nets moved onto the surface, cut into triangles along the shorter diagonals; vertices of cells
/// in which pieces meet at an angle are put on the crease or the corner. Counts vertices that could
/// not be brought to the surface.
ExactMesh project_nets(const ImplicitFunction& f, Nets nets, const GridLayout& layout, double size,
                       const WorkBudget& budget, std::size_t& stray, const RunContext& context);

/// A point where pieces of f meet at an angle.
struct Meeting {
  Vec3 position{0};
  CreaseVertex sides;
};
/// The point of the crease between pieces i and j next to p, at most `reach` away; where a third
/// piece covers it, their corner.
std::optional<Meeting> find_crease(const ExactMesh& mesh, const ImplicitFunction& f,
                                   const ImplicitFunction& i, const ImplicitFunction& j, Vec3 p,
                                   double reach);
std::optional<Meeting> find_corner(const ExactMesh& mesh, const ImplicitFunction& f,
                                   const ImplicitFunction& i, const ImplicitFunction& j,
                                   const ImplicitFunction& k, Vec3 p, double reach);

/// Cuts the triangles along the curves where pieces meet at an angle; vertices are put on them.
void cut_along_creases(ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context);

}  // namespace burin
