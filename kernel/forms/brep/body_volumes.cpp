#include "body_volumes.h"

#include <cmath>

namespace burin {

std::vector<double> body_volumes(const ChartMesh& mesh, const std::vector<std::int32_t>& face_body,
                                 std::size_t bodies) {
  std::vector<double> volume(bodies, 0.0);
  std::vector<Vec3> area(bodies, Vec3(0));  // sums to nothing over closed bodies
  std::vector<double> total(bodies, 0.0);
  if (mesh.positions.empty()) return volume;
  const Vec3 o = mesh.positions.front();
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const std::int32_t body = face_body[static_cast<std::size_t>(mesh.face[f])];
    if (body < 0) continue;
    const auto& t = mesh.triangles[f];
    const Vec3 a = mesh.positions[t[0]] - o, b = mesh.positions[t[1]] - o,
               c = mesh.positions[t[2]] - o;
    const auto i = static_cast<std::size_t>(body);
    const Vec3 n = glm::cross(b - a, c - a);
    volume[i] += glm::dot(a, glm::cross(b, c)) / 6;
    area[i] += n;
    total[i] += glm::length(n);
  }
  for (std::size_t i = 0; i < bodies; ++i) {
    // A tenth of a thousandth: faces that were left out are small or the body is open.
    if (glm::length(area[i]) > 1e-4 * total[i]) volume[i] = 0;
    // No more than what the triangles leave between them and the faces: that says nothing.
    if (std::abs(volume[i]) <= 0.5 * total[i] * mesh.tolerance) volume[i] = 0;
  }
  return volume;
}

}  // namespace burin
