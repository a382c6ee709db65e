#pragma once
// Normals of facets that are divided; internal to the module.

#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/rounded_mesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// A piece of a facet.
struct FacetPiece {
  Triangle corners;
  std::uint32_t facet;
  std::array<Vec3, 3> bary;
  bool settled = false;  // all edges are fine enough
};

/// Normals where facets were divided: those of the surface's own patches, so that contours run
/// where its triangles turn away, but linear over the facet where that is nearly the same: strips
/// of fillets then bend across alone. On edges and corners of facets they are linear where one of
/// the patches there has them so: a wide face is flat up to its border, whatever the fillet beyond
/// does. As they were where facets stay.
class FacetNormals {
 public:
  /// `pieces` in the order of their facets; `exact` as in `round_facets`. The mesh and its surface
  /// must outlive it.
  FacetNormals(const ProxyMesh& coarse, std::span<const std::uint8_t> exact,
               const RoundedMesh& surface, double tolerance, const std::vector<FacetPiece>& pieces);

  /// At the corners of a piece.
  std::array<Vec3, 3> of(const FacetPiece& piece) const;

 private:
  /// The normals of one place of a facet.
  struct Place {
    Vec3 patch, linear;
    /// From 0, where they are alike, to 1.
    double unlike = 0;
    bool same = false;
  };

  const Vec3* kept(std::uint32_t facet, Vec3 bary) const;
  void keep_linear();
  Place place(const RoundedFacet& facet, Vec3 bary) const;
  double strictness(std::uint32_t f) const;
  bool linear_beyond(std::uint32_t facet, Vec3 bary) const;
  Vec3 moved(const RoundedFacet& facet, Vec3 bary) const;

  const ProxyMesh& coarse_;
  const RoundedMesh& surface_;
  double tolerance_;
  /// For each wedge of the facets whether its normal is another.
  std::vector<std::uint8_t> moved_;
};

}  // namespace burin
