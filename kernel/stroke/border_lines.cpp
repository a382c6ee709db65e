#include "border_lines.h"

#include <burin/base/disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

constexpr double kMostMissing = 20;  // gaps: a step of the stair beside lines 1 degree off it
constexpr double kTipOfEnd = 3;      // gaps over which the direction of an end is measured
// Gaps that an end may lie beside the other's direction, or an arc beside its chord.
constexpr double kBesideTip = 0.5;
constexpr double kStraight = -0.97;  // cosine between the directions of both ends: 14 degrees
// Radians by which an arc may leave its chord otherwise than it comes back to it.
constexpr double kUneven = 0.25;
// Cosine: where a surface is seen more edge-on lines draw together.
constexpr double kSlantedBorder = 0.35;
constexpr std::size_t kNoTip = SIZE_MAX;

// An end of a line at the border of a region.
struct Tip {
  std::size_t line = 0;
  bool begin = false;
  Vec2 at{0}, outwards{0};
  double gap = 0;
  bool square = false;  // not at a contour, where what has one number need not be one line
  std::pair<std::uint32_t, std::int64_t> key{};  // what counts its turns, and their number
  std::size_t joined = kNoTip;                   // the tip that it goes on into
  double bend = 0;                               // ... and how (Bridge)
};

Tip tip_of(const LevelLine& line, std::size_t number, bool begin) {
  const std::vector<Vec2>& p = line.points;
  const auto at = [&](std::size_t i) { return begin ? i : p.size() - 1 - i; };
  Tip tip{.line = number, .begin = begin, .at = p[at(0)], .gap = line.gaps[at(0)]};
  std::size_t i = 1;
  while (i + 1 < p.size() && glm::distance(p[at(i)], tip.at) < kTipOfEnd * tip.gap) ++i;
  const double length = glm::distance(tip.at, p[at(i)]);
  if (length > 0) tip.outwards = (tip.at - p[at(i)]) / length;
  return tip;
}

// How a line goes on from one end to another one: along the chord, or along the arc of a circle, as
// beside a round border, which such a line touches and whose cells hide what is between.
struct Bridge {
  double length = 0;  // of the chord
  double bend = 0;    // radians from the chord to the arc at its begin, counterclockwise
};

// From the chord to a direction, counterclockwise.
double turn(Vec2 chord, Vec2 direction) {
  return std::atan2(cross2(chord, direction), glm::dot(chord, direction));
}

std::optional<Bridge> bridge(const Tip& a, const Tip& b) {
  const Vec2 chord = b.at - a.at;
  const double gap = std::min(a.gap, b.gap), length = glm::length(chord);
  if (a.line == b.line || length > kMostMissing * gap) return std::nullopt;
  if (glm::dot(a.outwards, chord) < 0 || glm::dot(b.outwards, chord) > 0) return std::nullopt;
  if (glm::dot(a.outwards, b.outwards) < kStraight &&
      std::abs(cross2(a.outwards, chord)) < kBesideTip * gap &&
      std::abs(cross2(b.outwards, chord)) < kBesideTip * gap) {
    return Bridge{length, 0};
  }
  const double begin = turn(chord, a.outwards), end = turn(chord, -b.outwards);
  if (!a.square || !b.square || std::abs(begin + end) > kUneven) return std::nullopt;
  // The directions are those of chords of both lines: the arc between them turns less than they do.
  const double bend = 0.5 * (begin - end) * length / (length + kTipOfEnd * gap);
  if (0.5 * length * std::abs(std::tan(0.5 * bend)) > kBesideTip * gap) return std::nullopt;
  return Bridge{length, bend};
}

// A place of such an arc, by its share of the way.
Vec2 place_on_arc(Vec2 from, Vec2 to, double bend, double share) {
  if (std::abs(bend) < 1e-6) return glm::mix(from, to, share);
  const Vec2 chord = to - from, left(-chord.y, chord.x);
  const double angle = bend * (2 * share - 1), round = 2 * std::sin(bend);
  return from + (0.5 + std::sin(angle) / round) * chord +
         (std::cos(angle) - std::cos(bend)) / round * left;
}

class Joiner {
 public:
  Joiner(const ViewRaster& raster, const WaveGraph& graph, std::vector<LevelLine>& lines)
      : raster_(raster), graph_(graph), lines_(lines) {}

