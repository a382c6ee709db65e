#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>
#include <burin_test/jets.h>

#include <algorithm>
#include <set>

namespace burin::test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Fit = CGAL::Monge_via_jet_fitting<Kernel>;

Vec3 to_vec(const Kernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

std::vector<Curvature> jet_curvature(const ProxyMesh& proxy) {
  std::vector<std::set<std::uint32_t>> neighbours(proxy.mesh.positions.size());
  for (const Triangle& t : proxy.mesh.triangles) {
    for (const std::uint32_t a : t) {
      for (const std::uint32_t b : t) neighbours[a].insert(b);
    }
  }
  std::vector<Curvature> result(neighbours.size());
  for (std::uint32_t v = 0; v < result.size(); ++v) {
    std::set<std::uint32_t> ring = {v};
    for (int i = 0; i < 3; ++i) {
      for (const std::uint32_t w : std::set<std::uint32_t>(ring)) {
        ring.insert(neighbours[w].begin(), neighbours[w].end());
      }
    }
    std::vector<Kernel::Point_3> points;
    const auto add = [&](std::uint32_t w) {
      const Vec3& p = proxy.mesh.positions[w];
      points.emplace_back(p.x, p.y, p.z);
    };
    add(v);  // the point of the fit comes first
    for (const std::uint32_t w : ring) {
      if (w != v) add(w);
    }
    Fit fit;
    auto form = fit(points.begin(), points.end(), 4, 2);
    const Vec3 n = proxy.wedge_normal[v];
    form.comply_wrt_given_normal({n.x, n.y, n.z});
    // CGAL counts curvature positive where the surface bends towards the normal.
    result[v].k1 = -form.principal_curvatures(1);
    result[v].k2 = -form.principal_curvatures(0);
    result[v].d1 = to_vec(form.minimal_principal_direction());
    result[v].d2 = to_vec(form.maximal_principal_direction());
  }
  return result;
}

}  // namespace burin::test
