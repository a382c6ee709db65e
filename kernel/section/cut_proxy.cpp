#include "cut_proxy.h"

#include <burin/base/box.h>
#include <burin/mesh/compact.h>
#include <burin/mesh/facet_piece.h>

#include "cap/triangulate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace burin::detail {
namespace {

/// Of the diagonal: a vertex so near the plane lies on it. Coordinates of files are rounded to
/// 1e-7 of themselves.
constexpr double kOnPlane = 1e-6;

std::uint64_t key(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(a) << 32U | b;
}

/// Draws triangles on the near side of the plane.
class Cutter {
 public:
  Cutter(const ProxyMesh& whole, const CutPlane& plane, const RunContext& context)
      : whole_(whole), context_(context) {
    Box3 box;
    for (const Vec3& p : whole.mesh.positions) box.add(p);
    on_plane_ = kOnPlane * box.diagonal();
    height_.reserve(whole.mesh.positions.size());
    for (const Vec3& p : whole.mesh.positions) {
      height_.push_back(glm::dot(plane.normal, p) - plane.offset);
    }
  }

  bool anything_beyond() const {
    return std::ranges::any_of(height_, [&](double h) { return h > on_plane_; });
  }
  bool anything_left() const {
    return std::ranges::any_of(height_, [&](double h) { return h < -on_plane_; });
  }

  void run() {
    positions = whole_.mesh.positions;
    for (std::uint32_t f = 0; f < whole_.mesh.triangles.size(); ++f) {
      if (f % 65536 == 0) context_.check();
      cut(f);
    }
  }

  bool lies_on_plane(std::uint32_t vertex) const {
    return vertex >= height_.size() || std::abs(height_[vertex]) <= on_plane_;
  }

  std::vector<Vec3> positions;  // those of the whole, and the cut points
  std::vector<Triangle> triangles;
  std::vector<FacetPiece> pieces;

 private:
  struct Corner {
    std::uint32_t vertex;
    Vec3 bary;
  };

  /// What lies on the plane is beyond it.
  bool beyond(std::uint32_t vertex) const { return height_[vertex] >= -on_plane_; }

  void cut(std::uint32_t f) {
    const Triangle& t = whole_.mesh.triangles[f];
    std::array<Corner, 4> kept{};
    std::size_t n = 0;
    const auto add = [&](Corner c) {
      if (n == 0 || kept[n - 1].vertex != c.vertex) kept[n++] = c;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = (k + 1) % 3;
      if (!beyond(t[k])) add({t[k], unit(k)});
      if (beyond(t[k]) != beyond(t[j])) add(between(t, k, j));
    }
    if (n > 1 && kept[n - 1].vertex == kept[0].vertex) --n;
    if (n < 3) return;
    if (n == 3) return add_triangle(f, kept[0], kept[1], kept[2]);
    const auto at = [&](std::size_t i) { return positions[kept[i].vertex]; };
    if (glm::distance(at(0), at(2)) <= glm::distance(at(1), at(3))) {
      add_triangle(f, kept[0], kept[1], kept[2]);
      add_triangle(f, kept[0], kept[2], kept[3]);
    } else {
      add_triangle(f, kept[0], kept[1], kept[3]);
      add_triangle(f, kept[1], kept[2], kept[3]);
    }
  }

  static Vec3 unit(std::size_t k) {
    Vec3 bary(0);
    bary[static_cast<int>(k)] = 1;
    return bary;
  }

  /// Where the edge between two corners meets the plane: the one on it where that is one.
  Corner between(const Triangle& t, std::size_t k, std::size_t j) {
    const std::size_t far = beyond(t[k]) ? k : j;
    if (std::abs(height_[t[far]]) <= on_plane_) return {t[far], unit(far)};
    // From the lower vertex on, so that both triangles get the same point.
    const std::size_t low = t[k] < t[j] ? k : j, high = t[k] < t[j] ? j : k;
    const double share = height_[t[low]] / (height_[t[low]] - height_[t[high]]);
    const auto [entry, is_new] =
        points_.try_emplace(key(t[low], t[high]), static_cast<std::uint32_t>(positions.size()));
    if (is_new) {
      positions.push_back(
          glm::mix(whole_.mesh.positions[t[low]], whole_.mesh.positions[t[high]], share));
    }
    return {entry->second, glm::mix(unit(low), unit(high), share)};
  }

