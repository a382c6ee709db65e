#include "near_surface.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace burin {
namespace {

constexpr std::uint32_t kLeaf = 4;

double squared(Vec3 v) { return glm::dot(v, v); }

double squared_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 way = b - a;
  const double length2 = squared(way);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0;
  return squared(p - (a + t * way));
}

/// The squared distance of a point from a triangle: from its plane where the point lies over it,
/// else from its sides.
double squared_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 n = glm::cross(b - a, c - a);
  const double n2 = squared(n);
  if (n2 > 0) {
    const bool over = glm::dot(glm::cross(b - a, p - a), n) >= 0 &&
                      glm::dot(glm::cross(c - b, p - b), n) >= 0 &&
                      glm::dot(glm::cross(a - c, p - c), n) >= 0;
    const double height = glm::dot(p - a, n);
    if (over) return height * height / n2;
  }
  return std::min(
      {squared_to_segment(p, a, b), squared_to_segment(p, b, c), squared_to_segment(p, c, a)});
}

}  // namespace

NearSurface::NearSurface(const TriMesh& mesh) : mesh_(mesh), triangles_(mesh.triangles.size()) {
  std::iota(triangles_.begin(), triangles_.end(), 0U);
  middles_.reserve(triangles_.size());
  for (const Triangle& t : mesh.triangles) {
    middles_.push_back((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0);
  }
  if (!triangles_.empty()) make(0, static_cast<std::uint32_t>(triangles_.size()));
  middles_ = {};
}

std::uint32_t NearSurface::make(std::uint32_t first, std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 box, middles;
  for (std::uint32_t i = first; i < last; ++i) {
    for (const std::uint32_t corner : mesh_.triangles[triangles_[i]]) {
      box.add(mesh_.positions[corner]);
    }
    middles.add(middles_[triangles_[i]]);
  }
  nodes_[index].box = box;
  if (last - first <= kLeaf) {
    nodes_[index].first = first;
    nodes_[index].count = last - first;
    return index;
  }
  const Vec3 size = middles.size();
  const int along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t middle = first + (last - first) / 2;
  // By halves, so that the tree is as deep as the logarithm, whatever the mesh.
  std::nth_element(
      triangles_.begin() + first, triangles_.begin() + middle, triangles_.begin() + last,
      [&](std::uint32_t a, std::uint32_t b) { return middles_[a][along] < middles_[b][along]; });
  make(first, middle);
  const std::uint32_t other = make(middle, last);
  nodes_[index].first = other;
  return index;
}

bool NearSurface::within(Vec3 point, double reach) const {
  if (nodes_.empty()) return false;
  constexpr std::size_t kDeepest = 64;
  std::array<std::uint32_t, kDeepest> open{};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const Node& node = nodes_[index];
    const Vec3 nearest = glm::clamp(point, node.box.min, node.box.max);
    if (squared(point - nearest) > reach * reach) continue;
    if (node.count == 0) {
      open[count++] = node.first;
      open[count++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = mesh_.triangles[triangles_[i]];
      const double off = squared_to_triangle(point, mesh_.positions[t[0]], mesh_.positions[t[1]],
                                             mesh_.positions[t[2]]);
      if (off <= reach * reach) return true;
    }
  }
  return false;
}

}  // namespace burin
