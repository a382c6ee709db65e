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

PartInfo measure_realised_part(const Part& part, Diagnostics& diagnostics, RunContext& context) {
  constexpr double kChord = 1e-4;  // of the size
  PartInfo info;
  info.name = part.name;
  info.color = part.color;
  info.colors = count_colors(part.color, part.face_colors.get());
  info.opacity = part.opacity;
  info.bounds = part.form->bounds(Mat3(1));
  RealiseOptions realise;
  realise.tolerance = kChord * info.bounds.diagonal();
  realise.diagnostics = &diagnostics;
  const auto surface = part.form->realise(realise, context);
  const ProxyMesh& proxy = surface->proxy();
  info.components = static_cast<std::int64_t>(proxy.topology.component_closed.size());
  info.faces = proxy.region_count;
  measure_triangles(proxy.mesh, info);
  return info;
}

}  // namespace burin
