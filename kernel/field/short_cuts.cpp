#include "short_cuts.h"

#include <burin/base/disjoint_sets.h>

#include "links.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace burin::field {
namespace {

// Cuts shorter than this share of the region's size (square root of its area) stay.
constexpr double kShort = 0.25;
// Other labels leave less than this share of the length of cuts ...
constexpr double kLeft = 0.5;
// ... and save this many times the region's size (square root of its area) for each tenth of it
// that follows the other family than is wanted.
constexpr double kWorth = 1.5;

class Router {
 public:
  Router(const ProxyMesh& proxy, const WedgeGraph& graph, const Links<double>& links,
         const RunContext& context)
      : proxy_(proxy), graph_(graph), links_(links), context_(context) {}

  void run(const std::vector<double>& pull, std::vector<double>& sign) {
    if (!any_cut(sign)) return;
    read_edges();
    std::vector<double> before = cut_lengths(sign);
    find_areas();
    for (std::size_t r = 0; r < before.size(); ++r) {
      if (before[r] < kShort * std::sqrt(area_[r])) before[r] = 0;
    }
    if (std::ranges::none_of(before, [](double length) { return length > 0; })) return;
    read_borders();
    find_odd(before);
    join_odd();
    std::vector<double> other = labels(sign);
    const std::vector<double> after = cut_lengths(other);
    const std::vector<std::uint8_t> better = worth(pull, sign, before, other, after);
    for (std::size_t w = 0; w < graph_.axis.size(); ++w) {
      if (better[static_cast<std::size_t>(graph_.region[w])]) sign[w] = other[w];
    }
  }

 private:
  // From an odd node to another one over these half-edges.
  struct Way {
    double length = std::numeric_limits<double>::infinity();
    std::uint32_t from = kNone, to = kNone;
    std::vector<std::uint32_t> crossed;
    bool operator>(const Way& o) const {
      return std::tuple(length, from) > std::tuple(o.length, o.from);
    }
  };

  // What a search knows of a node: the way so far ends with this side, from the node before.
  struct Met {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t side = kNone, before = kNone;
    bool done = false;
  };

  std::uint32_t faces() const { return static_cast<std::uint32_t>(proxy_.wedges.size()); }
  std::size_t region(std::uint32_t f) const {
    return static_cast<std::size_t>(graph_.region[proxy_.wedges[f][0]]);
  }

  bool any_cut(const std::vector<double>& sign) const {
    for (std::uint32_t w = 0; w < graph_.axis.size(); ++w) {
      for (std::uint32_t i = links_.first[w]; i < links_.first[w + 1]; ++i) {
        if (links_.coupling[i] * sign[w] * sign[links_.neighbour[i]] < 0) return true;
      }
    }
    return false;
  }

  void find_areas() {
    area_.assign(static_cast<std::size_t>(proxy_.region_count), 0);
    for (std::size_t w = 0; w < graph_.axis.size(); ++w) {
      area_[static_cast<std::size_t>(graph_.region[w])] += graph_.area[w];
    }
  }

