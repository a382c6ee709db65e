// Slivers along creases, flipped away.

#include "exact_mesh.h"

#include <cmath>
#include <set>
#include <tuple>

namespace burin {
namespace {

constexpr int kPasses = 6;
constexpr std::uint8_t kRings = 3;
// Height over longest side below which a triangle is a sliver, or the cosine its plane may turn
// away from the surface.
constexpr double kFlat = 0.05;
constexpr double kTilted = 0.4;
constexpr double kEach = 600;  // nanoseconds an edge and pass

struct Half {
  std::uint32_t low = 0, high = 0, face = 0, corner = 0;
  auto order() const { return std::tuple(low, high, face); }
};

class Flipper {
 public:
  explicit Flipper(ExactMesh& mesh) : mesh_(mesh), near_(mesh.positions.size(), 0) {
    // Vertices within three edges of a crease: where thin wedges have been sorted out.
    for (std::size_t v = 0; v < near_.size(); ++v) near_[v] = mesh.crease[v] >= 0;
    for (std::uint8_t ring = 1; ring <= kRings; ++ring) {
      for (const Triangle& t : mesh.triangles) {
        const auto in = [&](std::uint32_t v) { return near_[v] > 0 && near_[v] <= ring; };
        if (!in(t[0]) && !in(t[1]) && !in(t[2])) continue;
        for (const std::uint32_t v : t) {
          if (near_[v] == 0) near_[v] = static_cast<std::uint8_t>(ring + 1);
        }
      }
    }
  }

  void run() {
    for (int pass = 0; pass < kPasses; ++pass) {
      find_edges();
      if (!flip_all()) return;
    }
  }

 private:
  bool on_line(std::uint32_t v) const { return near_[v] > 0; }

  void find_edges() {
    edges_.clear();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& tri = mesh_.triangles[t];
      if (!on_line(tri[0]) && !on_line(tri[1]) && !on_line(tri[2])) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t u = tri[k], v = tri[(k + 1) % 3];
        edges_.push_back({std::min(u, v), std::max(u, v), t, k});
      }
    }
    mesh_.budget.spend(static_cast<double>(edges_.size()), kEach);
    std::ranges::sort(edges_, {}, &Half::order);
  }

  const Half* find(std::uint32_t u, std::uint32_t v, std::uint32_t not_face) const {
    const auto wanted = std::pair(std::min(u, v), std::max(u, v));
    auto it = std::ranges::lower_bound(edges_, wanted, {},
                                       [](const Half& h) { return std::pair(h.low, h.high); });
    for (; it != edges_.end() && std::pair(it->low, it->high) == wanted; ++it) {
      if (it->face != not_face) return &*it;
    }
    return nullptr;
  }

  // Height over longest side; negative where the plane turns away from the surface.
  double quality(const Triangle& tri, Vec3 normal) const {
    const Vec3 a = mesh_.positions[tri[0]], b = mesh_.positions[tri[1]],
               c = mesh_.positions[tri[2]];
    const Vec3 n = glm::cross(b - a, c - a);
    const double area = glm::length(n);
    const double l =
        std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    if (!(area > 0)) return 0;
    return glm::dot(n, normal) < kTilted * area ? -1 : area / l;
  }
  Vec3 side_normal(std::uint32_t t) const {
    Vec3 n(0);
    for (std::size_t k = 0; k < 3; ++k) n += mesh_.corner_normal(t, k);
    return normalize_or(n, Vec3(0));
  }

  bool flip_all() {
    std::set<std::uint32_t> changed;
    std::vector<std::uint32_t> faces;
    for (const Half& h : edges_) faces.push_back(h.face);
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    fresh_.clear();
    for (const std::uint32_t t : faces) {
      if (changed.contains(t) || quality(mesh_.triangles[t], side_normal(t)) > kFlat) continue;
      const std::uint32_t o = flip(t, changed);
      if (o == kNone) continue;
      changed.insert(t);
      changed.insert(o);
    }
    return !changed.empty();
  }

  // Over the longest edge.
  std::uint32_t flip(std::uint32_t t, const std::set<std::uint32_t>& changed) {
    const Triangle tri = mesh_.triangles[t];
    std::size_t k = 0;
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double l = glm::distance(mesh_.positions[tri[i]], mesh_.positions[tri[(i + 1) % 3]]);
      if (l > longest) {
        longest = l;
        k = i;
      }
    }
    const std::uint32_t u = tri[k], v = tri[(k + 1) % 3], apex = tri[(k + 2) % 3];
    const Half* other = find(u, v, t);
    if (!other || changed.contains(other->face)) return kNone;
    const std::uint32_t o = other->face, w = mesh_.triangles[o][(other->corner + 2) % 3];
    const auto name = std::pair(std::min(apex, w), std::max(apex, w));
    // Of edges between two vertices far from creases not all are known.
    if (!on_line(apex) && !on_line(w)) return kNone;
    if (w == apex || find(apex, w, kNone) || fresh_.contains(name)) return kNone;
    const Vec3 normal = side_normal(o);
    const double before =
        std::min(quality(tri, side_normal(t)), quality(mesh_.triangles[o], normal));
    const Triangle a{u, w, apex}, b{w, v, apex};
    if (!(std::min(quality(a, normal), quality(b, normal)) > std::max(before, 0.0))) return kNone;
    mesh_.triangles[t] = a;
    mesh_.triangles[o] = b;
    mesh_.side[t] = mesh_.side[o];
    fresh_.insert(name);
    return o;
  }

  static constexpr std::uint32_t kNone = EdgePoints::kNone;
  ExactMesh& mesh_;
  std::vector<std::uint8_t> near_;
  std::vector<Half> edges_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> fresh_;
};

}  // namespace

void flip_slivers(ExactMesh& mesh) { Flipper(mesh).run(); }

}  // namespace burin
