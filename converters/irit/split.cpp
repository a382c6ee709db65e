#include "split.h"

#include "lexer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace burin::irit {
namespace {

using Vec4 = glm::dvec4;

/// Splits in the middle, by de Casteljau's construction, along u or v.
std::pair<HomogeneousPatch, HomogeneousPatch> halves(const HomogeneousPatch& patch, bool along_u) {
  HomogeneousPatch low = patch, high = patch;
  const int n = along_u ? patch.degree_u : patch.degree_v;
  const int lines = along_u ? patch.degree_v + 1 : patch.degree_u + 1;
  const int step = along_u ? patch.degree_v + 1 : 1, line_step = along_u ? 1 : patch.degree_v + 1;
  for (int line = 0; line < lines; ++line) {
    const auto at = [&](int i) { return static_cast<std::size_t>(line * line_step + i * step); };
    std::vector<Vec4> p;
    for (int i = 0; i <= n; ++i) p.push_back(patch.points[at(i)]);
    for (int round = 0; round <= n; ++round) {
      low.points[at(round)] = p.front();
      high.points[at(n - round)] = p[static_cast<std::size_t>(n - round)];
      for (int i = 0; i < n - round; ++i) {
        const auto k = static_cast<std::size_t>(i);
        p[k] = 0.5 * (p[k] + p[k + 1]);
      }
    }
  }
  return {low, high};
}

auto bad_weights(const HomogeneousPatch& patch) {
  return std::ranges::count_if(patch.points, [](const Vec4& p) { return !(p.w > 0); });
}

bool append(const HomogeneousPatch& patch, std::vector<NurbsData>& patches) {
  std::vector<Vec3> points;
  std::vector<double> weights;
  for (const Vec4& p : patch.points) {
    points.push_back(Vec3(p) / p.w);
    weights.push_back(p.w);
    const Vec3& q = points.back();
    if (!(std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}) <= kLargestCoordinate)) {
      return false;
    }
  }
  const bool polynomial = std::ranges::all_of(weights, [](double w) { return w == 1; });
  if (polynomial) weights.clear();
  patches.push_back(
      bezier_patch(patch.degree_u, patch.degree_v, std::move(points), std::move(weights)));
  return true;
}

bool append_split(const HomogeneousPatch& patch, int depth, std::vector<NurbsData>& patches) {
  if (bad_weights(patch) == 0) return append(patch, patches);
  // Halves of halves: a weight that is positive on the surface is soon so in the control points.
  if (depth == 6) return false;
  auto best = halves(patch, true);
  auto other = halves(patch, false);
  const auto bad = [](const auto& pair) {
    return bad_weights(pair.first) + bad_weights(pair.second);
  };
  if (bad(other) < bad(best)) best = std::move(other);
  return append_split(best.first, depth + 1, patches) &&
         append_split(best.second, depth + 1, patches);
}

}  // namespace

bool append_positive(const HomogeneousPatch& patch, std::vector<NurbsData>& patches) {
  if (patch.points.front().w >= 0) return append_split(patch, 0, patches);
  HomogeneousPatch negated = patch;
  for (Vec4& p : negated.points) p = -p;
  return append_split(negated, 0, patches);
}

}  // namespace burin::irit
