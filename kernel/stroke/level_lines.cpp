#include "level_lines.h"

#include "level_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

constexpr double kLeastLength = 2;   // gaps: of a line that ends inside at both ends
constexpr int kPasses = 4;           // of smoothing
constexpr int kTipSteps = 64;        // crossings at the most to the place by which a tip is judged
constexpr double kTipLength = 1.5;   // gaps from a tip to there: nearer by, lines give way to it
constexpr double kBesideLine = 0.5;  // gaps that a line may be moved aside to go on as another
constexpr double kBesideEnd = 8;     // gaps from a tip within which lines make room for it
constexpr std::int64_t kMostReach = 64;  // ... in cells, at the most
constexpr double kOpposite = -0.7;       // cosine between the ways of two that may go on so

// The whole turns between two phases, each at least as large as the first + 1: (low, high].
struct Turns {
  std::int64_t first = 0, count = 0;
};
Turns turns_between(double a, double b) {
  const double low = std::min(a, b), high = std::max(a, b);
  const auto under = static_cast<std::int64_t>(std::floor(low / kTurn));
  return {under + 1, static_cast<std::int64_t>(std::floor(high / kTurn)) - under};
}

// A corner of a triangle as seen from its first one: phase = sign * own phase + whole turns.
struct Corner {
  std::uint32_t node = 0;
  double phase = 0;
  double sign = 1;
};

class Marcher {
 public:
  Marcher(const ViewRaster& raster, const WaveGraph& graph, const WavePhase& phase,
          const RunContext& context)
      : raster_(raster), graph_(graph), phase_(phase), context_(context) {
    unwrap();
    offset_.reserve(graph.links.size() + 1);
    offset_.push_back(0);
    for (std::size_t l = 0; l < graph.links.size(); ++l) {
      const double a = phase.at[graph.links[l].a];
      offset_.push_back(offset_.back() +
                        static_cast<std::uint32_t>(turns_between(a, a + phase.advance[l]).count));
    }
    next_.assign(offset_.back(), {kNone, kNone});
    inside_.assign(graph.links.size(), false);
  }

  std::vector<LevelLine> lines() {
    link_of_.resize(next_.size());
    for (std::uint32_t l = 0; l < graph_.links.size(); ++l) {
      for (std::uint32_t c = offset_[l]; c < offset_[l + 1]; ++c) link_of_[c] = l;
    }
    for_each_triangle(raster_, graph_, context_, [&](const WaveTriangle& t) { cross(t); });
    for (const auto& links : wound_) join_across(links);
    std::vector<LevelLine> out;
    std::vector<bool> used(next_.size(), false);
    const auto take = [&](std::uint32_t start, bool closed) {
      context_.check();
      LevelLine line = chain(start, closed, used);
      if (line.points.size() < 2) return;
      smooth(line);
      const double gap = line.gaps[line.gaps.size() / 2];
      if (line.begin_inside && line.end_inside && line.length() < kLeastLength * gap) return;
      out.push_back(std::move(line));
    };
    for (std::uint32_t c = 0; c < next_.size(); ++c) {
      const bool end = (next_[c][0] == kNone) != (next_[c][1] == kNone);
      if (end && !used[c]) take(c, false);
    }
    for (std::uint32_t c = 0; c < next_.size(); ++c) {
      if (!used[c] && next_[c][0] != kNone) take(c, true);
    }
    return out;
  }

 private:
  // Whole turns of each node on its way through the tree of its component.
  void unwrap() {
    whole_.assign(graph_.nodes.size(), 0);
    for (const std::uint32_t i : graph_.order) {
      const std::int32_t l = graph_.parent_link[i];
      if (l == kNone) continue;
      const WaveLink& link = graph_.links[static_cast<std::size_t>(l)];
      const bool forth = link.b == i;
      const std::uint32_t from = forth ? link.a : link.b;
      const double by = phase_.advance[static_cast<std::size_t>(l)] * (forth ? 1 : -1);
      const double there =
          phase_.at[from] + kTurn * static_cast<double>(whole_[from]) + by - phase_.at[i];
      whole_[i] = static_cast<std::int64_t>(std::llround(there / kTurn));
    }
  }

  Vec2 paper(std::uint32_t node) const {
    return raster_.center(std::size_t{graph_.nodes[node].cell});
  }

  // The whole turns of a crossing, as the first node of its link counts them.
  std::int64_t level(std::uint32_t crossing) const {
    const std::uint32_t link = link_of_[crossing];
    const double own = phase_.at[graph_.links[link].a];
    return turns_between(own, own + phase_.advance[link]).first + (crossing - offset_[link]);
  }

  Vec2 place(std::uint32_t crossing) const {
    const std::uint32_t link = link_of_[crossing];
    const WaveLink& l = graph_.links[link];
    const double turns = kTurn * static_cast<double>(level(crossing));
    const double t = (turns - phase_.at[l.a]) / phase_.advance[link];
    return paper(l.a) + std::clamp(t, 0.0, 1.0) * l.step;
  }