  void run(const RunContext& context) {
    find_tips();
    pair_tips(context);
    std::vector<std::size_t> tip_at(2 * lines_.size(), kNoTip);  // of each line's begin and end
    for (std::size_t i = 0; i < tips_.size(); ++i) {
      tip_at[2 * tips_[i].line + (tips_[i].begin ? 0 : 1)] = i;
    }
    const auto joined = [&](std::size_t line, bool begin) {
      const std::size_t tip = tip_at[2 * line + (begin ? 0 : 1)];
      return tip == kNoTip ? kNoTip : tips_[tip].joined;
    };
    std::vector<LevelLine> out;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      // Chains begin at an end that goes on into nothing; of lines joined to a ring one does, too.
      const bool from_begin = joined(i, true) == kNoTip;
      if (lines_[i].points.empty() || (!from_begin && joined(i, false) != kNoTip)) continue;
      if (!from_begin) reverse(lines_[i]);
      std::size_t next = joined(i, !from_begin);
      LevelLine line = std::exchange(lines_[i], {});
      while (next != kNoTip) {
        const Tip& tip = tips_[next];
        LevelLine more = std::exchange(lines_[tip.line], {});
        if (!tip.begin) reverse(more);
        append(line, more, -tip.bend);
        next = joined(tip.line, !tip.begin);
      }
      out.push_back(std::move(line));
    }
    lines_ = std::move(out);
  }

 private:
  // Numbers of lines are comparable within a connected piece of the graph.
  std::vector<std::uint32_t> find_roots() const {
    std::vector<std::uint32_t> roots(graph_.nodes.size());
    for (const std::uint32_t i : graph_.order) {
      const std::int32_t l = graph_.parent_link[i];
      if (l < 0) {
        roots[i] = i;
        continue;
      }
      const WaveLink& link = graph_.links[static_cast<std::size_t>(l)];
      roots[i] = roots[link.b == i ? link.a : link.b];
    }
    return roots;
  }

  void find_tips() {
    const std::vector<std::uint32_t> roots = find_roots();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const LevelLine& line = lines_[i];
      if (line.closed || line.points.size() < 2) continue;
      for (const bool begin : {true, false}) {
        if (begin ? line.begin_inside : line.end_inside) continue;
        tips_.push_back(tip_of(line, i, begin));
        tips_.back().key = {roots[line.node], line.number};
        tips_.back().square = raster_.nearest(tips_.back().at).facing > kSlantedBorder;
      }
    }
    std::ranges::stable_sort(tips_, [](const Tip& a, const Tip& b) {
      return a.key != b.key ? a.key < b.key : a.at.x < b.at.x;
    });
  }

  // Nearest first; none to a ring.
  void pair_tips(const RunContext& context) {
    struct Pair {
      Bridge bridge;
      std::size_t a, b;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < tips_.size(); ++i) {
      if (i % 1024 == 0) context.check();
      const double reach = tips_[i].at.x + kMostMissing * tips_[i].gap;
      for (std::size_t j = i + 1; j < tips_.size(); ++j) {
        if (tips_[j].key != tips_[i].key || tips_[j].at.x > reach) break;
        if (const auto found = bridge(tips_[i], tips_[j])) pairs.push_back({*found, i, j});
      }
    }
    std::ranges::stable_sort(pairs, {}, [](const Pair& p) { return p.bridge.length; });
    DisjointSets chains(lines_.size());
    for (const auto& [way, a, b] : pairs) {
      const auto one = static_cast<std::uint32_t>(tips_[a].line),
                 other = static_cast<std::uint32_t>(tips_[b].line);
      if (tips_[a].joined != kNoTip || tips_[b].joined != kNoTip) continue;
      if (chains.find(one) == chains.find(other)) continue;
      chains.join(one, other);
      tips_[a].joined = b;
      tips_[b].joined = a;
      tips_[a].bend = way.bend;
      tips_[b].bend = -way.bend;
    }
  }

  // Hangs one line on another, over points as dense as those of the cells.
  void append(LevelLine& line, const LevelLine& more, double bend) const {
    const Vec2 from = line.points.back(), to = more.points.front();
    const double gap = line.gaps.back(), other = more.gaps.front();
    const auto steps = static_cast<int>(std::ceil(2 * glm::distance(from, to) / raster_.pitch));
    for (int k = 1; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      line.points.push_back(place_on_arc(from, to, bend, t));
      line.gaps.push_back(static_cast<float>(glm::mix(gap, other, t)));
    }
    // A line that passes a node is in two where both begin at it.
    const std::ptrdiff_t same = from == to ? 1 : 0;
    line.points.insert(line.points.end(), more.points.begin() + same, more.points.end());
    line.gaps.insert(line.gaps.end(), more.gaps.begin() + same, more.gaps.end());
    line.end_inside = more.end_inside;
  }

  static void reverse(LevelLine& line) {
    std::ranges::reverse(line.points);
    std::ranges::reverse(line.gaps);
    std::swap(line.begin_inside, line.end_inside);
  }

  const ViewRaster& raster_;
  const WaveGraph& graph_;
  std::vector<LevelLine>& lines_;
  std::vector<Tip> tips_;
};

}  // namespace

void join_along_borders(const ViewRaster& raster, const WaveGraph& graph,
                        std::vector<LevelLine>& lines, const RunContext& context) {
  Joiner(raster, graph, lines).run(context);
}

}  // namespace burin::detail
