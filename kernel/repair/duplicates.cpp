#include <burin/base/disjoint_sets.h>

#include "stages.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::repair_stages {
namespace {

/// Whether the corners come in the same cyclic order as when sorted.
bool is_even(const Triangle& t) { return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2; }

enum class Copy : std::uint8_t { None, Twin, Same };

struct Copies {
  std::vector<Copy> kind;
  /// For each triangle the first one with its corners.
  std::vector<std::uint32_t> first;
};

/// The first triangle of each three corners, one that faces it (its twin), and further copies.
Copies find_copies(const TriMesh& mesh, const RunContext& context) {
  struct Entry {
    Triangle corners;
    std::uint32_t triangle;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  entries.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle sorted = mesh.triangles[t];
    std::sort(sorted.begin(), sorted.end());
    entries.push_back({sorted, t});
  }
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    context.check();
    return a < b;
  });
  Copies copies;
  copies.kind.assign(mesh.triangles.size(), Copy::None);
  copies.first.resize(mesh.triangles.size());
  for (std::size_t i = 0, next = 0; i < entries.size(); i = next) {
    const std::uint32_t first = entries[i].triangle;
    const bool even = is_even(mesh.triangles[first]);
    bool has_twin = false;
    copies.first[first] = first;
    for (next = i + 1; next < entries.size() && entries[next].corners == entries[i].corners;
         ++next) {
      const std::uint32_t t = entries[next].triangle;
      const bool faces = is_even(mesh.triangles[t]) != even;
      copies.first[t] = first;
      copies.kind[t] = faces && !has_twin ? Copy::Twin : Copy::Same;
      has_twin |= faces;
    }
  }
  return copies;
}

/// What the edges say about the copies of one kind, a patch of connected ones at a time.
class Patches {
 public:
  Patches(const Copies& copies, Copy kind)
      : copies_(copies), kind_(kind), sets_(copies.kind.size()), votes_(copies.kind.size(), 0) {}

  /// One more edge; `votes` counts for keeping the copies at it.
  void add_edge(std::span<const std::uint32_t> group, int votes) {
    std::uint32_t patch = kNone;
    for (const std::uint32_t h : group) {
      if (copies_.kind[h / 3] != kind_) continue;
      if (patch == kNone) votes_[h / 3] += votes;
      if (patch != kNone) sets_.join(patch, h / 3);
      patch = h / 3;
    }
  }
  /// Marks the triangles to drop: patches that no edge wants to keep.
  void mark(std::vector<std::uint8_t>& drop) {
    std::vector<int> total(votes_.size(), 0);
    for (std::uint32_t t = 0; t < votes_.size(); ++t) total[sets_.find(t)] += votes_[t];
    for (std::uint32_t t = 0; t < votes_.size(); ++t) {
      if (copies_.kind[t] == kind_ && total[sets_.find(t)] <= 0) drop[t] = 1;
    }
  }

 private:
  const Copies& copies_;
  Copy kind_;
  DisjointSets sets_;
  std::vector<int> votes_;
};

}  // namespace

void join_tiny_edges(TriMesh& mesh) {
  DisjointSets sets(mesh.positions.size());
  bool any = false;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const Vec3 p = glm::abs(mesh.positions[a]), q = glm::abs(mesh.positions[b]);
      const double size = std::max({p.x, p.y, p.z, q.x, q.y, q.z});
      const double rounding = 4 * std::numeric_limits<double>::epsilon() * size;
      if (a == b || glm::length(mesh.positions[a] - mesh.positions[b]) > rounding) continue;
      sets.join(a, b);
      any = true;
    }
  }
  if (!any) return;
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = sets.find(v);
  }
}

std::int64_t drop_duplicates(TriMesh& mesh, Numbers* of, const RunContext& context) {
  const Copies copies = find_copies(mesh, context);
  if (std::ranges::all_of(copies.kind, [](Copy c) { return c == Copy::None; })) return 0;
  Patches twins(copies, Copy::Twin), same(copies, Copy::Same);
  std::vector<std::uint8_t> is_twin(mesh.triangles.size(), 0);  // either of the two
  for (std::uint32_t t = 0; t < is_twin.size(); ++t) {
    if (copies.kind[t] == Copy::Twin) is_twin[t] = is_twin[copies.first[t]] = 1;
  }
  const EdgeGroups edges = group_edges(mesh, context);
  for (std::size_t g = 0; g < edges.size(); ++g) {
    const auto group = edges[g];
    int with = 0, without = 0, others = 0;
    const std::uint32_t low = std::min(from(mesh, group[0]), to(mesh, group[0]));
    for (const std::uint32_t h : group) {
      const int way = from(mesh, h) == low ? 1 : -1;
      with += way;
      if (copies.kind[h / 3] != Copy::Same) without += way;
      others += is_twin[h / 3] == 0;
    }
    twins.add_edge(group, others);
    // A copy may be what closes the surface, where solids overlap; a body written twice is closed
    // without.
    same.add_edge(group, (with == 0 && without != 0) - (with != 0 && without == 0));
  }
  std::vector<std::uint8_t> drop(mesh.triangles.size(), 0);
  twins.mark(drop);
  same.mark(drop);
  for (std::uint32_t t = 0; t < drop.size(); ++t) {
    if (drop[t]) mesh.triangles[t] = {0, 0, 0};
  }
  return erase_triangles(mesh, of, repeats_corner);
}

}  // namespace burin::repair_stages
