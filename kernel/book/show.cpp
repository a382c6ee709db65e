#include "show.h"

#include <burin/visibility/occluder.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace burin::detail {
namespace {

/// Of its silhouette: what must be seen of something new.
constexpr double kLeastSeen = 0.3;
/// Rays across the silhouette of something new.
constexpr int kRays = 24;

/// The parts of a step, where they are.
class Stage {
 public:
  Stage(std::span<const ProxyMesh* const> proxies, const BuildStep& step,
        const std::vector<Vec3>& moved, const RunContext& context)
      : step_(step), meshes_(proxies.size()) {
    std::vector<const ProxyMesh*> shown(proxies.size(), &nothing_);
    for (const std::size_t part : step.parts()) {
      ProxyMesh& mesh = meshes_[part];
      mesh.mesh = proxies[part]->mesh;
      for (Vec3& p : mesh.mesh.positions) p += moved[part];
      shown[part] = &mesh;
    }
    occluder_.emplace(shown, context);
  }

  /// The least share of a silhouette of what moves that is seen along a direction; those that
  /// stand before what is seen less than it should be go to `before`.
  double least_seen(Vec3 direction, Vec3 up, std::set<std::size_t>* before) const {
    double least = 1;
    for (const BuildMove& move : step_.moves) {
      std::set<std::size_t> others;
      const double share = seen(move.parts, direction, up, others);
      least = std::min(least, share);
      if (before && share < kLeastSeen) before->insert(others.begin(), others.end());
    }
    return least;
  }

 private:
  double seen(const std::vector<std::size_t>& parts, Vec3 direction, Vec3 up,
              std::set<std::size_t>& before) const {
    const Vec3 right = glm::normalize(glm::cross(up, direction));
    const Vec3 above = glm::cross(direction, right);
    Box2 box;
    double depth = -std::numeric_limits<double>::infinity();
    for (const std::size_t part : parts) {
      for (const Vec3& p : meshes_[part].mesh.positions) {
        box.add(Vec2(glm::dot(p, right), glm::dot(p, above)));
        depth = std::max(depth, glm::dot(p, direction));
      }
    }
    if (box.empty()) return 1;
    const auto is_new = [&](std::int32_t part) {
      return std::ranges::binary_search(parts, static_cast<std::size_t>(part));
    };
    const double far = 4 * occluder_->diagonal();
    int there = 0, first = 0;
    for (int i = 0; i < kRays * kRays; ++i) {
      const int column = i % kRays, row = i / kRays;
      const Vec2 share((column + 0.5) / kRays, (row + 0.5) / kRays);
      const Vec2 at = box.min + share * box.size();
      const Vec3 from = at.x * right + at.y * above + (depth + 0.5 * far) * direction;
      if (!occluder_->occluded(from, -direction, 0, far,
                               [&](FaceRef face) { return !is_new(face.part); })) {
        continue;
      }
      ++there;
      const auto hit = occluder_->first_hit(from, -direction, 0, far);
      if (hit && is_new(hit->where.part)) {
        ++first;
      } else if (hit) {
        before.insert(static_cast<std::size_t>(hit->where.part));
      }
    }
    return there > 0 ? static_cast<double>(first) / there : 1;
  }

  const BuildStep& step_;
  ProxyMesh nothing_;
  std::vector<ProxyMesh> meshes_;
  std::optional<Occluder> occluder_;
};

}  // namespace

Look best_look(std::span<const ProxyMesh* const> proxies, const BuildStep& step,
               const std::vector<Vec3>& moved, const ViewOptions& asked,
               const RunContext& context) {
  const Camera camera = Camera::fit(
      [](const Mat3&) {
        return Box3{Vec3(-1), Vec3(1)};
      },
      {.direction = asked.direction, .up = asked.up});
  Look first{camera.direction(), camera.up(), {}};
  if (step.moves.empty()) return first;
  const Stage stage(proxies, step, moved, context);
  Look best = first;
  double most = stage.least_seen(first.direction, first.up, nullptr);
  for (int i = 0; i < 8 && most < kLeastSeen; ++i) {
    context.check();
    // From the side of the asked view on.
    const auto side = [&](int bit, double with) {
      return (i & bit ? -1 : 1) * (with < 0 ? -1.0 : 1.0);
    };
    const Vec3 d = glm::normalize(
        Vec3(side(1, first.direction.x), side(2, first.direction.y), side(4, first.direction.z)));
    const double seen = stage.least_seen(d, Vec3(0, 0, 1), nullptr);
    if (seen > most) most = seen, best = {d, Vec3(0, 0, 1), {}};
  }
  if (most >= kLeastSeen) return best;
  std::set<std::size_t> before;
  stage.least_seen(best.direction, best.up, &before);
  for (const std::size_t part : before) {
    if (std::ranges::binary_search(step.standing, part)) best.ghosts.push_back(part);
  }
  return best;
}

}  // namespace burin::detail
