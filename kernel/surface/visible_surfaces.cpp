#include <burin/surface/visible_surfaces.h>

namespace burin {

Box3 box_of(std::span<const Surface* const> surfaces) {
  Box3 box;
  for (const Surface* surface : surfaces) {
    for (const Vec3& p : surface->proxy().mesh.positions) box.add(p);
  }
  return box;
}

}  // namespace burin
