#pragma once
/// The faces of the input that a line runs over.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Segments of a curve that lie on one face of the input.
struct FaceRun {
  std::size_t first_segment = 0;
  std::int32_t face = -1;
  double paper_length = 0;
};

/// The runs of a curve that has `faces`, in order; empty without them. Segments of no known
/// triangle belong to the run before. `proxy` is that of the curve's part.
std::vector<FaceRun> source_faces(const Curve3& curve, const ProxyMesh& proxy,
                                  const Camera& camera);

/// The face that holds most of the length on paper, of equal ones the lowest; -1 without runs.
std::int32_t main_face(const std::vector<FaceRun>& runs);

}  // namespace burin