  // The corner at the other end of a link.
  Corner across(const Corner& from, std::int32_t number) const {
    const WaveLink& l = graph_.links[static_cast<std::size_t>(number)];
    const double by = phase_.advance[static_cast<std::size_t>(number)];
    const bool forth = l.a == from.node;
    // Against a flip the phase grows both ways.
    const double own = forth || l.flips ? by : -by;
    return {forth ? l.b : l.a, from.phase + from.sign * own, l.flips ? -from.sign : from.sign};
  }

  // The crossing of a link at a phase that a corner at one of its ends counts in its way.
  std::int32_t crossing(std::int32_t number, const Corner& end, const Corner& other,
                        std::int64_t turn) const {
    const auto l = static_cast<std::size_t>(number);
    const Corner& a = graph_.links[l].a == end.node ? end : other;
    const double own = phase_.at[a.node];
    const auto whole = std::llround((a.phase - a.sign * own) / kTurn);
    const std::int64_t level = (a.sign > 0 ? 1 : -1) * (turn - whole);
    const Turns t = turns_between(own, own + phase_.advance[l]);
    if (level < t.first || level >= t.first + t.count) return kNone;
    return static_cast<std::int32_t>(offset_[l] + static_cast<std::uint32_t>(level - t.first));
  }

  void cross(const WaveTriangle& triangle) {
    const std::int32_t ab = triangle[0].link, bc = triangle[1].link, ac = triangle[2].link;
    const WaveLink& first = graph_.links[static_cast<std::size_t>(ab)];
    const WaveLink& last = graph_.links[static_cast<std::size_t>(ac)];
    const std::uint32_t shared = first.a == last.a || first.a == last.b ? first.a : first.b;
    const Corner a{shared, phase_.at[shared], 1};
    const Corner b = across(a, ab), c = across(a, ac), again = across(b, bc);
    if (again.sign != c.sign || std::abs(again.phase - c.phase) > 0.5 * kTurn) {
      for (const std::int32_t l : {ab, bc, ac}) inside_[static_cast<std::size_t>(l)] = true;
      wound_.push_back({ab, bc, ac});
      return;
    }
    struct Side {
      std::int32_t link;
      const Corner *from, *to;
    };
    const std::array<Side, 3> sides{Side{ab, &a, &b}, Side{bc, &b, &c}, Side{ac, &a, &c}};
    const auto [low, high] = std::minmax({a.phase, b.phase, c.phase});
    const Turns t = turns_between(low, high);
    for (std::int64_t turn = t.first; turn < t.first + t.count; ++turn) {
      const double level = kTurn * static_cast<double>(turn);
      std::array<std::int32_t, 2> ends{kNone, kNone};
      int found = 0;
      for (const Side& s : sides) {
        if ((s.from->phase < level) == (s.to->phase < level) || found == 2) continue;
        ends[static_cast<std::size_t>(found++)] = crossing(s.link, *s.from, *s.to, turn);
      }
      if (found < 2 || ends[0] == kNone || ends[1] == kNone) continue;
      join(ends[0], ends[1]);
    }
  }

  // A triangle around which the phase winds has one line more on one side of it than on the other.
  // Of the lines that reach it, those that come from opposite sides go on into one another, and one
  // ends: three tips beside each other would be a blot.
  void join_across(const std::array<std::int32_t, 3>& links) {
    const double gap =
        1 / glm::length(graph_.nodes[graph_.links[static_cast<std::size_t>(links[0])].a].wave);
    std::vector<Tip> tips;
    for (const std::int32_t l : links) {
      const auto link = static_cast<std::uint32_t>(l);
      for (std::uint32_t c = offset_[link]; c < offset_[link + 1]; ++c) {
        if (const auto tip = tip_at(c, kTipLength * gap)) tips.push_back(*tip);
      }
    }
    while (tips.size() > 2) {
      double best = kBesideLine * gap;
      std::size_t first = 0, second = 0;
      for (std::size_t i = 0; i < tips.size(); ++i) {
        for (std::size_t j = i + 1; j < tips.size(); ++j) {
          if (glm::dot(tips[i].outwards, tips[j].outwards) > kOpposite) continue;
          const Vec2 along = glm::normalize(tips[j].outwards - tips[i].outwards);
          const double beside = std::abs(cross2(along, tips[j].off - tips[i].off));
          if (beside < best) best = beside, first = i, second = j;
        }
      }
      if (first == second) return;
      join(tips[first].crossing, tips[second].crossing);
      tips.erase(tips.begin() + static_cast<std::ptrdiff_t>(second));
      tips.erase(tips.begin() + static_cast<std::ptrdiff_t>(first));
    }
  }

