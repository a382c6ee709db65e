#include "ridge.h"

#include <burin/base/disjoint_sets.h>

#include <algorithm>
#include <limits>
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

constexpr std::uint32_t kNoRidge = std::numeric_limits<std::uint32_t>::max();

/// A wall over one stretch of the ridge: its points there, and how far aside it stands.
struct Piece {
  std::uint32_t low = 0, high = 0, middle = kNoRidge;
  double aside = 0;
};

class Builder {
 public:
  Builder(const Cap& cap, const std::vector<Vec2>& top, const std::vector<Vec2>& wide, int along)
      : cap_(cap), top_(top), wide_(wide), along_(along), ranks_(rank(top, along)), loose_(top) {
    stretches_.resize(ranks_.places.size());
    walls_.resize(ranks_.places.size());
  }

  /// At first every point of the rim, and every place that an edge passes, has a point of its own;
  /// then those become one that belong together.
  void run(Ridge& out) {
    count_walls();
    for (const Cap::Edge& edge : cap_.rim) out.chains.push_back(chain(edge));
    DisjointSets sets(loose_.size());
    for (const auto& [a, b] : same_) sets.join(a, b);
    for (auto& pieces : stretches_) pair(pieces, sets);
    std::vector<std::uint32_t> number(loose_.size());
    for (std::uint32_t i = 0; i < loose_.size(); ++i) {
      const std::uint32_t set = sets.find(i);
      number[i] = set == i ? static_cast<std::uint32_t>(out.points.size()) : number[set];
      if (set == i) out.points.push_back(loose_[i]);
    }
    for (auto& points : out.chains) {
      for (std::uint32_t& p : points) p = number[p];
    }
  }

 private:
  void count_walls() {
    for (const Cap::Edge& edge : cap_.rim) {
      const auto [low, high] = std::minmax(ranks_.of[edge.from], ranks_.of[edge.to]);
      for (std::uint32_t k = low; k < high; ++k) ++walls_[k];
    }
  }
  std::uint32_t new_point(double place) {
    loose_.emplace_back(0);
    loose_.back()[along_] = place;
    return static_cast<std::uint32_t>(loose_.size()) - 1;
  }

  std::vector<std::uint32_t> chain(const Cap::Edge& edge) {
    std::vector<std::uint32_t> out{edge.from};
    const std::uint32_t first = ranks_.of[edge.from], last = ranks_.of[edge.to];
    if (first == last) same_.emplace_back(edge.from, edge.to);
    const bool up = first < last;
    for (std::uint32_t k = first; k != last;) {
      const std::uint32_t to = up ? k + 1 : k - 1, stretch = std::min(k, to);
      const double half = 0.5 * (ranks_.places[k] + ranks_.places[to]);
      Piece piece;
      piece.aside = aside(edge, half);
      const std::uint32_t before = out.back();
      // Two pairs of walls between the same two points meet on edges of their own.
      if (walls_[stretch] > 2) out.push_back(piece.middle = new_point(half));
      out.push_back(to == last ? edge.to : new_point(ranks_.places[to]));
      piece.low = up ? before : out.back();
      piece.high = up ? out.back() : before;
      stretches_[stretch].push_back(piece);
      k = to;
    }
    return out;
  }
  double aside(const Cap::Edge& edge, double place) const {
    const double begin = top_[edge.from][along_], end = top_[edge.to][along_];
    return glm::mix(wide_[edge.from][1 - along_], wide_[edge.to][1 - along_],
                    (place - begin) / (end - begin));
  }

  /// The inside lies between the first and the second, the third and the fourth ...
  static void pair(std::vector<Piece>& pieces, DisjointSets& sets) {
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.aside < b.aside; });
    for (std::size_t i = 0; i + 1 < pieces.size(); i += 2) {
      const Piece &a = pieces[i], &b = pieces[i + 1];
      sets.join(a.low, b.low);
      sets.join(a.high, b.high);
      if (a.middle != kNoRidge) sets.join(a.middle, b.middle);
    }
  }

  const Cap& cap_;
  const std::vector<Vec2>&top_, &wide_;
  int along_;
  Ranks ranks_;
  std::vector<Vec2> loose_;
  std::vector<std::vector<Piece>> stretches_;
  std::vector<std::uint32_t> walls_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> same_;
};

}  // namespace

Ridge::Ridge(const Cap& cap, const std::vector<Vec2>& top, const std::vector<Vec2>& wide,
             int along) {
  Builder(cap, top, wide, along).run(*this);
}

}  // namespace burin::csg
