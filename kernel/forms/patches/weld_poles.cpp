// Poles that are not quite collapsed.

#include <burin/base/box.h>
#include <burin/forms/charted/nurbs.h>

#include "weld.h"

#include <algorithm>

namespace burin::detail {
namespace {

// A loop of control points within this share of the part's size is meant as one point (the lid of
// the Utah teapot has such a hole of 2e-4); on a drawing of 200 mm nothing is seen of it.
constexpr double kTinyLoop = 5e-4;

// The control points of a side in the order of `side_uv`; empty where the knots are not clamped
// there, so that the side is not their curve.
std::vector<std::size_t> side_points(const NurbsData& n, int side) {
  const bool along_u = side_direction(side) == 0, far_end = side == 1 || side == 2;
  const std::vector<double>& knots = along_u ? n.knots_v : n.knots_u;
  const auto degree = static_cast<std::size_t>(along_u ? n.degree_v : n.degree_u);
  const std::size_t last = knots.size() - 1;
  if (knots[0] != knots[degree] || knots[last] != knots[last - degree]) return {};
  std::vector<std::size_t> points;
  const int count = along_u ? n.count_u : n.count_v;
  for (int k = 0; k < count; ++k) {
    const int i = along_u ? k : far_end ? n.count_u - 1 : 0;
    const int j = along_u ? (far_end ? n.count_v - 1 : 0) : k;
    points.push_back(static_cast<std::size_t>(i * n.count_v + j));
  }
  return points;
}

bool collapse(NurbsData& n, int side, double extent, double coincide) {
  const std::vector<std::size_t> at = side_points(n, side);
  if (at.empty()) return false;
  const Vec3 first = n.points[at.front()];
  if (glm::distance(first, n.points[at.back()]) > coincide) return false;
  double farthest = 0;
  for (const std::size_t i : at) farthest = std::max(farthest, glm::distance(first, n.points[i]));
  if (farthest == 0 || farthest > extent) return false;
  for (const std::size_t i : at) n.points[i] = first;
  return true;
}

}  // namespace

ChartList mend_poles(const ChartList& patches, double tolerance) {
  Box3 box;
  for (const auto& patch : patches) {
    if (const NurbsData* data = nurbs_data(*patch)) {
      for (const Vec3& p : data->points) box.add(p);
    }
  }
  const double size = box.diagonal();
  ChartList result = patches;
  for (auto& patch : result) {
    const NurbsData* data = nurbs_data(*patch);
    if (!data) continue;
    NurbsData mended = *data;
    bool changed = false;
    for (int s = 0; s < 4; ++s) {
      changed |= collapse(mended, s, kTinyLoop * size, tolerance * size);
    }
    if (changed) patch = make_nurbs_chart(std::move(mended), patch->kind());
  }
  return result;
}

}  // namespace burin::detail
