#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/curvature.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/reorder.h>

#include "mesh_surface.h"

namespace burin {

Box3 MeshForm::bounds(const Mat3& axes) const {
  // GLM stores columns: the rows of `axes` are the columns of its transpose, so v * axes^T = axes
  // v.
  const Vec3 x(axes[0][0], axes[1][0], axes[2][0]), y(axes[0][1], axes[1][1], axes[2][1]),
      z(axes[0][2], axes[1][2], axes[2][2]);
  Box3 box;
  for (const Vec3& p : mesh_.positions)
    box.add(Vec3(glm::dot(x, p), glm::dot(y, p), glm::dot(z, p)));
  return box;
}

std::shared_ptr<const Surface> MeshForm::realise(const RealiseOptions& options,
                                                 RunContext& context) const {
  context.begin_stage("build");
  TriMesh mesh = mesh_;
  reorder_for_cache(mesh);
  const ProxyOptions proxy_options{.crease_angle = options.crease_angle};
  ProxyMesh proxy = build_proxy(std::move(mesh), proxy_options, context);
  std::vector<Curvature> curvature;
  if (options.curvature) {
    context.begin_stage("curvature");
    curvature = estimate_curvature(proxy, {}, context);
  }
  context.end_stage();
  return make_mesh_surface(std::move(proxy), curvature);
}

std::shared_ptr<const Surface> make_mesh_surface(ProxyMesh proxy,
                                                 const std::vector<Curvature>& curvature) {
  return std::make_shared<MeshSurface>(std::move(proxy), curvature);
}

}  // namespace burin
