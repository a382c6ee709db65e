#include "crease_chains.h"

#include <burin/base/nearest_along.h>

#include "../draft.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace burin {
namespace {

// Share of an edge's length that the crease may lie off its middle.
constexpr double kMostBent = 0.25;
// Cosine of the turn at a vertex from which it is a corner of the curve.
constexpr double kKink = 0.7;

const std::vector<CreaseVertex::Side>& sides_of(const ExactMesh& mesh, std::uint32_t v) {
  return mesh.creases[static_cast<std::size_t>(mesh.crease[v])].sides;
}

// Whether the crease passes by the middle of the edge.
bool follows_crease(const ExactMesh& mesh, const ImplicitFunction& f, std::uint32_t u,
                    std::uint32_t v) {
  const auto sides = common_sides(mesh, u, v);
  const Vec3 a = mesh.positions[u], b = mesh.positions[v], middle = 0.5 * (a + b);
  const double reach = kMostBent * glm::distance(a, b);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (find_crease(mesh, f, *sides[i].piece, *sides[j].piece, middle, reach)) return true;
    }
  }
  return false;
}

using Neighbours = std::map<std::uint32_t, std::vector<std::uint32_t>>;

Neighbours sharp_neighbours(const ExactMesh& mesh, const ImplicitFunction& f) {
  std::vector<Vec3> normals(3 * mesh.triangles.size(), Vec3(0));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.on_crease(mesh.triangles[t][k])) normals[3 * t + k] = mesh.corner_normal(t, k);
    }
  }
  const std::vector<std::uint8_t> sharp = sharp_halves(mesh, normals);
  Neighbours next;
  for (std::size_t h = 0; h < sharp.size(); ++h) {
    const std::uint32_t u = mesh.triangles[h / 3][h % 3], v = mesh.triangles[h / 3][(h + 1) % 3];
    if (!sharp[h] || u > v || !follows_crease(mesh, f, u, v)) continue;
    next[u].push_back(v);
    next[v].push_back(u);
  }
  return next;
}

// Without vertices next to one another: among these the order may be wrong.
std::vector<std::uint32_t> thinned(const ExactMesh& mesh, const std::vector<std::uint32_t>& chain) {
  constexpr double kNear = 0.4;  // steps
  const auto near = [&](std::uint32_t u, std::uint32_t v) {
    return glm::distance(mesh.positions[u], mesh.positions[v]) < kNear * mesh.step;
  };
  std::vector<std::uint32_t> kept{chain.front()};
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    if (!near(kept.back(), chain[i]) && !near(chain[i], chain.back())) kept.push_back(chain[i]);
  }
  kept.push_back(chain.back());
  // Around a hole of a step nothing is left.
  return kept.front() == kept.back() && kept.size() < 5 ? chain : kept;
}

// Parts between kinks.
void add_parts(const ExactMesh& mesh, const std::vector<std::uint32_t>& chain,
               CreaseChains& chains) {
  std::vector<std::uint32_t> part{chain.front()};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    part.push_back(chain[i]);
    if (i + 1 < chain.size()) {
      const Vec3 at = mesh.positions[chain[i]];
      const Vec3 a = normalize_or(at - mesh.positions[chain[i - 1]], Vec3(0)),
                 b = normalize_or(mesh.positions[chain[i + 1]] - at, Vec3(0));
      if (glm::dot(a, b) >= kKink) continue;
    }
    chains.push_back(part);
    part = {chain[i]};
  }
}

}  // namespace

std::vector<CreaseVertex::Side> common_sides(const ExactMesh& mesh, std::uint32_t u,
                                             std::uint32_t v) {
  std::vector<CreaseVertex::Side> common;
  for (const auto& s : sides_of(mesh, u)) {
    const auto same = [&](const auto& o) { return o.piece == s.piece; };
    if (std::ranges::any_of(sides_of(mesh, v), same)) common.push_back(s);
  }
  return common;
}

CreaseChains chain_creases(const ExactMesh& mesh, const ImplicitFunction& f) {
  CreaseChains chains;
  if (mesh.creases.empty()) return chains;
  Neighbours next = sharp_neighbours(mesh, f);
  const auto is_node = [&](std::uint32_t v) {
    return next.at(v).size() != 2 || sides_of(mesh, v).size() > 2;
  };
  std::map<std::uint32_t, bool> node;
  for (const auto& entry : next) node[entry.first] = is_node(entry.first);
  const auto take = [&](std::uint32_t u, std::uint32_t v) {
    std::erase(next[u], v);
    std::erase(next[v], u);
  };
  const auto follow = [&](std::uint32_t start, std::uint32_t to) {
    std::vector<std::uint32_t> chain{start};
    for (std::uint32_t at = start;;) {
      take(at, to);
      chain.push_back(to);
      at = to;
      if (at == start || node[at] || next[at].empty()) break;
      to = next[at].front();
    }
    add_parts(mesh, thinned(mesh, chain), chains);
  };
  for (const bool nodes : {true, false}) {
    for (const auto& [v, at_node] : node) {
      while (at_node == nodes && !next[v].empty()) follow(v, next[v].front());
    }
  }
  return chains;
}

std::uint64_t cell_key(glm::ivec3 c) {
  const auto part = [](int v) { return static_cast<std::uint64_t>(v + (1 << 20)) & 0x1fffff; };
  return part(c.x) | (part(c.y) << 21) | (part(c.z) << 42);
}

ChainFinder::ChainFinder(const ExactMesh& mesh, const CreaseChains& chains, double cell)
    : mesh_(mesh), cell_(cell) {
  if (!mesh.positions.empty()) origin_ = mesh.positions.front();
  for (const auto& chain : chains) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const auto name = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({chain[i], chain[i + 1], 0});
      Box3 box;
      box.add(mesh.positions[chain[i]]);
      box.add(mesh.positions[chain[i + 1]]);
      const glm::ivec3 low = cell_of(box.min) - 1, high = cell_of(box.max) + 1;
      for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
          for (int x = low.x; x <= high.x; ++x) cells_[cell_key({x, y, z})].push_back(name);
        }
      }
    }
  }
}

glm::ivec3 ChainFinder::cell_of(Vec3 p) const {
  return glm::ivec3(glm::floor((p - origin_) / cell_));
}

bool ChainFinder::find(Vec3 p, Place& place) const {
  const auto it = cells_.find(cell_key(cell_of(p)));
  if (it == cells_.end()) return false;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t e : it->second) {
    const Vec3 a = mesh_.positions[edges_[e].from], d = mesh_.positions[edges_[e].to] - a;
    const double s = nearest_along(a, d, p), gap = glm::distance(p, a + s * d);
    if (gap >= least) continue;
    least = gap;
    place = edges_[e];
    place.nearest = s < 0.5 ? place.from : place.to;
  }
  return true;
}

}  // namespace burin
