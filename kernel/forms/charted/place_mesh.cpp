#include <burin/base/affine.h>
#include <burin/base/parallel.h>
#include <burin/forms/charted/place_mesh.h>

#include <algorithm>
#include <utility>

namespace burin {

void turn_triangles(ChartMesh& mesh, const std::vector<std::uint8_t>& face_marked,
                    std::span<std::uint8_t> corners) {
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (!face_marked[static_cast<std::size_t>(mesh.face[f])]) continue;
    const std::size_t h = 3 * f;
    // (a, b, c) becomes (a, c, b): the half-edges ab, bc, ca are now ac, cb, ba.
    std::swap(mesh.triangles[f][1], mesh.triangles[f][2]);
    std::swap(mesh.uv[h + 1], mesh.uv[h + 2]);
    if (!mesh.normal.empty()) std::swap(mesh.normal[h + 1], mesh.normal[h + 2]);
    if (!mesh.on_contour.empty()) std::swap(mesh.on_contour[h + 1], mesh.on_contour[h + 2]);
    if (!corners.empty()) std::swap(corners[h + 1], corners[h + 2]);
    std::swap(mesh.border[h], mesh.border[h + 2]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.border[h + k] < 0) continue;
      ChartMesh::Border& b = mesh.borders[static_cast<std::size_t>(mesh.border[h + k])];
      std::swap(b.t0, b.t1);
    }
  }
}

ChartMesh placed(const ChartMesh& mesh, const Placement& placement) {
  constexpr std::size_t kGrain = 4096;
  ChartMesh out = mesh;
  parallel_for(out.positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out.positions[i] = placement.point(out.positions[i]);
  });
  const Mat3 turned = glm::transpose(glm::inverse(placement.linear));
  parallel_for(out.normal.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      out.normal[i] = normalize_or(turned * out.normal[i], Vec3(0));
    }
  });
  if (placement.mirrors()) {
    std::int32_t faces = 0;
    for (const std::int32_t f : out.face) faces = std::max(faces, f + 1);
    turn_triangles(out, std::vector<std::uint8_t>(static_cast<std::size_t>(faces), 1));
  }
  out.tolerance *= stretch(placement);
  return out;
}

}  // namespace burin