  // Where a line ends, a point of it some way off, and the direction to there.
  struct Tip {
    std::int32_t crossing;
    Vec2 off, outwards;
  };
  std::optional<Tip> tip_at(std::uint32_t crossing, double away) const {
    const auto& n = next_[crossing];
    if ((n[0] == kNone) == (n[1] == kNone)) return std::nullopt;
    const Vec2 at = place(crossing);
    Vec2 off = at;
    std::int32_t from = static_cast<std::int32_t>(crossing), to = n[0] != kNone ? n[0] : n[1];
    for (int i = 0; i < kTipSteps && to != kNone && glm::distance(off, at) < away; ++i) {
      off = place(static_cast<std::uint32_t>(to));
      const auto& ahead = next_[static_cast<std::size_t>(to)];
      from = std::exchange(to, ahead[0] != from ? ahead[0] : ahead[1]);
    }
    if (off == at) return std::nullopt;
    return Tip{static_cast<std::int32_t>(crossing), off, glm::normalize(off - at)};
  }

  void join(std::int32_t a, std::int32_t b) {
    const auto add = [&](std::int32_t from, std::int32_t to) {
      auto& n = next_[static_cast<std::size_t>(from)];
      (n[0] == kNone ? n[0] : n[1]) = to;
    };
    add(a, b);
    add(b, a);
  }

  LevelLine chain(std::uint32_t start, bool closed, std::vector<bool>& used) const {
    LevelLine line;
    line.closed = closed;
    std::vector<std::uint32_t> crossings;
    std::int32_t at = static_cast<std::int32_t>(start);
    while (at != kNone && !used[static_cast<std::size_t>(at)]) {
      const auto c = static_cast<std::size_t>(at);
      used[c] = true;
      crossings.push_back(static_cast<std::uint32_t>(c));
      const std::int32_t ahead = next_[c][0], behind = next_[c][1];
      at = ahead != kNone && !used[static_cast<std::size_t>(ahead)] ? ahead : behind;
    }
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const std::uint32_t c = crossings[i];
      const WaveLink& link = graph_.links[link_of_[c]];
      line.points.push_back(place(c));
      line.gaps.push_back(static_cast<float>(1 / glm::length(graph_.nodes[link.a].wave)));
      if (i == crossings.size() / 2) {
        line.node = link.a;
        line.number = level(c) + whole_[link.a];
      }
    }
    if (!closed && !crossings.empty()) {
      line.begin_inside = inside_[link_of_[crossings.front()]];
      line.end_inside = inside_[link_of_[crossings.back()]];
    }
    return line;
  }

  static void smooth(LevelLine& line) {
    std::vector<Vec2>& p = line.points;
    const std::size_t n = p.size();
    if (n < 3) return;
    std::vector<Vec2> moved(n);
    for (int pass = 0; pass < kPasses; ++pass) {
      for (std::size_t i = 0; i < n; ++i) {
        const bool fixed = !line.closed && (i == 0 || i + 1 == n);
        moved[i] = fixed ? p[i] : 0.25 * p[(i + n - 1) % n] + 0.5 * p[i] + 0.25 * p[(i + 1) % n];
      }
      p.swap(moved);
    }
  }

  const ViewRaster& raster_;
  const WaveGraph& graph_;
  const WavePhase& phase_;
  const RunContext& context_;
  std::vector<std::int64_t> whole_;
  std::vector<std::uint32_t> offset_, link_of_;  // crossings of each link; link of each crossing
  std::vector<std::array<std::int32_t, 2>> next_;
  // Links of triangles around which the phase winds, and those triangles.
  std::vector<bool> inside_;
  std::vector<std::array<std::int32_t, 3>> wound_;
};

// Finds the lines that pass beside one that ends inside the surface.
void find_beside_ends(const ViewRaster& raster, std::vector<LevelLine>& lines) {
  std::vector<float> near(raster.cells.size(), 0);
  const auto mark = [&](Vec2 tip, double gap) {
    const double radius = kBesideEnd * gap;
    const auto middle = static_cast<std::int64_t>(raster.index(tip)),
               reach = std::min(kMostReach, static_cast<std::int64_t>(radius / raster.pitch));
    for (std::int64_t dy = -reach; dy <= reach; ++dy) {
      for (std::int64_t dx = -reach; dx <= reach; ++dx) {
        const std::int64_t cell = middle + dy * raster.nx + dx;
        if (cell < 0 || cell >= static_cast<std::int64_t>(near.size())) continue;
        const auto i = static_cast<std::size_t>(cell);
        const auto share = static_cast<float>(1 - glm::distance(raster.center(i), tip) / radius);
        near[i] = std::max(near[i], share);
      }
    }
  };
  for (const LevelLine& line : lines) {
    if (line.begin_inside) mark(line.points.front(), line.gaps.front());
    if (line.end_inside) mark(line.points.back(), line.gaps.back());
  }
  for (LevelLine& line : lines) {
    for (const Vec2& p : line.points) {
      line.beside_end = std::max(line.beside_end, near[raster.index(p)]);
    }
  }
}

}  // namespace

double LevelLine::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(points[i - 1], points[i]);
  if (closed && points.size() > 1) sum += glm::distance(points.back(), points.front());
  return sum;
}

std::vector<LevelLine> level_lines(const ViewRaster& raster, const WaveGraph& graph,
                                   const WavePhase& phase, const RunContext& context) {
  std::vector<LevelLine> lines = Marcher(raster, graph, phase, context).lines();
  find_beside_ends(raster, lines);
  return lines;
}

}  // namespace burin::detail
