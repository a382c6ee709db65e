#include <burin/congruence/pose.h>

namespace burin {
namespace {

/// Share of the chord tolerance that the middle of a curved surface may be off: what the triangles
/// lack on one side they lack on the others.
constexpr double kMiddleError = 0.1;

}  // namespace

Pose pose_of(const TriMesh& mesh, double tolerance) {
  Pose s;
  s.box = mesh.bounds();
  if (mesh.triangles.empty()) return s;
  // About a point of the shape: far from the origin nothing is lost.
  const Vec3 about = mesh.positions[mesh.triangles.front()[0]];
  double area = 0;
  Vec3 middle(0);
  const auto each = [&](Vec3 origin, const auto& add) {
    for (const Triangle& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]] - origin, b = mesh.positions[t[1]] - origin,
                 c = mesh.positions[t[2]] - origin;
      add(a, b, c, 0.5 * glm::length(glm::cross(b - a, c - a)));
    }
  };
  each(about, [&](Vec3 a, Vec3 b, Vec3 c, double piece) {
    area += piece;
    middle += piece / 3 * (a + b + c);
  });
  if (!(area > 0)) {
    s.middle = s.box.center();
    return s;
  }
  middle = about + middle / area;
  s.middle = middle;
  each(middle, [&](Vec3 a, Vec3 b, Vec3 c, double piece) {
    const Vec3 sum = a + b + c;
    for (const Vec3& p : {a, b, c, sum}) s.spread += piece / 12 * glm::outerProduct(p, p);
  });
  s.spread /= area;
  s.error = kMiddleError * tolerance;
  return s;
}

}  // namespace burin