  void add_triangle(std::uint32_t f, const Corner& a, const Corner& b, const Corner& c) {
    triangles.push_back({a.vertex, b.vertex, c.vertex});
    pieces.push_back({f, {a.bary, b.bary, c.bary}});
  }

  const ProxyMesh& whole_;
  const RunContext& context_;
  double on_plane_ = 0;
  std::vector<double> height_;  // mm beyond the plane
  std::unordered_map<std::uint64_t, std::uint32_t> points_;
};

/// The edges on the plane beside which the other triangle is gone, as the triangle that closes them
/// has them.
std::vector<DirectedEdge> open_edges(const Cutter& cutter) {
  // In the order of the triangles, so that no hash decides about anything.
  std::vector<DirectedEdge> found;
  std::unordered_map<std::uint64_t, int> count;
  for (const Triangle& t : cutter.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (!cutter.lies_on_plane(a) || !cutter.lies_on_plane(b)) continue;
      ++count[key(a, b)];
      found.push_back({b, a});
    }
  }
  std::erase_if(found, [&](const DirectedEdge& e) { return count.contains(key(e[0], e[1])); });
  return found;
}

bool loops_close(const std::vector<DirectedEdge>& edges) {
  std::unordered_map<std::uint32_t, int> balance;
  for (const auto& [from, to] : edges) ++balance[from], --balance[to];
  return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
}

/// Two axes of the plane that make a right-handed system with its normal.
std::pair<Vec3, Vec3> axes_of(const CutPlane& plane) {
  const Vec3 u = any_orthogonal(plane.normal);
  return {u, glm::cross(plane.normal, u)};
}

/// Closes the loops; false where they do not.
bool close(Cutter& cutter, const CutPlane& plane) {
  const std::vector<DirectedEdge> edges = open_edges(cutter);
  if (edges.empty()) return true;
  if (!loops_close(edges)) return false;
  std::map<std::uint32_t, std::uint32_t> index;  // of the vertices that the loops have
  for (const auto& [from, to] : edges) index.try_emplace(from, 0);
  std::vector<std::uint32_t> vertices;
  std::vector<Vec2> points;
  const auto [u, v] = axes_of(plane);
  for (auto& [vertex, i] : index) {
    i = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(vertex);
    const Vec3& p = cutter.positions[vertex];
    points.emplace_back(glm::dot(u, p), glm::dot(v, p));
  }
  std::vector<DirectedEdge> inner;
  for (const auto& [from, to] : edges) inner.push_back({index.at(from), index.at(to)});
  const Triangulated area = triangulate(points, inner);
  for (const Vec2& p : area.added) {
    vertices.push_back(static_cast<std::uint32_t>(cutter.positions.size()));
    cutter.positions.push_back(p.x * u + p.y * v + plane.offset * plane.normal);
  }
  // Where solids touch, an edge may have its two triangles already: then the area stands beside
  // them on vertices of its own.
  std::unordered_map<std::uint64_t, int> taken;
  for (const Triangle& t : cutter.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cutter.lies_on_plane(t[k]) && cutter.lies_on_plane(t[(k + 1) % 3])) {
        ++taken[key(t[k], t[(k + 1) % 3])];
      }
    }
  }
  const bool clashes = std::ranges::any_of(area.triangles, [&](const auto& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (taken.contains(key(vertices[t[k]], vertices[t[(k + 1) % 3]]))) return true;
    }
    return false;
  });
  if (clashes) {
    for (std::uint32_t& vertex : vertices) {
      cutter.positions.push_back(Vec3(cutter.positions[vertex]));
      vertex = static_cast<std::uint32_t>(cutter.positions.size() - 1);
    }
  }
  for (const auto& t : area.triangles) {
    cutter.triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
    cutter.pieces.emplace_back();
  }
  return true;
}

/// Copies what is known of the facets to their pieces.
class Draft {
 public:
  Draft(const ProxyMesh& whole, const std::vector<FacetPiece>& pieces)
      : whole_(whole), pieces_(pieces) {}

