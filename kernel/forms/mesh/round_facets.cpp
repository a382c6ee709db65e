#include "round_facets.h"

#include <burin/base/parallel.h>
#include <burin/mesh/facet_piece.h>
#include <burin/mesh/rounded_mesh.h>
#include <burin/mesh/tips.h>
#include <burin/work_mesh/division.h>

#include "facet_normals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace burin {

namespace {

/// Halvings of one edge: a bulge falls to a quarter with each, and RoundedMesh allows none of more
/// than a seventh of the edge.
constexpr int kMostPasses = 8;
/// Times the tolerance from which on a bulge that is left is told: forms ask for half of what
/// shows.
constexpr double kTold = 2;
constexpr std::size_t kFacetGrain = 4096;
constexpr std::size_t next(std::size_t k) { return (k + 1) % 3; }

FacetPiece whole(const ProxyMesh& coarse, std::uint32_t facet) {
  return {coarse.mesh.triangles[facet], facet, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}};
}

/// Model mm by which the surface may leave the longest edge of a facet: an upper bound, cheaply.
double most_bulge(const ProxyMesh& proxy, std::uint32_t f) {
  const Triangle& w = proxy.wedges[f];
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = w[k], b = w[next(k)];
    const Vec3 edge = proxy.wedge_position(b) - proxy.wedge_position(a);
    // A crease may turn in the plane of the facet.
    if (proxy.is_crease(static_cast<HalfEdge>(3 * f + k))) return glm::length(edge);
    most = std::max(most, std::abs(glm::dot(proxy.wedge_normal[a], edge)) +
                              std::abs(glm::dot(proxy.wedge_normal[b], edge)));
  }
  return most / 4;  // t (1-t) of the lifts
}

/// The facets that may be too coarse; an edge of one that is, is that of two of them.
std::vector<FacetPiece> coarse_facets(const ProxyMesh& coarse, std::span<const std::uint8_t> exact,
                                      double tolerance) {
  std::vector<FacetPiece> found;
  for (std::uint32_t f = 0; f < coarse.mesh.triangles.size(); ++f) {
    if (!exact.empty() && exact[f] != 0) continue;
    if (most_bulge(coarse, f) > tolerance) found.push_back(whole(coarse, f));
  }
  return found;
}

class Divider {
 public:
  Divider(const ProxyMesh& coarse, std::vector<FacetPiece> facets,
          std::span<const std::uint8_t> exact, double tolerance, const RunContext& context)
      : coarse_(coarse),
        surface_(coarse, exact),
        tolerance_(tolerance),
        context_(context),
        pieces_(std::move(facets)) {}

  /// Whether anything was divided, and whether it stopped before all was fine enough. At most
  /// `most` pieces are made.
  bool run(std::size_t most, bool& cut_short) {
    const std::size_t limit = pieces_.size() + most;
    bool any = false;
    for (int pass = 0;; ++pass) {
      const std::vector<std::uint8_t> marks = mark();
      std::size_t more = 0;
      for (const std::uint8_t m : marks) more += static_cast<std::size_t>(std::popcount(m));
      if (more == 0) return any;
      if (pass == kMostPasses || pieces_.size() + more > limit) {
        tolerance_ *= kTold;
        const std::vector<std::uint8_t> seen = mark();
        cut_short = std::ranges::any_of(seen, [](std::uint8_t m) { return m != 0; });
        return any;
      }
      divide(marks, more);
      any = true;
    }
  }

  /// In the order of their facets.
  double tolerance() const { return tolerance_; }
  const std::vector<FacetPiece>& pieces() const { return pieces_; }
  /// Those of the mesh, and the ones that were made.
  std::vector<Vec3> positions() const {
    std::vector<Vec3> out = coarse_.mesh.positions;
    out.insert(out.end(), made_.begin(), made_.end());
    return out;
  }
  const RoundedMesh& surface() const { return surface_; }

 private:
  /// The surface at a share of the k-th edge of a piece, from the lower vertex on; the same bits
  /// for both its triangles.
  Vec3 at(const RoundedFacet& facet, const FacetPiece& piece, std::size_t k, double share) const {
    std::size_t i = k, j = next(k);
    if (piece.corners[i] > piece.corners[j]) std::swap(i, j);
    const Vec3 bary = (1 - share) * piece.bary[i] + share * piece.bary[j];
    const auto edge = facet_edge(piece.bary, k);
    if (!edge) return facet.at(bary);
    // From the lower vertex on, as `on_edge` counts.
    const Triangle& corners = coarse_.mesh.triangles[piece.facet];
    const std::size_t high = corners[*edge] < corners[next(*edge)] ? next(*edge) : *edge;
    return facet.on_edge(*edge, bary[static_cast<int>(high)]);
  }

  const Vec3& position(std::uint32_t vertex) const {
    const std::vector<Vec3>& given = coarse_.mesh.positions;
    return vertex < given.size() ? given[vertex] : made_[vertex - given.size()];
  }

