#include "wave_phase.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kPhaseRange = 4096;  // of nodes: Gauss-Seidel inside, Jacobi between them
constexpr std::uint32_t kCoarsest = 60;    // nodes
constexpr int kSweepsAtFirst = 400, kSweeps = 15, kSweepsAtLast = 12;

Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
Vec2 times(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
Vec2 conjugate(Vec2 a) { return {a.x, -a.y}; }

// What the value of node `to` says of the value of the row's node: coupling times it, or times its
// conjugate where the waves run against each other.
struct Vote {
  std::uint32_t to = 0;
  bool conjugated = false;
  glm::vec2 coupling{0};
};

struct Level {
  std::vector<std::uint32_t> first;
  std::vector<Vote> votes;
  std::vector<Vec2> pull;  // of the anchors
  // Of each node in the coarser level: the group, and the number that carries the group's value.
  std::vector<std::uint32_t> parent;
  std::vector<Vec2> carry;

  std::size_t size() const { return pull.size(); }
};

Level finest(const WaveGraph& graph, const std::vector<WaveAnchor>& anchors) {
  Level level;
  const std::size_t n = graph.nodes.size();
  auto votes = at_nodes(graph, [&](std::size_t k) {
    const WaveLink& l = graph.links[k];
    const Vec2 back = l.weight * unit(-turn_along(graph, l));
    return std::array{Vote{l.b, l.flips, back},
                      Vote{l.a, l.flips, l.flips ? back : conjugate(back)}};
  });
  level.first = std::move(votes.first);
  level.votes = std::move(votes.list);
  level.pull.assign(n, Vec2(0));
  for (const WaveAnchor& a : anchors) level.pull[a.node] += unit(a.phase);
  return level;
}

// Pairs of strongly linked nodes.
std::uint32_t pair_up(Level& level) {
  constexpr std::uint32_t kFree = 0xffffffffu;
  const std::size_t n = level.size();
  level.parent.assign(n, kFree);
  level.carry.assign(n, Vec2(1, 0));
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (level.parent[i] != kFree) continue;
    const Vote* best = nullptr;
    float most = 0;
    for (std::uint32_t k = level.first[i]; k < level.first[i + 1]; ++k) {
      const Vote& s = level.votes[k];
      if (s.conjugated || level.parent[s.to] != kFree || s.to == i) continue;
      const float size = glm::dot(s.coupling, s.coupling);
      if (size <= most) continue;
      most = size;
      best = &s;
    }
    level.parent[i] = count;
    if (best) {
      level.parent[best->to] = count;
      level.carry[best->to] = conjugate(glm::normalize(Vec2(best->coupling)));
    }
    ++count;
  }
  return count;
}

Level coarser(const Level& fine, std::uint32_t count, const RunContext& context) {
  Level level;
  level.pull.assign(count, Vec2(0));
  std::vector<std::uint32_t> member(2 * static_cast<std::size_t>(count), 0xffffffffu);
  for (std::uint32_t i = 0; i < fine.size(); ++i) {
    const std::size_t slot = 2 * static_cast<std::size_t>(fine.parent[i]);
    (member[slot] == 0xffffffffu ? member[slot] : member[slot + 1]) = i;
    level.pull[fine.parent[i]] += times(conjugate(fine.carry[i]), fine.pull[i]);
  }
  level.first.push_back(0);
  for (std::uint32_t a = 0; a < count; ++a) {
    if (a % 65536 == 0) context.check();
    const std::size_t row = level.votes.size();
    for (std::size_t m = 2 * static_cast<std::size_t>(a); m < 2 * static_cast<std::size_t>(a) + 2;
         ++m) {
      const std::uint32_t i = member[m];
      if (i == 0xffffffffu) continue;
      for (std::uint32_t k = fine.first[i]; k < fine.first[i + 1]; ++k) {
        const Vote& s = fine.votes[k];
        const std::uint32_t b = fine.parent[s.to];
        if (b == a && !s.conjugated) continue;
        const Vec2 carried = s.conjugated ? conjugate(fine.carry[s.to]) : fine.carry[s.to];
        const Vec2 c = times(times(conjugate(fine.carry[i]), Vec2(s.coupling)), carried);
        std::size_t at = row;
        while (at < level.votes.size() &&
               (level.votes[at].to != b || level.votes[at].conjugated != s.conjugated)) {
          ++at;
        }
        if (at == level.votes.size()) level.votes.push_back({b, s.conjugated, glm::vec2(0)});
        level.votes[at].coupling += glm::vec2(c);
      }
    }
    level.first.push_back(static_cast<std::uint32_t>(level.votes.size()));
  }
  return level;
}

void sweep(const Level& level, std::vector<Vec2>& psi, int sweeps, const RunContext& context) {
  std::vector<Vec2> old;
  for (int pass = 0; pass < sweeps; ++pass) {
    if (level.size() > kPhaseRange) old = psi;
    parallel_for(
        level.size(), kPhaseRange,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t step = begin; step < end; ++step) {
            const std::size_t i = pass % 2 == 0 ? step : begin + end - 1 - step;
            Vec2 sum = level.pull[i];
            for (std::uint32_t k = level.first[i]; k < level.first[i + 1]; ++k) {
              const Vote& s = level.votes[k];
              const bool inside = s.to >= begin && s.to < end;
              const Vec2 there = inside ? psi[s.to] : old[s.to];
              sum += times(Vec2(s.coupling), s.conjugated ? conjugate(there) : there);
            }
            const double size = glm::length(sum);
            if (size > 1e-12) psi[i] = sum / size;
          }
        },
        &context);
  }
}

}  // namespace

double turn_along(const WaveGraph& graph, const WaveLink& l) {
  const Vec2 there = l.flips ? -graph.nodes[l.b].wave : graph.nodes[l.b].wave;
  return kPi * glm::dot(graph.nodes[l.a].wave + there, l.step);
}

WavePhase solve_phase(const WaveGraph& graph, const std::vector<WaveAnchor>& anchors,
                      const RunContext& context) {
  std::vector<Level> levels;
  context.check();
  levels.push_back(finest(graph, anchors));
  while (levels.back().size() > kCoarsest) {
    const std::uint32_t count = pair_up(levels.back());
    context.check();
    if (count > 0.97 * static_cast<double>(levels.back().size())) break;
    levels.push_back(coarser(levels.back(), count, context));
  }
  std::vector<Vec2> psi(levels.back().size(), Vec2(1, 0));
  const bool small = levels.back().size() <= kPhaseRange;
  sweep(levels.back(), psi, small ? kSweepsAtFirst : kSweeps, context);
  for (std::size_t l = levels.size() - 1; l-- > 0;) {
    const Level& level = levels[l];
    std::vector<Vec2> finer(level.size());
    for (std::size_t i = 0; i < finer.size(); ++i) {
      finer[i] = times(level.carry[i], psi[level.parent[i]]);
    }
    psi = std::move(finer);
    sweep(level, psi, l == 0 ? kSweepsAtLast : kSweeps, context);
  }
  WavePhase out;
  out.at.resize(psi.size());
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const double angle = std::atan2(psi[i].y, psi[i].x);
    out.at[i] = angle < 0 ? angle + 2 * kPi : angle;
  }
  out.advance.resize(graph.links.size());
  for (std::size_t k = 0; k < graph.links.size(); ++k) {
    const WaveLink& l = graph.links[k];
    const double turn = turn_along(graph, l);
    const double there = l.flips ? -out.at[l.b] : out.at[l.b];
    out.advance[k] = turn + std::remainder(there - out.at[l.a] - turn, 2 * kPi);
  }
  return out;
}

}  // namespace burin::detail
