#include "plane_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace burin::field {
namespace {

// Planes are parallel, and their directions alike, within this angle (radians): the rounding of
// files.
constexpr double kParallel = 1e-4;
// Rounds over all planes; each only makes neighbours differ more.
constexpr int kRounds = 4;

/// Parallel planes with one cross, which are drawn alike.
struct Group {
  std::vector<std::size_t> patches;
  Vec3 normal{0};
  CrossDirections arms;
  double area = 0;
  bool free = true;
  bool swapped = false;

  Vec3 direction() const { return swapped ? arms.second : arms.first; }
};

bool same_line(Vec3 a, Vec3 b) { return glm::length(glm::cross(a, b)) < kParallel; }

class Chooser {
 public:
  Chooser(const ProxyMesh& proxy, FlatPatches& flats) : proxy_(proxy), flats_(flats) {}

  void run() {
    make_groups();
    measure_borders();
    std::vector<std::size_t> order(groups_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t g) { return groups_[g].area; });
    // The largest first, against those that are decided; then all against all.
    std::vector<std::uint8_t> decided(groups_.size(), 0);
    for (std::size_t g = 0; g < groups_.size(); ++g) decided[g] = !groups_[g].free;
    for (int round = 0; round < kRounds; ++round) {
      for (const std::size_t g : order) {
        if (groups_[g].free) choose(g, decided);
        decided[g] = 1;
      }
    }
    for (const Group& group : groups_) {
      for (const std::size_t p : group.patches) {
        if (group.swapped) flats_.patches[p].swap_families();
      }
    }
  }

 private:
  void make_groups() {
    const std::size_t n = flats_.patches.size();
    std::vector<double> area(n, 0);
    std::vector<std::uint8_t> free(n, 1);
    for (std::uint32_t f = 0; f < flats_.face_patch.size(); ++f) {
      const std::int32_t p = flats_.face_patch[f];
      if (p < 0) continue;
      area[static_cast<std::size_t>(p)] += proxy_.mesh.area(f);
      for (std::size_t h = 3 * std::size_t{f}; h < 3 * std::size_t{f} + 3; ++h) {
        if (proxy_.edge_kind[h] != EdgeKind::Smooth) continue;
        if (flats_.face_patch[face_of(proxy_.topology.opposite[h])] != p) {
          free[static_cast<std::size_t>(p)] = 0;
        }
      }
    }
    group_.resize(n);
    for (std::size_t p = 0; p < n; ++p) {
      const FlatPatch& patch = flats_.patches[p];
      const bool is_free = free[p] != 0 && !patch.center;
      const auto alike = [&](const Group& g) {
        return is_free && g.free && same_line(g.normal, patch.normal) &&
               same_line(g.arms.first, patch.arms.first);
      };
      const auto found = std::ranges::find_if(groups_, alike);
      group_[p] = static_cast<std::size_t>(found - groups_.begin());
      if (found == groups_.end()) groups_.push_back({{}, patch.normal, patch.arms, 0, is_free});
      groups_[group_[p]].patches.push_back(p);
      groups_[group_[p]].area += area[p];
    }
  }

  void measure_borders() {
    borders_.resize(groups_.size());
    for (std::size_t h = 0; h < proxy_.edge_kind.size(); ++h) {
      const auto half_edge = static_cast<HalfEdge>(h);
      if (!proxy_.is_crease(half_edge)) continue;
      const std::int32_t p = flats_.face_patch[face_of(half_edge)];
      const std::int32_t q = flats_.face_patch[face_of(proxy_.topology.opposite[h])];
      if (p < 0 || q < 0) continue;
      const std::size_t a = group_[static_cast<std::size_t>(p)],
                        b = group_[static_cast<std::size_t>(q)];
      if (a == b || flats_.patches[static_cast<std::size_t>(q)].center) continue;
      const Vec3 &from = proxy_.mesh.positions[origin(proxy_.mesh, half_edge)],
                 &to = proxy_.mesh.positions[origin(proxy_.mesh, next_in_face(half_edge))];
      borders_[a][b] += glm::distance(from, to);
    }
  }

  void choose(std::size_t g, const std::vector<std::uint8_t>& decided) {
    double alike[2] = {0, 0};  // with the first arm, with the second one
    for (const auto& [other, length] : borders_[g]) {
      if (!decided[other]) continue;
      const Vec3 d = groups_[other].direction();
      const double a = glm::dot(d, groups_[g].arms.first), b = glm::dot(d, groups_[g].arms.second);
      alike[0] += length * a * a;
      alike[1] += length * b * b;
    }
    // Where both are as good the first one stays, whatever the rounding.
    groups_[g].swapped = alike[0] > alike[1] * (1 + 1e-6);
  }

  const ProxyMesh& proxy_;
  FlatPatches& flats_;
  std::vector<std::size_t> group_;
  std::vector<Group> groups_;
  std::vector<std::map<std::size_t, double>> borders_;
};

}  // namespace

void make_planes_differ(const ProxyMesh& proxy, FlatPatches& flats) { Chooser(proxy, flats).run(); }

}  // namespace burin::field