  bool bulges(const RoundedFacet& facet, const FacetPiece& piece, std::size_t k) const {
    const auto [low, high] = std::minmax(piece.corners[k], piece.corners[next(k)]);
    const Vec3 &p = position(low), &q = position(high);
    // An S lies on its chord in the middle.
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec3 off = at(facet, piece, k, share) - glm::mix(p, q, share);
      if (glm::dot(off, off) > tolerance_ * tolerance_) return true;
    }
    return false;
  }

  std::vector<std::uint8_t> mark() {
    std::vector<std::uint8_t> marks(pieces_.size(), 0);
    parallel_for(
        pieces_.size(), kFacetGrain,
        [&](std::size_t begin, std::size_t end) {
          std::optional<RoundedFacet> facet;  // the pieces of one follow each other
          for (std::size_t i = begin; i < end; ++i) {
            FacetPiece& piece = pieces_[i];
            if (piece.settled) continue;
            if (!facet || facet->face() != piece.facet) facet = surface_.facet(piece.facet);
            for (std::size_t k = 0; k < 3; ++k) {
              if (bulges(*facet, piece, k)) marks[i] |= static_cast<std::uint8_t>(1U << k);
            }
            piece.settled = marks[i] == 0;
          }
        },
        &context_);
    return marks;
  }

  std::uint32_t middle(const FacetPiece& piece, std::size_t k) {
    const auto [low, high] = std::minmax(piece.corners[k], piece.corners[next(k)]);
    const auto [entry, added] = middles_.try_emplace(
        static_cast<std::uint64_t>(low) << 32U | high,
        static_cast<std::uint32_t>(coarse_.mesh.positions.size() + made_.size()));
    if (added) made_.push_back(at(surface_.facet(piece.facet), piece, k, 0.5));
    return entry->second;
  }

  void divide(const std::vector<std::uint8_t>& marks, std::size_t more) {
    std::vector<FacetPiece> out;
    out.reserve(pieces_.size() + more);
    middles_.clear();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (i % kFacetGrain == 0) context_.check();
      divide(pieces_[i], marks[i], out);
    }
    pieces_ = std::move(out);
  }

  void divide(const FacetPiece& piece, std::uint8_t marks, std::vector<FacetPiece>& out) {
    if (marks == 0) {
      out.push_back(piece);
      return;
    }
    std::array<std::uint32_t, 6> vertex{};
    std::array<Vec3, 6> bary{}, points{};
    for (std::size_t k = 0; k < 3; ++k) {
      vertex[k] = piece.corners[k], bary[k] = piece.bary[k], points[k] = position(vertex[k]);
      if (!(marks >> k & 1U)) continue;
      vertex[3 + k] = middle(piece, k);
      bary[3 + k] = 0.5 * (piece.bary[k] + piece.bary[next(k)]);
      points[3 + k] = position(vertex[3 + k]);
    }
    for (const auto& [a, b, c] : burin::divide(marks, points)) {
      out.push_back({{vertex[a], vertex[b], vertex[c]}, piece.facet, {bary[a], bary[b], bary[c]}});
    }
  }

  const ProxyMesh& coarse_;
  RoundedMesh surface_;
  double tolerance_;
  const RunContext& context_;
  std::vector<FacetPiece> pieces_;
  std::vector<Vec3> made_;
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

/// Whether the k-th edge of a piece lies on a crease of the facets.
bool on_crease(const ProxyMesh& coarse, const FacetPiece& piece, std::size_t k) {
  const auto edge = facet_edge(piece.bary, k);
  return edge && coarse.is_crease(static_cast<HalfEdge>(3 * piece.facet + *edge));
}

