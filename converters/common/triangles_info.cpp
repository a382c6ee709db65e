#include "triangles_info.h"

namespace burin {

void measure_triangles(const TriMesh& mesh, PartInfo& info) {
  const Vec3 o = info.bounds.center();
  double area = 0, volume = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]] - o, b = mesh.positions[t[1]] - o,
               c = mesh.positions[t[2]] - o;
    area += glm::length(glm::cross(b - a, c - a)) / 2;
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  info.area = area;
  info.volume = info.closed() ? volume : 0;
}

}  // namespace burin
