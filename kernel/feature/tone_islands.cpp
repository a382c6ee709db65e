#include <burin/base/disjoint_sets.h>
#include <burin/feature/light_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace burin {
namespace {

/// Pens: islands smaller than the disc over which `light_normals` averages noise are no shape.
constexpr double kLeastDisc = 8;
/// An island that is no larger than a square of so many pens, and differs by less than this share
/// of a step from the level around it, is none either.
constexpr double kFaintSide = 30, kFaint = 0.2;
/// By how much the light of what was an island is on the other side of its level then.
constexpr double kClear = 1e-3;

/// Wedges that hang together on one side of a level.
struct Island {
  /// The most light that parts it from its level.
  double depth = 0;
  /// mm2 of paper.
  double area = 0;
  /// Whether it reaches the edge of its smooth region, and whether averages are in it.
  bool at_edge = false, noisy = false;
};

class Level {
 public:
  /// `normals` are changed.
  Level(const ProxyMesh& proxy, Vec3 light, double level, std::vector<Vec3>& normals)
      : proxy_(proxy),
        light_(light),
        level_(level),
        normals_(normals),
        over_(normals.size()),
        sets_(normals.size()),
        islands_(normals.size()) {
    for (std::size_t w = 0; w < over_.size(); ++w) over_[w] = glm::dot(normals[w], light) > level;
    for (const Triangle& t : proxy.wedges) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (over_[a] == over_[b]) sets_.join(a, b);
      }
    }
  }

  /// `area`: of a wedge on paper. `faint`: the light by which an island is faint.
  void sink(std::span<const float> area, double faint, double pen) {
    measure(area);
    const auto sinks = [&](const Island& island) {
      if (island.at_edge || !island.noisy) return false;
      const double least = 0.25 * std::numbers::pi * kLeastDisc * kLeastDisc * pen * pen;
      const double most = kFaintSide * kFaintSide * pen * pen;
      return island.area < least || (island.area < most && island.depth < faint);
    };
    std::vector<double> clear(normals_.size(), 0);
    for (const Triangle& t : proxy_.wedges) {
      if (!over_[t[0]] && !over_[t[1]] && !over_[t[2]]) continue;
      // Between normals at unit length there is more light than at both.
      const Vec3 &a = normals_[t[0]], &b = normals_[t[1]], &c = normals_[t[2]];
      const double bend = 1 - std::min({glm::dot(a, b), glm::dot(b, c), glm::dot(c, a)});
      for (const std::uint32_t w : t) clear[w] = std::max(clear[w], bend);
    }
    for (std::uint32_t w = 0; w < normals_.size(); ++w) {
      if (!sinks(islands_[sets_.find(w)])) continue;
      put(w, over_[w] ? level_ - kClear - clear[w] : level_ + kClear);
    }
  }

 private:
  void measure(std::span<const float> area) {
    for (std::uint32_t w = 0; w < normals_.size(); ++w) {
      Island& island = islands_[sets_.find(w)];
      island.depth = std::max(island.depth, std::abs(glm::dot(normals_[w], light_) - level_));
      island.area += area[w];
      island.noisy = island.noisy || normals_[w] != proxy_.wedge_normal[w];
    }
    for (std::size_t h = 0; h < proxy_.edge_kind.size(); ++h) {
      if (proxy_.edge_kind[h] == EdgeKind::Smooth) continue;
      const Triangle& t = proxy_.wedges[h / 3];
      for (const std::size_t k : {h % 3, (h + 1) % 3}) islands_[sets_.find(t[k])].at_edge = true;
    }
  }

  /// Turns a normal towards the light, or away from it, until so much light falls on it.
  void put(std::uint32_t w, double light) {
    const Vec3 along = glm::dot(normals_[w], light_) * light_;
    const Vec3 across = normalize_or(normals_[w] - along, Vec3(0));
    if (across == Vec3(0) || std::abs(light) > 1) return;
    normals_[w] = light * light_ + std::sqrt(1 - light * light) * across;
  }

  const ProxyMesh& proxy_;
  Vec3 light_;
  double level_;
  std::vector<Vec3>& normals_;
  std::vector<bool> over_;
  DisjointSets sets_;
  /// By the lowest wedge.
  std::vector<Island> islands_;
};

/// Of each wedge: a third of its triangles.
std::vector<float> areas_on_paper(const ProxyMesh& proxy, const Camera& camera) {
  std::vector<Vec2> places;
  places.reserve(proxy.mesh.positions.size());
  for (const Vec3& p : proxy.mesh.positions) places.push_back(camera.to_paper(p));
  std::vector<float> out(proxy.wedge_normal.size(), 0);
  for (std::size_t f = 0; f < proxy.wedges.size(); ++f) {
    const auto& [a, b, c] = proxy.mesh.triangles[f];
    const Vec2 u = places[b] - places[a], v = places[c] - places[a];
    const auto third = static_cast<float>(std::abs(u.x * v.y - u.y * v.x) / 6);
    for (const std::uint32_t w : proxy.wedges[f]) out[w] += third;
  }
  return out;
}

}  // namespace

std::vector<Vec3> without_islands(const ProxyMesh& proxy, std::vector<Vec3> normals,
                                  const Isophotes& isophotes, const Camera& camera, double pen) {
  if (normals.empty() || isophotes.levels.empty()) return normals;
  const std::vector<float> area = areas_on_paper(proxy, camera);
  const double faint = kFaint / static_cast<double>(isophotes.levels.size() + 1);
  const Vec3 light = glm::normalize(isophotes.light);
  for (const double level : isophotes.levels) {
    Level(proxy, light, level, normals).sink(area, faint, pen);
  }
  return normals;
}

std::vector<Vec3> tone_normals(const ProxyMesh& proxy, const Isophotes& isophotes,
                               const Camera& camera, double pen, const RunContext& context) {
  return without_islands(proxy, light_normals(proxy, camera, pen, context), isophotes, camera, pen);
}

}  // namespace burin
