#include <burin/forms/charted/wedge_normals.h>

#include <algorithm>
#include <span>

namespace burin {

namespace {

/// Cosine of the angle by which the normals of one face at one point may differ. At the tip of a
/// cone every ruling has its own.
constexpr double kOneNormal = 0.9998;  // 0.02 rad

/// The normal of one face at some of its corners, each place in (u,v) evaluated once.
Vec3 face_normal(const ChartMesh& mesh, const PlacedAtlas& atlas,
                 std::span<const HalfEdge> corners) {
  const std::int32_t face = mesh.face[face_of(corners.front())];
  const auto place = [&](HalfEdge h) { return mesh.uv[static_cast<std::size_t>(h)]; };
  Vec3 sum(0), first(0);
  int places = 0;
  for (auto h = corners.begin(); h != corners.end(); ++h) {
    const Vec2 uv = place(*h);
    if (std::any_of(corners.begin(), h, [&](HalfEdge o) { return place(o) == uv; })) continue;
    ++places;
    const Vec3 n = atlas.normal(face, uv, atlas.derivatives(face, uv));
    if (first == Vec3(0)) first = n;
    if (glm::dot(first, n) < kOneNormal) return Vec3(0);
    sum += n;
  }
  return places > 1 ? normalize_or(sum, first) : first;
}

}  // namespace

void set_wedge_normals(ChartMesh& mesh, const PlacedAtlas& atlas, const RunContext& context) {
  set_corner_normals(
      mesh, [&](std::span<const HalfEdge> corners) { return face_normal(mesh, atlas, corners); },
      context);
}

}  // namespace burin
