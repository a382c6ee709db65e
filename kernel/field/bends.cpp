#include "bends.h"

#include <burin/base/box.h>
#include <burin/base/parallel.h>

#include "links.h"
#include "multigrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace burin::field {
namespace {

// Half the width of the band in which lines turn: this share of the cut's extent ...
constexpr double kOfCut = 0.5;
// ... but no more than this share of the region's size (square root of its area).
constexpr double kOfRegion = 0.09;
// Lines of unit length are smoothed once more over this share of the band's width.
constexpr double kFinish = 0.1;
constexpr int kFinishSweeps = 6;

class Bender {
 public:
  Bender(const ProxyMesh& proxy, const WedgeGraph& graph, const Constraints& targets,
         std::vector<Vec2>& line, const RunContext& context)
      : proxy_(proxy), graph_(graph), targets_(targets), line_(line), context_(context) {}

  void run() {
    carry();
    find_cuts();
    if (sources_.empty()) return;
    measure_regions();
    spread();
    solve();
  }

 private:
  const Links<Vec2>& links() const { return graph_.crosses; }

  // How lines come over each link.
  void carry() {
    turn_.resize(links().neighbour.size());
    cut_.assign(links().size(), 0);
    parallel_for(
        links().size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t w = begin; w < end; ++w) {
            for (std::uint32_t k = links().first[w]; k < links().first[w + 1]; ++k) {
              const std::uint32_t j = links().neighbour[k];
              turn_[k] =
                  complex_square(wedge_turn(proxy_, graph_, j, static_cast<std::uint32_t>(w)));
              if (glm::dot(line_[w], complex_mul(turn_[k], line_[j])) < 0) cut_[w] = 1;
            }
          }
        },
        &context_);
  }

  // Wedges at a cut, one group a connected cut.
  void find_cuts() {
    std::vector<std::uint8_t> seen(cut_.size(), 0);
    std::vector<std::uint32_t> group;
    for (std::uint32_t seed = 0; seed < cut_.size(); ++seed) {
      if (!cut_[seed] || seen[seed]) continue;
      group.assign(1, seed);
      seen[seed] = 1;
      Box3 box;
      for (std::size_t i = 0; i < group.size(); ++i) {
        box.add(proxy_.wedge_position(group[i]));
        for (std::uint32_t k = links().first[group[i]]; k < links().first[group[i] + 1]; ++k) {
          const std::uint32_t j = links().neighbour[k];
          if (!cut_[j] || seen[j]) continue;
          seen[j] = 1;
          group.push_back(j);
        }
      }
      for (const std::uint32_t w : group) sources_.push_back({w, kOfCut * box.diagonal()});
    }
  }

  void measure_regions() {
    region_size_.assign(static_cast<std::size_t>(proxy_.region_count), 0);
    for (std::size_t w = 0; w < links().size(); ++w) {
      region_size_[static_cast<std::size_t>(graph_.region[w])] += graph_.area[w];
    }
    for (double& size : region_size_) size = std::sqrt(size);
  }

  // For each wedge the distance to the nearest cut as a share of that cut's band; 1 outside.
  void spread() {
    struct Reached {
      double distance;
      std::uint32_t wedge;
      double width;
      bool operator>(const Reached& other) const {
        return std::pair(distance, wedge) > std::pair(other.distance, other.wedge);
      }
    };
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    distance_.assign(links().size(), 1);
    width_.assign(links().size(), 0);
    for (const Source& s : sources_) {
      const auto region = static_cast<std::size_t>(graph_.region[s.wedge]);
      const double width = std::min(s.width, kOfRegion * region_size_[region]);
      if (!(width > 0)) continue;
      distance_[s.wedge] = 0;
      queue.push({0, s.wedge, width});
    }
    std::vector<std::uint8_t> done(links().size(), 0);
    while (!queue.empty()) {
      const Reached at = queue.top();
      queue.pop();
      if (done[at.wedge]) continue;
      done[at.wedge] = 1;
      band_.push_back(at.wedge);
      width_[at.wedge] = at.width;
      if (band_.size() % kGrain == 0) context_.check();
      for (std::uint32_t k = links().first[at.wedge]; k < links().first[at.wedge + 1]; ++k) {
        const std::uint32_t j = links().neighbour[k];
        const double step =
            glm::distance(proxy_.wedge_position(at.wedge), proxy_.wedge_position(j)) / at.width;
        if (at.distance + step >= distance_[j]) continue;
        distance_[j] = at.distance + step;
        queue.push({distance_[j], j, at.width});
      }
    }
    std::ranges::sort(band_);
  }

  // The line that is wanted at a wedge: the arm of the wanted cross that is nearest to the line.
  Vec2 wanted(std::uint32_t w) const {
    const Vec2 cross = targets_.pull[w];
    const double size = glm::length(cross);
    if (!(size > 0)) return line_[w];
    const Vec2 arm = complex_sqrt(cross / size);
    return glm::dot(arm, line_[w]) < 0 ? -arm : arm;
  }

  // A system of the band alone.
  void solve() {
    std::vector<std::uint32_t> node(links().size(), kNone);
    for (std::uint32_t i = 0; i < band_.size(); ++i) node[band_[i]] = i;
    Links<Vec2> inner;
    std::vector<double> mass(band_.size(), 0);
    std::vector<Vec2> pull(band_.size(), Vec2(0));
    for (std::size_t i = 0; i < band_.size(); ++i) {
      const std::uint32_t w = band_[i];
      double stiffness = 0;
      for (std::uint32_t k = links().first[w]; k < links().first[w + 1]; ++k) {
        const std::uint32_t j = links().neighbour[k];
        const double weight = glm::length(links().coupling[k]);
        if (node[j] == kNone) {  // lines outside stay as they are
          mass[i] += weight;
          pull[i] += weight * complex_mul(turn_[k], line_[j]);
        } else {
          inner.neighbour.push_back(node[j]);
          inner.coupling.push_back(weight * turn_[k]);
          stiffness += weight;
        }
      }
      inner.first.push_back(static_cast<std::uint32_t>(inner.neighbour.size()));
      inner.stiffness.push_back(stiffness);
      const double t = targets_.certain[w] ? 1 : std::min(1.0, distance_[w]);
      const double trust = t * t * (3 - 2 * t);
      const double own = trust * targets_.mass[w];
      mass[i] += own;
      pull[i] += own * wanted(w);
    }
    std::vector<Vec2> solved = minimise(Hierarchy<Vec2>(inner, context_), mass, pull, context_);
    // Where opposite lines meet the smooth solution is short rather than turned: it is made whole
    // and smoothed again.
    for (std::size_t i = 0; i < band_.size(); ++i) {
      const double reach = kFinish * width_[band_[i]], size = glm::length(solved[i]);
      const double kept = graph_.area[band_[i]] / (reach * reach);
      mass[i] += kept;
      if (!(size > 0)) continue;
      solved[i] /= size;
      pull[i] += kept * solved[i];
    }
    relax(inner, mass, pull, solved, kFinishSweeps, context_);
    for (std::size_t i = 0; i < band_.size(); ++i) {
      const double size = glm::length(solved[i]);
      if (size > 0) line_[band_[i]] = solved[i] / size;
    }
  }

  struct Source {
    std::uint32_t wedge;
    double width;
  };

  const ProxyMesh& proxy_;
  const WedgeGraph& graph_;
  const Constraints& targets_;
  std::vector<Vec2>& line_;
  const RunContext& context_;
  std::vector<Vec2> turn_;
  std::vector<std::uint8_t> cut_;
  std::vector<Source> sources_;
  std::vector<double> region_size_;
  std::vector<double> distance_, width_;
  std::vector<std::uint32_t> band_;
};

}  // namespace

void bend_over_cuts(const ProxyMesh& proxy, const WedgeGraph& graph, const Constraints& targets,
                    std::vector<Vec2>& line, const RunContext& context) {
  Bender(proxy, graph, targets, line, context).run();
}

}  // namespace burin::field
