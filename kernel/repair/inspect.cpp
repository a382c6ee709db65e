#include <burin/base/parallel.h>

#include "stages.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace burin::repair_stages {
namespace {

/// One triangle at a vertex: the fan goes on from `next` to `prev`.
struct Spoke {
  std::uint32_t next, prev;
};

/// The triangles at one vertex: whether they are one disc (ends = 0) or half disc (ends = 1).
struct Fan {
  bool manifold = true;
  bool open = false;
};

/// Spokes by the vertex they leave for. Few of them are searched faster than sorted.
class Leaving {
 public:
  explicit Leaving(std::span<Spoke> spokes) : spokes_(spokes), sorted_(spokes.size() > 12) {
    if (sorted_) std::ranges::sort(spokes_, {}, &Spoke::next);
  }
  const Spoke* find(std::uint32_t v) const {
    if (!sorted_) {
      for (const Spoke& s : spokes_) {
        if (s.next == v) return &s;
      }
      return nullptr;
    }
    const auto it = std::ranges::lower_bound(spokes_, v, {}, &Spoke::next);
    return it != spokes_.end() && it->next == v ? &*it : nullptr;
  }

 private:
  std::span<Spoke> spokes_;
  bool sorted_;
};

Fan fan_of(std::span<Spoke> spokes) {
  const Leaving leaving(spokes);
  std::uint32_t ends = 0, end = 0, odd = 0;
  for (const Spoke& s : spokes) {
    odd ^= s.next ^ s.prev;  // what is left of a chain are its two ends
    if (leaving.find(s.prev) == nullptr) {
      ++ends;
      end = s.prev;
    }
  }
  if (ends > 1) return {false, true};
  // A walk around a disc or half disc meets every spoke once. With an edge used twice in one
  // direction, or a second fan, it misses some.
  const Spoke* start = ends == 1 ? leaving.find(odd ^ end) : leaving.find(spokes[0].next);
  std::size_t reached = 0;
  const Spoke* s = start;
  while (s != nullptr && reached <= spokes.size()) {
    ++reached;
    s = leaving.find(s->prev);
    if (s == start) break;
  }
  return {reached == spokes.size(), ends == 1};
}

}  // namespace

bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, bc = c - b;
  const double longest2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  double size = 0;
  for (const Vec3& p : {a, b, c}) {
    size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const Vec3 normal = glm::cross(ab, ac);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * size;
  return !(glm::dot(normal, normal) > rounding * rounding * longest2);
}

CornersOfVertex corners_of_vertices(const TriMesh& mesh) {
  CornersOfVertex out;
  out.start.assign(mesh.positions.size() + 1, 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++out.start[v];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& s : out.start) sum += s, s = sum;  // the end of each vertex' corners
  out.corner.resize(3 * mesh.triangles.size());
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    for (std::size_t k = 3; k-- > 0;) {
      out.corner[--out.start[mesh.triangles[t][k]]] = static_cast<std::uint32_t>(3 * t + k);
    }
  }
  return out;
}

Cleanness inspect(const TriMesh& mesh, const RunContext& context) {
  const CornersOfVertex at = corners_of_vertices(mesh);
  context.check();
  Cleanness result;
  result.open.assign(mesh.positions.size(), 0);
  std::atomic<bool> manifold{true}, flat{false};
  std::atomic<std::int64_t> boundary{0};
  const auto vertices = [&](std::size_t begin, std::size_t end) {
    std::vector<Spoke> spokes;
    std::int64_t open = 0;
    bool good = true;
    for (std::size_t v = begin; v < end; ++v) {
      spokes.clear();
      for (std::uint32_t i = at.start[v]; i < at.start[v + 1]; ++i) {
        const Triangle& t = mesh.triangles[at.corner[i] / 3];
        const std::uint32_t k = at.corner[i] % 3;
        spokes.push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
        good &= t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
      }
      if (spokes.empty()) continue;
      const Fan fan = fan_of(spokes);
      good &= fan.manifold;
      open += fan.open;
      result.open[v] = fan.open;
    }
    if (!good) manifold.store(false, std::memory_order_relaxed);
    boundary.fetch_add(open, std::memory_order_relaxed);
  };
  const auto triangles = [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Triangle& tri = mesh.triangles[t];
      if (is_flat(mesh.positions[tri[0]], mesh.positions[tri[1]], mesh.positions[tri[2]])) {
        flat.store(true, std::memory_order_relaxed);
        return;
      }
    }
  };
  parallel_for(mesh.triangles.size(), kFaceGrain, triangles, &context);
  parallel_for(mesh.positions.size(), kFaceGrain, vertices, &context);
  result.manifold = manifold;
  result.flat = flat;
  result.boundary_edges = boundary;
  return result;
}

void drop_unused_positions(TriMesh& mesh) {
  std::vector<std::uint32_t> place(mesh.positions.size(), kNone);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) place[v] = 0;
  }
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] == kNone) continue;
    mesh.positions[count] = mesh.positions[v];
    place[v] = count++;
  }
  if (count == place.size()) return;
  mesh.positions.resize(count);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = place[v];
  }
}

}  // namespace burin::repair_stages
