#include "uniform_stretches.h"

#include <burin/base/box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace burin::detail {
namespace {

/// Sine within which a face or an edge runs along the axis: rounding of coordinates in single
/// precision, over edges of some millimetres.
constexpr double kWallAlong = 1e-5;

class StretchFinder {
 public:
  explicit StretchFinder(const Vec3& axis) {
    const Vec3 u = any_orthogonal(axis);
    axes_ = glm::transpose(Mat3(u, glm::cross(axis, u), axis));
  }

  void add(const ProxyMesh& proxy) {
    ends_.assign(proxy.mesh.positions.size(), {});
    for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) add(proxy, f);
    for (std::size_t v = 0; v < ends_.size(); ++v) {
      // As many edges go up from there as come up to it: they go on.
      if (ends_[v].up == ends_[v].down) continue;
      const double at = (axes_ * proxy.mesh.positions[v]).z;
      changes_.emplace_back(at, at);
    }
  }

  std::vector<UniformStretch> run() {
    std::ranges::sort(changes_);
    std::vector<UniformStretch> found;
    if (changes_.empty()) return found;
    double end = changes_.front().second;
    for (const auto& [low, high] : changes_) {
      if (low > end) found.push_back({end, low});
      end = std::max(end, high);
    }
    for (UniformStretch& one : found) one.width = width_of(one);
    std::erase_if(found, [](const UniformStretch& one) { return !(one.width > 0); });
    return found;
  }

 private:
  void add(const ProxyMesh& proxy, std::uint32_t f) {
    const Triangle& triangle = proxy.mesh.triangles[f];
    std::array<Vec3, 3> p;
    Box3 box;
    for (std::size_t k = 0; k < 3; ++k) box.add(p[k] = axes_ * proxy.mesh.positions[triangle[k]]);
    if (!runs_along(proxy, f, p)) {
      changes_.emplace_back(box.min.z, box.max.z);
      return;
    }
    walls_.push_back(box);
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge h = static_cast<HalfEdge>(3 * f + k);
      if (proxy.edge_kind[static_cast<std::size_t>(h)] == EdgeKind::Smooth) continue;
      const Vec3 a = p[k], b = p[(k + 1) % 3];
      if (glm::length(Vec2(b - a)) <= kWallAlong * glm::length(b - a)) {
        Ends &from = ends_[triangle[k]], &to = ends_[triangle[(k + 1) % 3]];
        ++(a.z < b.z ? from.up : from.down);
        ++(a.z < b.z ? to.down : to.up);
      } else {
        changes_.emplace_back(std::min(a.z, b.z), std::max(a.z, b.z));
      }
    }
  }

  /// Whether the surface there is a wall along the axis: by its own normals, which facets of a
  /// round wall may lack, or by those of the facet, where normals are estimates.
  bool runs_along(const ProxyMesh& proxy, std::uint32_t f, const std::array<Vec3, 3>& p) const {
    const Vec3 facet = glm::cross(p[1] - p[0], p[2] - p[0]);
    if (std::abs(facet.z) <= kWallAlong * glm::length(facet)) return true;
    return std::ranges::all_of(proxy.wedges[f], [&](std::uint32_t wedge) {
      return std::abs((axes_ * proxy.wedge_normal[wedge]).z) <= kWallAlong;
    });
  }

  double width_of(const UniformStretch& stretch) const {
    Box2 across;
    for (const Box3& wall : walls_) {
      if (wall.max.z <= stretch.low || wall.min.z >= stretch.high) continue;
      across.add(Vec2(wall.min));
      across.add(Vec2(wall.max));
    }
    return across.empty() ? 0 : std::max(across.size().x, across.size().y);
  }

  /// How many halves of edges along the axis go up and down from a vertex.
  struct Ends {
    int up = 0, down = 0;
  };

  /// Two across the axis, then the axis.
  Mat3 axes_{1};
  /// Of the vertices of a part.
  std::vector<Ends> ends_;
  /// From where to where along the axis the cross-section is not that of its neighbours.
  std::vector<std::pair<double, double>> changes_;
  /// Triangles that run along it.
  std::vector<Box3> walls_;
};

}  // namespace

std::vector<UniformStretch> uniform_stretches(const MeasuredParts& parts, const Vec3& axis) {
  StretchFinder finder(axis);
  for (const std::shared_ptr<const Surface>& surface : parts.surfaces) {
    if (surface) finder.add(surface->proxy());
  }
  return finder.run();
}

}  // namespace burin::detail
