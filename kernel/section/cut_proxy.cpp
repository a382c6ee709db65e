#include "cut_proxy.h"

#include <burin/mesh/compact.h>
#include <burin/mesh/facet_piece.h>

#include "cutter.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace burin::detail {
namespace {

/// Copies what is known of the facets to their pieces.
class Draft {
 public:
  Draft(const ProxyMesh& whole, const CutRegion& region, const std::vector<FacetPiece>& pieces)
      : whole_(whole), region_(region), pieces_(pieces) {}

  ProxyDraft make(TriMesh mesh) const {
    const std::size_t n = pieces_.size();
    ProxyDraft draft;
    draft.mesh = std::move(mesh);
    const std::unordered_map<std::uint64_t, std::int32_t> closing = closing_edges(draft.mesh);
    draft.tolerance = whole_.tolerance;
    draft.corner_normal.resize(3 * n);
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
        if (!draft.source_face.empty()) draft.source_face[i] += piece.plane;
        // Sharp towards all but those that close the same plane.
        const Triangle& t = draft.mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
          draft.corner_normal[3 * i + k] = region_[static_cast<std::size_t>(piece.plane)].normal;
          const auto other = closing.find(edge_key(t[(k + 1) % 3], t[k]));
          draft.sharp[3 * i + k] = other == closing.end() || other->second != piece.plane;
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
  std::unordered_map<std::uint64_t, std::int32_t> closing_edges(const TriMesh& mesh) const {
    std::unordered_map<std::uint64_t, std::int32_t> edges;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i].facet != kNoFacet) continue;
      const Triangle& t = mesh.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) edges[edge_key(t[k], t[(k + 1) % 3])] = pieces_[i].plane;
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
  const CutRegion& region_;
  const std::vector<FacetPiece>& pieces_;
};

/// Which plane each smooth region closes; cuts of before keep theirs.
std::vector<std::int32_t> cut_planes(const ProxyMesh& whole, const CutProxy& cut,
                                     std::int32_t number) {
  std::vector<std::int32_t> planes(static_cast<std::size_t>(cut.proxy.region_count), -1);
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
    const FacetPiece& piece = cut.pieces[i];
    std::int32_t& plane = planes[static_cast<std::size_t>(cut.proxy.face_region[i])];
    if (piece.facet == kNoFacet) {
      plane = number + piece.plane;
    } else if (!whole.cut_plane.empty()) {
      plane = whole.cut_plane[static_cast<std::size_t>(whole.face_region[piece.facet])];
    }
  }
  return planes;
}

}  // namespace

CutProxy cut_proxy(const Surface& surface, const CutRegion& region, std::int32_t number,
                   const RunContext& context) {
  CutProxy out;
  const ProxyMesh& whole = surface.proxy();
  Cutter::Lift lift;
  if (surface.exact()) {
    lift = [&](std::uint32_t facet, Vec3 bary) {
      const Frame frame = surface.frame(surface.lift({facet, bary}));
      return Cutter::Lifted{frame.position, frame.normal};
    };
  }
  Cutter cutter(whole.mesh, std::move(lift), context);
  for (std::size_t i = 0; i < region.size(); ++i) {
    cutter.cut(region[i], static_cast<std::int32_t>(i), i + 1 == region.size());
  }
  out.whole = cutter.whole();
  if (out.whole) return out;
  out.gone = cutter.gone();
  if (out.gone) return out;
  out.open = cutter.open();
  TriMesh mesh;
  for (CutTriangle& t : cutter.result()) {
    mesh.triangles.push_back(t.corners);
    out.pieces.push_back(t.piece);
  }
  mesh.positions = std::move(cutter.positions);
  compact(mesh.positions, mesh.triangles);
  out.proxy = assemble_proxy(Draft(whole, region, out.pieces).make(std::move(mesh)), context);
  if (whole.on_contour.empty()) out.proxy.on_contour.clear();
  out.proxy.cut_plane = cut_planes(whole, out, number);
  return out;
}

}  // namespace burin::detail