  ProxyDraft make(TriMesh mesh, Vec3 normal) const {
    const std::size_t n = pieces_.size();
    ProxyDraft draft;
    draft.mesh = std::move(mesh);
    const std::unordered_map<std::uint64_t, int> closing = closing_edges(draft.mesh);
    draft.tolerance = whole_.tolerance;
    draft.corner_normal.resize(3 * n, normal);
    draft.sharp.resize(3 * n, 1);
    if (!whole_.on_contour.empty()) draft.corner_on_contour.resize(3 * n, 0);
    if (!whole_.source_face.empty()) {
      draft.source_face.resize(n, 1 + *std::ranges::max_element(whole_.source_face));
    }
    if (!whole_.source_edge.empty()) draft.source_edge.resize(3 * n, -1);
    if (!whole_.seam.empty()) draft.seam.resize(3 * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      const FacetPiece& piece = pieces_[i];
      if (piece.facet == kNoFacet) {
        // Sharp towards the others alone.
        const Triangle& t = draft.mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
          draft.sharp[3 * i + k] = !closing.contains(key(t[(k + 1) % 3], t[k]));
        }
        continue;
      }
      if (!draft.source_face.empty()) draft.source_face[i] = whole_.source_face[piece.facet];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& bary = piece.bary[k];
        draft.corner_normal[3 * i + k] = whole_.normal(piece.facet, bary);
        if (!draft.corner_on_contour.empty()) {
          draft.corner_on_contour[3 * i + k] = on_contour(piece.facet, bary);
        }
        const auto edge = facet_edge(piece.bary, k);
        const auto h = edge ? 3 * std::size_t{piece.facet} + *edge : 0;
        draft.sharp[3 * i + k] = edge && whole_.is_crease(static_cast<HalfEdge>(h));
        if (edge && !draft.source_edge.empty())
          draft.source_edge[3 * i + k] = whole_.source_edge[h];
        if (edge && !draft.seam.empty()) draft.seam[3 * i + k] = whole_.seam[h];
      }
    }
    return draft;
  }

 private:
  /// The directed edges of the triangles that close the cut.
  std::unordered_map<std::uint64_t, int> closing_edges(const TriMesh& mesh) const {
    std::unordered_map<std::uint64_t, int> edges;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i].facet != kNoFacet) continue;
      const Triangle& t = mesh.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) edges[key(t[k], t[(k + 1) % 3])] = 1;
    }
    return edges;
  }

  std::uint8_t on_contour(std::uint32_t facet, Vec3 bary) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool counts = bary[static_cast<int>(k)] > 0;
      if (counts && !whole_.on_contour[whole_.wedges[facet][k]]) return 0;
    }
    return 1;
  }

  const ProxyMesh& whole_;
  const std::vector<FacetPiece>& pieces_;
};

}  // namespace

CutProxy cut_proxy(const ProxyMesh& whole, const CutPlane& plane, std::int32_t number,
                   const RunContext& context) {
  CutProxy out;
  Cutter cutter(whole, plane, context);
  out.whole = !cutter.anything_beyond();
  if (out.whole) return out;
  out.gone = !cutter.anything_left();
  if (out.gone) return out;
  cutter.run();
  out.open = !close(cutter, plane);
  TriMesh mesh{std::move(cutter.positions), std::move(cutter.triangles)};
  compact(mesh.positions, mesh.triangles);
  out.pieces = std::move(cutter.pieces);
  out.proxy = assemble_proxy(Draft(whole, out.pieces).make(std::move(mesh), plane.normal), context);
  if (whole.on_contour.empty()) out.proxy.on_contour.clear();
  out.proxy.cut_plane.assign(static_cast<std::size_t>(out.proxy.region_count), -1);
  for (std::size_t i = 0; i < out.pieces.size(); ++i) {
    const std::uint32_t facet = out.pieces[i].facet;
    std::int32_t& plane_of =
        out.proxy.cut_plane[static_cast<std::size_t>(out.proxy.face_region[i])];
    if (facet == kNoFacet) {
      plane_of = number;
    } else if (!whole.cut_plane.empty()) {
      plane_of = whole.cut_plane[static_cast<std::size_t>(whole.face_region[facet])];
    }
  }
  return out;
}

}  // namespace burin::detail
