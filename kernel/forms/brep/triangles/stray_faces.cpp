#include "stray_faces.h"

#include <burin/base/parallel.h>

#include <algorithm>

namespace burin {
namespace {

/// Share of the part's diagonal. Whole files, the sloppiest too, stay under 5e-4; coordinates that
/// were changed at random moved edges by 0.1 and more.
constexpr double kFarthest = 0.01;
constexpr std::size_t kGrain = 1024;  // triangles

/// How far the corners of a triangle lie beside its face.
double stray(const RawMesh& raw, const Atlas& atlas, std::size_t triangle) {
  const Chart& chart = atlas.chart(raw.mesh.face[triangle]);
  double farthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t h = 3 * triangle + k;
    if (raw.pole[h]) continue;  // its u is not its own
    const Vec3 stands = raw.mesh.positions[raw.mesh.triangles[triangle][k]];
    farthest = std::max(farthest, glm::distance(stands, chart.position(raw.mesh.uv[h])));
  }
  return farthest;
}

}  // namespace

void StrayFaces::add(const StrayFaces& others) {
  marked.resize(std::max(marked.size(), others.marked.size()));
  for (std::size_t f = 0; f < others.marked.size(); ++f) marked[f] |= others.marked[f];
  distance = std::max(distance, others.distance);
}

StrayFaces find_stray_faces(const RawMesh& raw, const Atlas& atlas, double size,
                            const RunContext& context) {
  std::vector<double> distance(raw.mesh.triangles.size());
  parallel_for(
      distance.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) distance[t] = stray(raw, atlas, t);
      },
      &context);
  StrayFaces found;
  for (std::size_t t = 0; t < distance.size(); ++t) {
    if (!(distance[t] > kFarthest * size)) continue;
    found.marked.resize(atlas.face_count());
    found.marked[static_cast<std::size_t>(raw.mesh.face[t])] = 1;
    found.distance = std::max(found.distance, distance[t]);
  }
  return found;
}

}  // namespace burin
