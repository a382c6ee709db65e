#include "facet_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace burin {

namespace {

/// Radians between a patch's normal and that which is linear over the facet: up to the first they
/// are alike, from the second on not; less where facets bend little for their size.
constexpr double kAlike = 0.035, kUnlike = 0.087;
/// Radians within which they are the same: cubics over the strips of a cylinder are off by less.
constexpr double kSame = 0.01;
/// Of the tolerance: how far aside a normal that is taken as alike may move a contour.
constexpr double kAside = 0.5;

/// For each wedge of the facets whether one around it was divided, and none is exact.
std::vector<std::uint8_t> touched(const ProxyMesh& coarse, std::span<const std::uint8_t> exact,
                                  const std::vector<FacetPiece>& pieces) {
  std::vector<std::uint8_t> out(coarse.wedge_vertex.size(), 0);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].facet != pieces[i - 1].facet) continue;
    for (const std::uint32_t w : coarse.wedges[pieces[i].facet]) out[w] = 1;
  }
  for (std::size_t f = 0; f < exact.size(); ++f) {
    if (exact[f] == 0) continue;
    for (const std::uint32_t w : coarse.wedges[f]) out[w] = 0;
  }
  return out;
}

}  // namespace

FacetNormals::FacetNormals(const ProxyMesh& coarse, std::span<const std::uint8_t> exact,
                           const RoundedMesh& surface, double tolerance,
                           const std::vector<FacetPiece>& pieces)
    : coarse_(coarse),
      surface_(surface),
      tolerance_(tolerance),
      moved_(touched(coarse, exact, pieces)) {
  keep_linear();
}

std::array<Vec3, 3> FacetNormals::of(const FacetPiece& piece) const {
  std::array<Vec3, 3> out;
  std::optional<RoundedFacet> facet;
  for (std::size_t k = 0; k < 3; ++k) {
    if (const Vec3* normal = kept(piece.facet, piece.bary[k])) {
      out[k] = *normal;
      continue;
    }
    if (!facet) facet = surface_.facet(piece.facet);
    out[k] = moved(*facet, piece.bary[k]);
  }
  return out;
}

/// The normal of a corner of a facet that stays, else null.
const Vec3* FacetNormals::kept(std::uint32_t facet, Vec3 bary) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t w = coarse_.wedges[facet][k];
    if (bary[static_cast<int>(k)] == 1 && moved_[w] == 0) return &coarse_.wedge_normal[w];
  }
  return nullptr;
}

/// Corners where a patch has the normal of the mesh.
void FacetNormals::keep_linear() {
  const std::vector<std::uint8_t> touched = moved_;
  for (std::uint32_t f = 0; f < coarse_.wedges.size(); ++f) {
    std::optional<RoundedFacet> facet;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t w = coarse_.wedges[f][k];
      if (touched[w] == 0 || moved_[w] == 0) continue;
      if (!facet) facet = surface_.facet(f);
      Vec3 corner(0);
      corner[static_cast<int>(k)] = 1;
      if (place(*facet, corner).same) moved_[w] = 0;
    }
  }
}

/// Share of kAlike and kUnlike that holds for a facet. A normal that is off by an angle moves a
/// contour along the surface by the angle times its radius, and aside by half the angle of that.
double FacetNormals::strictness(std::uint32_t f) const {
  const Triangle& w = coarse_.wedges[f];
  double bend = 0;  // squared, a mm
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = w[k], b = w[(k + 1) % 3];
    const Vec3 edge = coarse_.wedge_position(b) - coarse_.wedge_position(a);
    const Vec3 change = coarse_.wedge_normal[b] - coarse_.wedge_normal[a];
    bend = std::max(bend, glm::dot(change, change) / std::max(glm::dot(edge, edge), 1e-300));
  }
  const double alike = std::sqrt(2 * kAside * tolerance_ * std::sqrt(bend));
  return std::clamp(alike / kAlike, 1e-6, 1.0);
}

FacetNormals::Place FacetNormals::place(const RoundedFacet& facet, Vec3 bary) const {
  const Vec3 flat = coarse_.mesh.normal(facet.face());
  Place out{normalize_or(facet.normal_at(bary), flat), coarse_.normal(facet.face(), bary)};
  if (glm::dot(out.patch, flat) <= 0) out.patch = flat;  // folded over
  const double angle = std::acos(std::min(glm::dot(out.linear, out.patch), 1.0));
  out.same = angle <= kSame;
  if (out.same) return out;
  const double strict = strictness(facet.face());
  out.unlike = std::clamp((angle - strict * kAlike) / (strict * (kUnlike - kAlike)), 0.0, 1.0);
  return out;
}

/// Whether a place lies on a smooth edge of a facet whose patch on the other side is linear there.
bool FacetNormals::linear_beyond(std::uint32_t facet, Vec3 bary) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (bary[static_cast<int>(k)] != 0) continue;
    const std::size_t h = 3 * std::size_t{facet} + (k + 1) % 3;
    if (coarse_.edge_kind[h] != EdgeKind::Smooth) return false;
    const HalfEdge o = coarse_.topology.opposite[h];
    // Its ends there, in the order of the other side.
    const auto from = static_cast<std::size_t>(o % 3);
    Vec3 there(0);
    there[static_cast<int>(from)] = bary[static_cast<int>((k + 2) % 3)];
    there[static_cast<int>((from + 1) % 3)] = bary[static_cast<int>((k + 1) % 3)];
    return place(surface_.facet(face_of(o)), there).same;
  }
  return false;
}

Vec3 FacetNormals::moved(const RoundedFacet& facet, Vec3 bary) const {
  const Place here = place(facet, bary);
  if (here.unlike > 0 && linear_beyond(facet.face(), bary)) return here.linear;
  return normalize_or(glm::mix(here.linear, here.patch, here.unlike), here.patch);
}

}  // namespace burin
