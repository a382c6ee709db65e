#include "noise.h"

#include "paper_limits.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace burin {

namespace {

double loop_length(const Camera& camera, const std::vector<Vec3>& points) {
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = camera.to_paper(points[i]), b = camera.to_paper(points[(i + 1) % points.size()]);
    length += glm::length(b - a);
  }
  return length;
}

/// The wedges of one sign that smooth edges connect with those on the contour.
class Patch {
 public:
  Patch(const Facing& facing, const Curve3& contour, bool front) : facing_(facing), front_(front) {
    for (const std::int32_t f : contour.faces) take(static_cast<std::uint32_t>(f));
  }

  /// Grows by one triangle. False once it is complete.
  bool grow() {
    if (next_ == faces_.size()) return false;
    const std::uint32_t f = faces_[next_++];
    const ProxyMesh& proxy = facing_.proxy();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t h = 3 * std::size_t{f} + k;
      const auto half_edge = static_cast<HalfEdge>(h);
      // Over an edge that has no end of this sign the patch does not go on.
      if (facing_.front_at(half_edge) != front_ &&
          facing_.front_at(next_in_face(half_edge)) != front_) {
        continue;
      }
      if (proxy.edge_kind[h] != EdgeKind::Smooth) {
        bordered_ = true;
      } else {
        take(face_of(proxy.topology.opposite[h]));
      }
    }
    return true;
  }
  /// It reaches a crease or the end of the surface: no patch that the contour encloses.
  bool bordered() const { return bordered_; }
  double largest() const { return largest_; }

 private:
  void take(std::uint32_t f) {
    if (!seen_.insert(f).second) return;
    faces_.push_back(f);
    for (HalfEdge h = static_cast<HalfEdge>(3 * f), end = h + 3; h < end; ++h) {
      if (facing_.front_at(h) != front_) continue;
      largest_ = std::max(largest_, std::abs(facing_.g(facing_.origin_wedge(h))));
    }
  }

  const Facing& facing_;
  bool front_;
  std::vector<std::uint32_t> faces_;
  std::unordered_set<std::uint32_t> seen_;
  std::size_t next_ = 0;
  double largest_ = 0;
  bool bordered_ = false;
};

}  // namespace

bool is_noise(const Facing& facing, const Curve3& contour) {
  const double length = loop_length(facing.camera(), contour.points);
  // Exact normals have no noise: however shallow, a loop that can be seen is shape.
  const bool exact = !facing.proxy().on_contour.empty();
  if (exact && length >= kSpeckLength) return false;
  const double limit = length < kSpeckLength ? kSpeckAngle : kNoiseAngle;
  // The enclosed patch of a short curve is small; a long way round is not worth the search.
  const std::size_t most = 16 * contour.faces.size() + 64;
  for (const bool front : {true, false}) {
    Patch patch(facing, contour, front);
    std::size_t steps = 0;
    bool growing = true;
    while (growing && !patch.bordered() && patch.largest() <= limit && steps++ < most) {
      growing = patch.grow();
    }
    if (!growing && !patch.bordered() && patch.largest() <= limit) return true;
  }
  return false;
}

}  // namespace burin
