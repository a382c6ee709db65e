#include <burin/base/disjoint_sets.h>
#include <burin/base/parallel.h>

#include "stages.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace burin::repair_stages {
namespace {

struct Component {
  std::vector<std::uint32_t> triangles;  // filled on need
  std::uint32_t first = kNone;           // its first triangle
  double volume = 0;
  Box3 box;
  bool closed = true;
};

class Outward {
 public:
  Outward(TriMesh& mesh, std::span<const std::uint8_t> open, const RunContext& context)
      : mesh_(mesh), open_(open), context_(context) {}
  std::int64_t run();

 private:
  void find_components();
  void list_triangles();
  std::vector<std::size_t> containers(std::size_t c);
  bool inside(std::size_t c, std::size_t of);
  double winding(Vec3 p, const Component& of) const;
  void turn(std::size_t c);

  TriMesh& mesh_;
  std::span<const std::uint8_t> open_;
  const RunContext& context_;
  std::vector<std::uint32_t> component_of_;  // by triangle
  std::vector<Component> components_;
  // Solid angles that may still be computed, about 5 s: a crowd of inverted pieces stays as it is
  // beyond it.
  std::size_t budget_ = 200'000'000;
};

void Outward::find_components() {
  DisjointSets sets(mesh_.positions.size());
  for (const Triangle& t : mesh_.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  context_.check();
  std::vector<std::uint32_t> number(mesh_.positions.size(), kNone);
  component_of_.resize(mesh_.triangles.size());
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Triangle& tri = mesh_.triangles[t];
    std::uint32_t& c = number[sets.find(tri[0])];
    if (c == kNone) {
      c = static_cast<std::uint32_t>(components_.size());
      components_.emplace_back().first = t;
    }
    component_of_[t] = c;
    Component& component = components_[c];
    // Volumes from a corner of the component itself: a far origin would eat the digits.
    const Vec3& o = mesh_.positions[mesh_.triangles[component.first][0]];
    const Vec3 &p = mesh_.positions[tri[0]], &q = mesh_.positions[tri[1]],
               &r = mesh_.positions[tri[2]];
    component.volume += glm::dot(p - o, glm::cross(q - o, r - o));
    for (const std::uint32_t v : tri) component.closed &= open_[v] == 0;
  }
}

void Outward::list_triangles() {
  for (std::uint32_t t = 0; t < component_of_.size(); ++t) {
    Component& c = components_[component_of_[t]];
    c.triangles.push_back(t);
    for (const std::uint32_t v : mesh_.triangles[t]) c.box.add(mesh_.positions[v]);
  }
}

/// How often the component winds around p, by the solid angles of its triangles. @cite
/// VanOosterom1983
double Outward::winding(Vec3 p, const Component& of) const {
  constexpr std::size_t kGrain = 8192;
  std::vector<double> sums((of.triangles.size() + kGrain - 1) / kGrain, 0);
  parallel_for(
      of.triangles.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
          const Triangle& t = mesh_.triangles[of.triangles[i]];
          const Vec3 a = mesh_.positions[t[0]] - p, b = mesh_.positions[t[1]] - p,
                     c = mesh_.positions[t[2]] - p;
          const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
          sum += std::atan2(
              glm::dot(a, glm::cross(b, c)),
              la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
        }
        sums[begin / kGrain] = sum;
      },
      &context_);
  return std::accumulate(sums.begin(), sums.end(), 0.0) / (2 * std::numbers::pi);
}

bool Outward::inside(std::size_t c, std::size_t of) {
  const Component &inner = components_[c], &outer = components_[of];
  for (int k = 0; k < 3; ++k) {
    if (inner.box.min[k] < outer.box.min[k] || inner.box.max[k] > outer.box.max[k]) return false;
  }
  if (budget_ < 3 * outer.triangles.size()) return false;
  budget_ -= 3 * outer.triangles.size();
  int votes = 0;  // of three places, should one touch the other component
  for (const std::size_t i :
       {std::size_t{0}, inner.triangles.size() / 3, 2 * inner.triangles.size() / 3}) {
    const Triangle& t = mesh_.triangles[inner.triangles[i]];
    const Vec3 p = (mesh_.positions[t[0]] + mesh_.positions[t[1]] + mesh_.positions[t[2]]) / 3.0;
    votes += std::abs(winding(p, outer)) > 0.75;
  }
  return votes >= 2;
}

std::vector<std::size_t> Outward::containers(std::size_t c) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < components_.size(); ++k) {
    if (k != c && components_[k].closed && inside(c, k)) out.push_back(k);
  }
  return out;
}

void Outward::turn(std::size_t c) {
  for (const std::uint32_t t : components_[c].triangles) {
    std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
  }
}

std::int64_t Outward::run() {
  find_components();
  const auto inverted = [](const Component& c) { return c.closed && c.volume < 0; };
  if (std::ranges::none_of(components_, inverted)) return 0;
  list_triangles();
  std::vector<std::uint8_t> turned(components_.size(), 0);
  for (std::size_t c = 0; c < components_.size(); ++c) {
    // An odd number of solids around it makes it the wall of a cavity, which rightly points
    // inwards.
    if (inverted(components_[c]) && containers(c).size() % 2 == 0) turned[c] = 1;
  }
  // Where a whole body was inside out, so are the walls of its cavities.
  std::vector<std::size_t> cavities;
  for (std::size_t c = 0; c < components_.size(); ++c) {
    if (!components_[c].closed || components_[c].volume <= 0) continue;
    bool near_turned = false;
    for (std::size_t k = 0; k < components_.size() && !near_turned; ++k) {
      near_turned = turned[k] && components_[k].box.overlaps(components_[c].box);
    }
    if (!near_turned) continue;
    const std::vector<std::size_t> around = containers(c);
    const bool in_turned =
        std::ranges::any_of(around, [&](std::size_t k) { return turned[k] != 0; });
    if (in_turned && around.size() % 2 == 1) cavities.push_back(c);
  }
  for (const std::size_t c : cavities) turned[c] = 1;
  for (std::size_t c = 0; c < components_.size(); ++c) {
    if (turned[c]) turn(c);
  }
  return std::accumulate(turned.begin(), turned.end(), std::int64_t{0});
}

}  // namespace

void orient_outwards(TriMesh& mesh, std::span<const std::uint8_t> open, Diagnostics& diagnostics,
                     const RunContext& context) {
  const std::int64_t turned = Outward(mesh, open, context).run();
  if (turned > 0) {
    diagnostics.add(Severity::Warning, "mesh.inverted", turned,
                    "closed surfaces were inside out and were turned");
  }
}

}  // namespace burin::repair_stages