/// The triangles of the new mesh: facets, and the pieces of those that were divided.
class DivisionLayout {
 public:
  DivisionLayout(const ProxyMesh& coarse, const std::vector<FacetPiece>& pieces)
      : coarse_(coarse), pieces_(pieces), first_(coarse.mesh.triangles.size() + 1, 1) {
    first_[0] = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (pieces[i].facet == pieces[i - 1].facet) ++first_[pieces[i].facet + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  std::size_t size() const { return first_.back(); }
  /// Calls `work(number of the triangle, Piece)` for all of them, in order.
  template <class Work>
  void each(const Work& work) const {
    each(0, coarse_.mesh.triangles.size(), work);
  }
  /// The same from many threads.
  template <class Work>
  void each(const RunContext& context, const Work& work) const {
    parallel_for(
        coarse_.mesh.triangles.size(), kFacetGrain,
        [&](std::size_t begin, std::size_t end) { each(begin, end, work); }, &context);
  }

 private:
  template <class Work>
  void each(std::size_t begin, std::size_t end, const Work& work) const {
    auto piece = std::ranges::lower_bound(pieces_, begin, {}, &FacetPiece::facet);
    for (std::size_t f = begin; f < end; ++f) {
      std::size_t i = first_[f];
      if (piece == pieces_.end() || piece->facet != f) {
        work(i, whole(coarse_, static_cast<std::uint32_t>(f)));
      }
      for (; piece != pieces_.end() && piece->facet == f; ++piece) work(i++, *piece);
    }
  }

  const ProxyMesh& coarse_;
  const std::vector<FacetPiece>& pieces_;
  std::vector<std::uint32_t> first_;
};

/// What a proxy knows of its source, by triangles and half-edges.
void copy_source(const ProxyMesh& coarse, const DivisionLayout& layout, ProxyDraft& draft) {
  if (coarse.source_face.empty() && coarse.source_edge.empty()) return;
  draft.source_face.assign(coarse.source_face.empty() ? 0 : layout.size(), -1);
  draft.source_edge.assign(coarse.source_edge.empty() ? 0 : 3 * layout.size(), -1);
  draft.seam.assign(coarse.seam.empty() ? 0 : 3 * layout.size(), 0);
  layout.each([&](std::size_t i, const FacetPiece& piece) {
    if (!draft.source_face.empty()) draft.source_face[i] = coarse.source_face[piece.facet];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = facet_edge(piece.bary, k);
      if (!edge) continue;
      const std::size_t h = 3 * std::size_t{piece.facet} + *edge;
      if (!draft.source_edge.empty()) draft.source_edge[3 * i + k] = coarse.source_edge[h];
      if (!draft.seam.empty()) draft.seam[3 * i + k] = coarse.seam[h];
    }
  });
}

ProxyDraft draft_of(const ProxyMesh& coarse, std::span<const std::uint8_t> exact,
                    const Divider& divider, const DivisionLayout& layout,
                    const RunContext& context) {
  ProxyDraft draft;
  draft.mesh.positions = divider.positions();
  draft.mesh.triangles.resize(layout.size());
  draft.corner_normal.resize(3 * layout.size());
  draft.sharp.resize(3 * layout.size());
  draft.tolerance = coarse.tolerance;
  copy_source(coarse, layout, draft);
  const FacetNormals normals(coarse, exact, divider.surface(), divider.tolerance(),
                             divider.pieces());
  layout.each(context, [&](std::size_t i, const FacetPiece& piece) {
    draft.mesh.triangles[i] = piece.corners;
    const std::array<Vec3, 3> normal = normals.of(piece);
    for (std::size_t k = 0; k < 3; ++k) {
      draft.corner_normal[3 * i + k] = normal[k];
      draft.sharp[3 * i + k] = on_crease(coarse, piece, k);
    }
  });
  return draft;
}

/// Parts the wedges of the new mesh at the tips of the facets, as theirs are parted.
void part_tips(ProxyMesh& proxy, const ProxyMesh& coarse, const DivisionLayout& layout,
               const std::vector<std::uint8_t>& tips, const std::vector<Vec3>& corner_normal) {
  std::vector<std::uint32_t> label(corner_normal.size(), 0);
  layout.each([&](std::size_t i, const FacetPiece& piece) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (piece.bary[corner][static_cast<int>(k)] != 1) continue;
        const std::uint32_t w = coarse.wedges[piece.facet][k];
        if (tips[w]) label[3 * i + corner] = w;
      }
    }
  });
  part_wedges(proxy, label, [&](HalfEdge h) { return corner_normal[static_cast<std::size_t>(h)]; });
  layout.each([&](std::size_t i, const FacetPiece& piece) {
    const auto k = corner_beside_tips(tips, coarse.wedges[piece.facet]);
    if (!k) return;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (piece.bary[corner][static_cast<int>(*k)] != 1) continue;
      proxy.wedge_normal[proxy.wedges[i][corner]] =
          coarse.wedge_normal[coarse.wedges[piece.facet][*k]];
    }
  });
}

}  // namespace

std::optional<RoundedFacets> round_facets(const ProxyMesh& coarse, double tolerance,
                                          std::size_t most, const RunContext& context,
                                          std::span<const std::uint8_t> exact) {
  std::vector<FacetPiece> facets = coarse_facets(coarse, exact, tolerance);
  if (facets.empty()) return std::nullopt;
  RoundedFacets out;
  Divider divider(coarse, std::move(facets), exact, tolerance, context);
  if (!divider.run(most, out.cut_short)) return std::nullopt;
  const DivisionLayout layout(coarse, divider.pieces());
  ProxyDraft draft = draft_of(coarse, exact, divider, layout, context);
  const std::vector<std::uint8_t> tips = wedges_at_tips(coarse);
  const std::vector<Vec3> corner_normal = tips.empty() ? std::vector<Vec3>() : draft.corner_normal;
  out.proxy = assemble_proxy(std::move(draft), context);
  out.proxy.on_contour.clear();  // it was cut for no view
  if (!tips.empty()) part_tips(out.proxy, coarse, layout, tips, corner_normal);
  out.wedge_origin.resize(out.proxy.wedge_vertex.size());
  out.face_origin.resize(layout.size());
  layout.each([&](std::size_t i, const FacetPiece& piece) {
    out.face_origin[i] = piece.facet;
    for (std::size_t k = 0; k < 3; ++k) {
      out.wedge_origin[out.proxy.wedges[i][k]] = {piece.facet, piece.bary[k]};
    }
  });
  return out;
}

}  // namespace burin
