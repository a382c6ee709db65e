// A program that knows the installed kernel alone: draws a tetrahedron.
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include <cstdio>
#include <memory>

int main() {
  burin::TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  burin::Scene scene;
  scene.parts.push_back({"tetrahedron", "", std::make_shared<burin::MeshForm>(std::move(mesh))});
  const burin::Camera camera =
      burin::Camera::fit([&](const burin::Mat3& axes) { return scene.bounds(axes); }, {});
  burin::RunContext context;
  const burin::Drawing drawing =
      burin::illustrate(scene, camera, burin::builtin_style("outline"), {}, context);
  std::printf("%zu layers\n", drawing.layers.size());
  return drawing.layers.empty() ? 1 : 0;
}
