// A program that knows the installed kernel alone: draws two tetrahedra, cut open and taken
// apart.
#include <burin/burin.h>
#include <burin/forms/mesh/mesh_form.h>

#include <algorithm>
#include <cstdio>
#include <memory>

using namespace burin;

namespace {

/// A tetrahedron with its corner there.
Part part(const char* name, Vec3 at) {
  TriMesh mesh{{at, at + Vec3(1, 0, 0), at + Vec3(0, 1, 0), at + Vec3(0, 0, 1)},
               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  return {name, "", std::make_shared<MeshForm>(std::move(mesh))};
}

}  // namespace

int main() {
  Scene scene;
  scene.parts = {part("lower", {0, 0, 0}), part("upper", {0, 0, 1})};
  Illustration illustration;
  illustration.style = builtin_style("outline");
  illustration.sections = {{.planes = {{.axis = {0, 1, 0}, .offset = 0.2}}}};
  illustration.explode = {.wanted = true, .steps = {{.move = {"upper"}, .by = 1}}};
  illustration.callouts = true;
  RunContext run;
  const Drawing drawing = illustrate(scene, illustration, run);
  for (const char* wanted : {"outline", "section", "callouts"}) {
    const bool there = std::ranges::any_of(
        drawing.layers, [&](const Layer& layer) { return layer.name == wanted; });
    std::printf("%s: %s\n", wanted, there ? "drawn" : "missing");
    if (!there) return 1;
  }
  return 0;
}
