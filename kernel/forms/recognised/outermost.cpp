#include "outermost.h"

#include "refine.h"

#include <algorithm>
#include <cstdint>

namespace burin::recognised {
namespace {

// Sagittas that a surface may lie beyond the corners of a facet: two and some more where it meets
// others.
constexpr double kOutermostReach = 8;

class Outermost {
 public:
  Outermost(const Box3& box, const Mat3& axes, const TriMesh& mesh, const Recognised& round,
            const Facets& facets)
      : box_(box), axes_(axes), mesh_(mesh), round_(round), facets_(facets) {
    const Mat3 rows = glm::transpose(axes);
    for (int k = 0; k < 3; ++k) stretch_[k] = glm::length(rows[k]);
  }

  /// What may stick out, with all around it: corners are placed on all surfaces that meet there.
  /// The faces of the mesh are 1 and 0.
  FacetMesh triangles() const {
    const std::size_t n = mesh_.triangles.size();
    std::vector<std::uint8_t> out_here(n, 0), at_corner(mesh_.positions.size(), 0);
    for (std::size_t t = 0; t < n; ++t) {
      if (!may_stick_out(t)) continue;
      out_here[t] = 1;
      for (const std::uint32_t v : mesh_.triangles[t]) at_corner[v] = 1;
    }
    FacetMesh out;
    std::vector<std::int32_t> number(mesh_.positions.size(), -1);
    for (std::size_t t = 0; t < n; ++t) {
      Triangle tri = mesh_.triangles[t];
      if (std::ranges::none_of(tri, [&](std::uint32_t v) { return at_corner[v] != 0; })) continue;
      for (std::uint32_t& v : tri) {
        if (number[v] < 0) {
          number[v] = static_cast<std::int32_t>(out.mesh.positions.size());
          out.mesh.positions.push_back(mesh_.positions[v]);
        }
        v = static_cast<std::uint32_t>(number[v]);
      }
      out.mesh.triangles.push_back(tri);
      out.patch.push_back(patch_of(t));
      out.facet.push_back(facets_.of[t]);
      out.face.push_back(out_here[t]);
    }
    out.edge.assign(3 * out.mesh.triangles.size(), -1);
    out.normal.assign(3 * out.mesh.triangles.size(), Vec3(0));
    return out;
  }

 private:
  std::int32_t patch_of(std::size_t t) const {
    return round_.patch_of[static_cast<std::size_t>(facets_.of[t])];
  }

  bool may_stick_out(std::size_t t) const {
    if (patch_of(t) < 0) return false;
    const Vec3 reach =
        kOutermostReach * round_.patches[static_cast<std::size_t>(patch_of(t))].sagitta * stretch_;
    return std::ranges::any_of(mesh_.triangles[t], [&](std::uint32_t v) {
      const Vec3 p = axes_ * mesh_.positions[v];
      for (int k = 0; k < 3; ++k) {
        if (p[k] - reach[k] < box_.min[k] || p[k] + reach[k] > box_.max[k]) return true;
      }
      return false;
    });
  }

  const Box3& box_;
  const Mat3& axes_;
  const TriMesh& mesh_;
  const Recognised& round_;
  const Facets& facets_;
  /// What a mm becomes along each axis.
  Vec3 stretch_{1};
};

}  // namespace

void add_outermost(Box3& box, const Mat3& axes, const TriMesh& mesh, const Recognised& round,
                   const Facets& facets, double tolerance, const RunContext& context) {
  FacetMesh finer = Outermost(box, axes, mesh, round, facets).triangles();
  if (finer.mesh.triangles.empty()) return;
  const std::size_t corners = finer.mesh.positions.size();
  refine(finer, round, facets, tolerance, context);
  for (std::size_t t = 0; t < finer.mesh.triangles.size(); ++t) {
    if (finer.face[t] == 0) continue;
    for (const std::uint32_t v : finer.mesh.triangles[t]) {
      if (v >= corners) box.add(axes * finer.mesh.positions[v]);
    }
  }
}

}  // namespace burin::recognised
