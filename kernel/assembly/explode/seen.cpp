#include <burin/base/parallel.h>
#include <burin/explode/seen.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

PartsInSight::PartsInSight(std::span<const ProxyMesh* const> proxies,
                           const std::vector<std::size_t>& there, const std::vector<Vec3>& moved,
                           const RunContext& context)
    : meshes_(proxies.size()) {
  std::vector<const ProxyMesh*> shown(proxies.size(), &nothing_);
  for (const std::size_t part : there) {
    ProxyMesh& mesh = meshes_[part];
    mesh.mesh = proxies[part]->mesh;
    for (Vec3& p : mesh.mesh.positions) p += moved[part];
    shown[part] = &mesh;
  }
  occluder_.emplace(shown, context);
}

double PartsInSight::seen(const std::vector<std::size_t>& parts, Vec3 direction, Vec3 up,
                          std::set<std::size_t>* before, int rays) const {
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
  const auto is_asked = [&](std::int32_t part) {
    return std::ranges::binary_search(parts, static_cast<std::size_t>(part));
  };
  const double far = 4 * occluder_->diagonal();
  int there = 0, first = 0;
  for (int i = 0; i < rays * rays; ++i) {
    const int column = i % rays, row = i / rays;
    const Vec2 share((column + 0.5) / rays, (row + 0.5) / rays);
    const Vec2 at = box.min + share * box.size();
    const Vec3 from = at.x * right + at.y * above + (depth + 0.5 * far) * direction;
    if (!occluder_->occluded(from, -direction, 0, far,
                             [&](FaceRef face) { return !is_asked(face.part); })) {
      continue;
    }
    ++there;
    const auto hit = occluder_->first_hit(from, -direction, 0, far);
    if (hit && is_asked(hit->where.part)) {
      ++first;
    } else if (hit && before) {
      before->insert(static_cast<std::size_t>(hit->where.part));
    }
  }
  return there > 0 ? static_cast<double>(first) / there : 1;
}

std::array<Vec3, 8> corners_about(Vec3 first) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const auto side = [&](int bit, double with) {
      return (i & bit ? -1 : 1) * (with < 0 ? -1.0 : 1.0);
    };
    corners[static_cast<std::size_t>(i)] =
        glm::normalize(Vec3(side(1, first.x), side(2, first.y), side(4, first.z)));
  }
  return corners;
}

namespace {

/// What lies above and below a plate is seen at once from nearly beside it.
Vec3 flatter(Vec3 direction, Vec3 up, double height) {
  return glm::normalize(direction - (1 - height) * glm::dot(direction, up) * up);
}

}  // namespace

std::optional<OutlookChoice> clearest_outlook(std::span<const ProxyMesh* const> proxies,
                                              const std::vector<std::size_t>& there,
                                              const std::vector<Vec3>& moved, const Outlook& first,
                                              const RunContext& context) {
  constexpr double kMostRays = 1 << 23, kViews = 25, kFewest = 8, kMost = 24;
  const auto count = static_cast<double>(std::max<std::size_t>(there.size(), 1));
  const double rays = std::min(std::floor(std::sqrt(kMostRays / (2 * kViews * count))), kMost);
  if (rays < kFewest) return std::nullopt;
  const PartsInSight sight(proxies, there, moved, context);
  const auto seen_from = [&](Vec3 direction) {
    std::vector<char> seen(there.size());
    parallel_for(
        there.size(), 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            context.check();
            seen[i] = sight.seen({there[i]}, direction, first.up, nullptr,
                                 static_cast<int>(rays)) >= kLeastSeen;
          }
        },
        &context);
    return static_cast<std::size_t>(std::ranges::count(seen, 1));
  };
  OutlookChoice best{first.direction, seen_from(first.direction), there.size()};
  best.seen_first = best.seen;
  const auto look_from = [&](Vec3 direction) {
    if (best.seen == best.of) return;
    const std::size_t seen = seen_from(direction);
    if (seen > best.seen) best.direction = direction, best.seen = seen;
  };
  const std::array<Vec3, 8> corners = corners_about(first.direction);
  for (const Vec3& corner : corners) look_from(corner);
  for (const double height : {0.5, 0.25}) {
    for (const Vec3& corner : corners) look_from(flatter(corner, first.up, height));
  }
  return best;
}

}  // namespace burin
