#include <burin/forms/charted/raw_mesh.h>

namespace burin {

Vec2 RawMesh::on_edge(const Atlas& atlas, std::size_t h, double s) const {
  const std::size_t n = h - h % 3 + (h + 1) % 3;
  if (mesh.border[h] >= 0) {
    const ChartMesh::Border& b = mesh.borders[static_cast<std::size_t>(mesh.border[h])];
    if (b.coedge >= 0) return atlas.on_coedge(b.coedge, b.t0 + s * (b.t1 - b.t0));
  }
  Vec2 a = mesh.uv[h], b = mesh.uv[n];
  if (pole[h]) a[pole[h] - 1] = b[pole[h] - 1];
  if (pole[n]) b[pole[n] - 1] = a[pole[n] - 1];
  return a + s * (b - a);
}

}  // namespace burin