  // Whether labels agree over the sides of triangles as they are; triangles without links are none.
  void read_edges() {
    agree_.assign(3 * static_cast<std::size_t>(faces()), 0);
    valid_.assign(faces(), 1);
    for (std::uint32_t f = 0; f < faces(); ++f) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = proxy_.wedges[f][k], b = proxy_.wedges[f][(k + 1) % 3];
        for (std::uint32_t i = links_.first[a]; i < links_.first[a + 1]; ++i) {
          if (links_.neighbour[i] == b) agree_[3 * f + k] = links_.coupling[i] < 0 ? -1 : 1;
        }
        if (agree_[3 * f + k] == 0) valid_[f] = 0;
      }
    }
  }

  // A border of a region is a node as triangles are: a cut may go along it for nothing.
  void read_borders() {
    const auto wedges = static_cast<std::uint32_t>(graph_.axis.size());
    DisjointSets sets(wedges);
    const auto for_sides = [&](const auto& body) {
      for (std::uint32_t h = 0; h < agree_.size(); ++h) {
        if (valid_[h / 3] && behind(h) == kNone) body(h, proxy_.wedges[h / 3][h % 3]);
      }
    };
    for_sides(
        [&](std::uint32_t h, std::uint32_t w) { sets.join(w, proxy_.wedges[h / 3][(h + 1) % 3]); });
    border_.assign(agree_.size(), kNone);
    std::vector<std::uint32_t> number(wedges, kNone);
    for_sides([&](std::uint32_t h, std::uint32_t w) {
      std::uint32_t& n = number[sets.find(w)];
      if (n == kNone) {
        n = static_cast<std::uint32_t>(sides_.size());
        sides_.emplace_back();
      }
      sides_[n].push_back(h);
      border_[h] = faces() + n;
    });
  }

  // Triangles and borders around which labels change an odd number of times.
  void find_odd(const std::vector<double>& before) {
    odd_.assign(faces() + sides_.size(), 0);
    const auto is_odd = [&](const std::vector<std::uint32_t>& sides) {
      bool odd = false;
      for (const std::uint32_t h : sides) odd ^= agree_[h] < 0;
      return odd && before[region(sides[0] / 3)] > 0;
    };
    for (std::uint32_t f = 0; f < faces(); ++f) {
      if (valid_[f]) odd_[f] = is_odd({3 * f, 3 * f + 1, 3 * f + 2});
    }
    for (std::size_t n = 0; n < sides_.size(); ++n) odd_[faces() + n] = is_odd(sides_[n]);
  }

  // The triangle behind a side in the same region.
  std::uint32_t behind(std::uint32_t h) const {
    if (proxy_.edge_kind[h] != EdgeKind::Smooth) return kNone;
    const auto g = static_cast<std::uint32_t>(face_of(proxy_.topology.opposite[h]));
    return valid_[g] ? g : kNone;
  }
  Vec3 center(std::uint32_t f) const {
    const auto& w = proxy_.wedges[f];
    return (proxy_.wedge_position(w[0]) + proxy_.wedge_position(w[1]) +
            proxy_.wedge_position(w[2])) /
           3.0;
  }
  double length(std::uint32_t h) const {
    const std::uint32_t f = h / 3, g = behind(h);
    if (g != kNone) return glm::distance(center(f), center(g));
    return glm::distance(center(f), 0.5 * (proxy_.wedge_position(proxy_.wedges[f][h % 3]) +
                                           proxy_.wedge_position(proxy_.wedges[f][(h + 1) % 3])));
  }

  std::vector<double> cut_lengths(const std::vector<double>& sign) const {
    std::vector<double> sum(static_cast<std::size_t>(proxy_.region_count), 0);
    for (std::uint32_t f = 0; f < faces(); ++f) {
      if (!valid_[f]) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * f + k, g = behind(h);
        if (g != kNone && g < f) continue;
        const double product =
            agree_[h] * sign[proxy_.wedges[f][k]] * sign[proxy_.wedges[f][(k + 1) % 3]];
        if (product < 0) sum[region(f)] += length(h);
      }
    }
    return sum;
  }

  // Regions whose other labels have cuts so much shorter that they may follow `pull` less.
  std::vector<std::uint8_t> worth(const std::vector<double>& pull, const std::vector<double>& sign,
                                  const std::vector<double>& before,
                                  const std::vector<double>& other,
                                  const std::vector<double>& after) const {
    std::vector<double> own(before.size(), 0), others(before.size(), 0);
    for (std::size_t w = 0; w < graph_.axis.size(); ++w) {
      const auto r = static_cast<std::size_t>(graph_.region[w]);
      own[r] += pull[w] * sign[w];
      others[r] += pull[w] * other[w];
    }
    std::vector<std::uint8_t> out(before.size(), 0);
    for (std::size_t r = 0; r < out.size(); ++r) {
      // All of a region's labels may change together.
      const double lost = own[r] - std::abs(others[r]);
      out[r] = after[r] < kLeft * before[r] &&
               before[r] - after[r] > kWorth * lost * std::sqrt(area_[r]);
    }
    return out;
  }

  Way nearest(std::uint32_t from) {
    using Entry = std::tuple<double, std::uint32_t>;  // distance, node
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    met_.resize(odd_.size());
    Way way;
    way.from = from;
    std::vector<std::uint32_t> touched{from};
    met_[from] = {0, kNone, from, false};
    queue.push({0, from});
    while (!queue.empty()) {
      // No structured binding: clang 14 has no way to capture one below.
      const double d = std::get<0>(queue.top());
      const std::uint32_t node = std::get<1>(queue.top());
      queue.pop();
      if (std::exchange(met_[node].done, true)) continue;
      if (odd_[node] && node != from) {
        way.length = d;
        way.to = node;
        for (std::uint32_t n = node; n != from; n = met_[n].before) {
          way.crossed.push_back(met_[n].side);
        }
        break;
      }
      const auto go = [&](std::uint32_t to, std::uint32_t h) {
        const double far = d + length(h);
        Met& m = met_[to];
        if (m.distance <= far) return;
        if (!std::isfinite(m.distance)) touched.push_back(to);
        m = {far, h, node, false};
        queue.push({far, to});
        if (touched.size() % 4096 == 0) context_.check();
      };
      if (node < faces()) {
        for (std::uint32_t h = 3 * node; h < 3 * node + 3; ++h) {
          go(behind(h) != kNone ? behind(h) : border_[h], h);
        }
      } else {
        for (const std::uint32_t h : sides_[node - faces()]) go(h / 3, h);
      }
    }
    for (const std::uint32_t n : touched) met_[n] = {};
    return way;
  }

  // The shortest first; what was to go to one that is joined by then looks again.
  void join_odd() {
    cut_.assign(agree_.size(), 0);
    std::priority_queue<Way, std::vector<Way>, std::greater<>> queue;
    for (std::uint32_t n = 0; n < odd_.size(); ++n) {
      if (odd_[n]) queue.push(nearest(n));
    }
    while (!queue.empty()) {
      const Way way = queue.top();
      queue.pop();
      if (!odd_[way.from] || way.crossed.empty()) continue;
      if (!odd_[way.to]) {
        queue.push(nearest(way.from));
        continue;
      }
      odd_[way.from] = odd_[way.to] = 0;
      for (const std::uint32_t h : way.crossed) {
        cut_[h] ^= 1;
        if (behind(h) != kNone) cut_[static_cast<std::size_t>(proxy_.topology.opposite[h])] ^= 1;
      }
    }
  }

  // What changes over cuts alone.
  std::vector<double> labels(const std::vector<double>& sign) const {
    std::vector<double> out = sign;
    std::vector<std::uint8_t> known(graph_.axis.size(), 0), seen(faces(), 0);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t seed = 0; seed < faces(); ++seed) {
      if (!valid_[seed] || seen[seed]) continue;
      known[proxy_.wedges[seed][0]] = 1;
      seen[seed] = 1;
      stack.push_back(seed);
      while (!stack.empty()) {
        const std::uint32_t f = stack.back();
        stack.pop_back();
        for (std::uint32_t i = 0; i < 6; ++i) {  // twice round
          const std::uint32_t a = proxy_.wedges[f][i % 3], b = proxy_.wedges[f][(i + 1) % 3];
          if (!known[a] || known[b]) continue;
          known[b] = 1;
          out[b] = out[a] * agree_[3 * f + i % 3] * (cut_[3 * f + i % 3] ? -1 : 1);
        }
        for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
          const std::uint32_t g = behind(h);
          if (g == kNone || seen[g]) continue;
          seen[g] = 1;
          stack.push_back(g);
        }
      }
    }
    return out;
  }

  const ProxyMesh& proxy_;
  const WedgeGraph& graph_;
  const Links<double>& links_;
  const RunContext& context_;
  std::vector<Met> met_;                           // nodes, as after no search
  std::vector<double> area_;                       // regions
  std::vector<signed char> agree_;                 // half-edges; 0: no link
  std::vector<std::uint8_t> valid_;                // triangles
  std::vector<std::uint8_t> odd_;                  // triangles and borders
  std::vector<std::uint8_t> cut_;                  // half-edges
  std::vector<std::vector<std::uint32_t>> sides_;  // of each border
  std::vector<std::uint32_t> border_;              // of half-edges: a node behind the triangles
};

}  // namespace

void shorten_cuts(const ProxyMesh& proxy, const WedgeGraph& graph, const Links<double>& links,
                  const std::vector<double>& pull, std::vector<double>& sign,
                  const RunContext& context) {
  Router(proxy, graph, links, context).run(pull, sign);
}

}  // namespace burin::field
