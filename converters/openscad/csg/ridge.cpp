#include "ridge.h"

#include <burin/base/disjoint_sets.h>

#include <algorithm>
#include <utility>

namespace burin::csg {
namespace {

// Of the ridge's length: rounding of what was meant equal.
constexpr double kSame = 1e-9;

/// The places on the ridge where points end, in order, and each point's number among them.
struct Ranks {
  std::vector<double> places;
  std::vector<std::uint32_t> of;
};

Ranks rank(const std::vector<Vec2>& top, int along) {
  Ranks out;
  if (along < 0) {
    out.of.assign(top.size(), 0);
    return out;
  }
  std::vector<double> all;
  for (const Vec2& p : top) all.push_back(p[along]);
  std::sort(all.begin(), all.end());
  const double slack = kSame * (all.back() - all.front());
  for (const double v : all) {
    if (out.places.empty() || v - out.places.back() > slack) out.places.push_back(v);
  }
  for (const Vec2& p : top) {
    const auto above = std::upper_bound(out.places.begin(), out.places.end(), p[along]);
    out.of.push_back(static_cast<std::uint32_t>(above - out.places.begin() - 1));
  }
  return out;
}

/// A wall over one stretch of the ridge: its points there, and how far aside it stands.
struct Piece {
  std::uint32_t low = 0, high = 0;
  double aside = 0;
};

}  // namespace

Ridge::Ridge(const Cap& cap, const std::vector<Vec2>& top, const std::vector<Vec2>& wide,
             int along) {
  const Ranks ranks = rank(top, along);
  // At first every point of the rim, and every place that an edge passes, has a point of its own.
  std::vector<Vec2> loose = top;
  std::vector<std::vector<Piece>> stretches(ranks.places.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> same;
  for (const Cap::Edge& edge : cap.rim) {
    std::vector<std::uint32_t>& chain = chains.emplace_back();
    chain.push_back(edge.from);
    const std::uint32_t first = ranks.of[edge.from], last = ranks.of[edge.to];
    if (first == last) same.emplace_back(edge.from, edge.to);
    const bool up = first < last;
    for (std::uint32_t k = first; k != last;) {
      const std::uint32_t to = up ? k + 1 : k - 1;
      std::uint32_t point = edge.to;
      if (to != last) {
        point = static_cast<std::uint32_t>(loose.size());
        loose.emplace_back(0);
        loose.back()[along] = ranks.places[to];
      }
      const double begin = top[edge.from][along], end = top[edge.to][along];
      const double t = (0.5 * (ranks.places[k] + ranks.places[to]) - begin) / (end - begin);
      const double aside = glm::mix(wide[edge.from][1 - along], wide[edge.to][1 - along], t);
      const std::uint32_t before = chain.back();
      stretches[std::min(k, to)].push_back({up ? before : point, up ? point : before, aside});
      chain.push_back(point);
      k = to;
    }
  }
  DisjointSets sets(loose.size());
  for (const auto& [a, b] : same) sets.join(a, b);
  for (auto& pieces : stretches) {
    // The inside lies between the first and the second, the third and the fourth ...
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.aside < b.aside; });
    for (std::size_t i = 0; i + 1 < pieces.size(); i += 2) {
      sets.join(pieces[i].low, pieces[i + 1].low);
      sets.join(pieces[i].high, pieces[i + 1].high);
    }
  }
  std::vector<std::uint32_t> number(loose.size());
  for (std::uint32_t i = 0; i < loose.size(); ++i) {
    const std::uint32_t set = sets.find(i);
    number[i] = set == i ? static_cast<std::uint32_t>(points.size()) : number[set];
    if (set == i) points.push_back(loose[i]);
  }
  for (auto& chain : chains) {
    for (std::uint32_t& p : chain) p = number[p];
  }
}

}  // namespace burin::csg
