#include <burin/feature/source_faces.h>

#include <map>

namespace burin {

std::vector<FaceRun> source_faces(const Curve3& curve, const ProxyMesh& proxy,
                                  const Camera& camera) {
  std::vector<FaceRun> runs;
  for (std::size_t i = 0; i < curve.faces.size(); ++i) {
    const std::int32_t triangle = curve.faces[i];
    const std::int32_t face =
        triangle >= 0 ? proxy.face_source(static_cast<std::uint32_t>(triangle)) : -1;
    if (runs.empty()) {
      runs.push_back({i, face, 0});
    } else if (face >= 0 && face != runs.back().face) {
      if (runs.back().face < 0) {
        runs.back().face = face;
      } else {
        runs.push_back({i, face, 0});
      }
    }
    runs.back().paper_length += glm::distance(camera.to_paper(curve.points[i]),
                                              camera.to_paper(curve.points[curve.next(i)]));
  }
  return runs;
}

std::int32_t main_face(const std::vector<FaceRun>& runs) {
  std::map<std::int32_t, double> length;
  for (const FaceRun& run : runs) length[run.face] += run.paper_length;
  std::int32_t best = -1;
  double most = -1;
  for (const auto& [face, sum] : length) {
    if (sum > most) {
      best = face;
      most = sum;
    }
  }
  return best;
}

}  // namespace burin
