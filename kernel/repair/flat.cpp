#include "stages.h"

#include <algorithm>
#include <array>

namespace burin::repair_stages {
namespace {

class FlatRemover {
 public:
  FlatRemover(TriMesh& mesh, std::vector<std::uint32_t>& opposite, Numbers* of)
      : mesh_(mesh), opposite_(opposite), of_(of) {}
  void run(bool drop_all, RepairCounts& counts, const RunContext& context);
  void drop_pockets();

 private:
  bool flat(std::uint32_t t) const {
    const Triangle& v = mesh_.triangles[t];
    return v[0] != v[1] &&
           is_flat(mesh_.positions[v[0]], mesh_.positions[v[1]], mesh_.positions[v[2]]);
  }
  std::uint32_t longest(std::uint32_t t) const;
  bool joined(std::uint32_t h, std::uint32_t v) const;
  bool turn(std::uint32_t h);
  void drop(std::uint32_t t);
  void link(std::uint32_t h, std::uint32_t other) {
    opposite_[h] = other;
    if (other != kNone) opposite_[other] = h;
  }

  TriMesh& mesh_;
  std::vector<std::uint32_t>& opposite_;
  Numbers* of_;
};

std::uint32_t FlatRemover::longest(std::uint32_t t) const {
  const auto length2 = [&](std::uint32_t h) {
    const Vec3 d = mesh_.positions[to(mesh_, h)] - mesh_.positions[from(mesh_, h)];
    return glm::dot(d, d);
  };
  std::uint32_t best = 3 * t;
  for (std::uint32_t h = 3 * t + 1; h < 3 * t + 3; ++h) {
    if (length2(h) > length2(best)) best = h;
  }
  return best;
}

/// Whether an edge joins the vertex that half-edge h leaves to v, inside the fan of h.
bool FlatRemover::joined(std::uint32_t h, std::uint32_t v) const {
  const std::uint32_t start = h;
  do {  // counter-clockwise
    if (to(mesh_, h) == v || apex(mesh_, h) == v) return true;
    h = opposite_[prev_half_edge(h)];
  } while (h != kNone && h != start);
  if (h == start) return false;
  for (h = opposite_[start]; h != kNone; h = opposite_[h]) {  // clockwise
    h = next_half_edge(h);
    if (to(mesh_, h) == v || apex(mesh_, h) == v) return true;
  }
  return false;
}

/// x -> y with apex b, and y -> x with apex d, become x d b and d y b. The first has no area.
bool FlatRemover::turn(std::uint32_t h) {
  const std::uint32_t g = opposite_[h];
  const std::uint32_t x = from(mesh_, h), y = to(mesh_, h), b = apex(mesh_, h), d = apex(mesh_, g);
  if (b == d || h / 3 == g / 3 || joined(prev_half_edge(h), d)) return false;
  const std::uint32_t yb = opposite_[next_half_edge(h)], bx = opposite_[prev_half_edge(h)];
  const std::uint32_t xd = opposite_[next_half_edge(g)], dy = opposite_[prev_half_edge(g)];
  const std::uint32_t s = h / 3, t = g / 3;
  for (const std::uint32_t o : {yb, bx, xd, dy}) {
    if (o != kNone && (o / 3 == s || o / 3 == t)) return false;  // a pocket of two triangles
  }
  mesh_.triangles[s] = {x, d, b};
  mesh_.triangles[t] = {d, y, b};
  if (of_) (*of_)[s] = (*of_)[t];
  link(3 * s, xd);
  link(3 * s + 1, 3 * t + 2);
  link(3 * s + 2, bx);
  link(3 * t, dy);
  link(3 * t + 1, yb);
  return true;
}

void FlatRemover::drop(std::uint32_t t) {
  for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
    if (opposite_[h] != kNone) opposite_[opposite_[h]] = kNone;
    opposite_[h] = kNone;
  }
  mesh_.triangles[t] = {0, 0, 0};
}

void FlatRemover::run(bool drop_all, RepairCounts& counts, const RunContext& context) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (flat(t)) queue.push_back(t);
  }
  counts.flat += static_cast<std::int64_t>(queue.size());
  // Turns among triangles that are all on one line could go in circles.
  std::size_t turns_left = 8 * queue.size();
  for (std::size_t i = 0; i < queue.size(); ++i) {
    context.check();
    const std::uint32_t t = queue[i];
    if (!flat(t)) continue;
    const std::uint32_t h = longest(t);
    const std::uint32_t other = opposite_[h] == kNone ? kNone : opposite_[h] / 3;
    if (other != kNone && !drop_all && turns_left > 0 && turn(h)) {
      --turns_left;
      for (const std::uint32_t k : {t, other}) {
        if (flat(k)) queue.push_back(k);
      }
    } else {
      counts.flat_dropped += other != kNone;
      drop(t);
    }
  }
}

/// Two triangles back to back on all three edges.
void FlatRemover::drop_pockets() {
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    const std::uint32_t other = opposite_[3 * t];
    if (other == kNone || opposite_[3 * t + 1] == kNone || opposite_[3 * t + 2] == kNone) continue;
    if (opposite_[3 * t + 1] / 3 != other / 3 || opposite_[3 * t + 2] / 3 != other / 3) continue;
    drop(t);
    drop(other / 3);
  }
}

}  // namespace

void remove_flat(TriMesh& mesh, std::vector<std::uint32_t>& opposite, Numbers* of, bool drop,
                 RepairCounts& counts, const RunContext& context) {
  FlatRemover remover(mesh, opposite, of);
  remover.run(drop, counts, context);
  remover.drop_pockets();
}

}  // namespace burin::repair_stages
