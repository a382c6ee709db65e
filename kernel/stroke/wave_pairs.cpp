#include "wave_pairs.h"

#include <burin/base/parallel.h>

#include "conjugate_gradients.h"
#include "level_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

constexpr int kFarthest = 32;    // triangles between two dislocations that cancel
constexpr int kBorder = 3;       // ... between one and the border that it leaves by
constexpr int kPairSteps = 120;  // of conjugate gradients
constexpr double kPairSmall = 1e-3;
constexpr std::size_t kPairRange = 8192;

class Pairs {
 public:
  Pairs(const ViewRaster& raster, const WaveGraph& graph, WavePhase& phase,
        const RunContext& context)
      : graph_(graph), phase_(phase), context_(context) {
    beside_.assign(graph.links.size(), {kNone, kNone});
    for_each_triangle(raster, graph, context, [&](const WaveTriangle& t) { add(t); });
  }

  // Cancels what can be, the nearest first.
  void cancel() {
    winds_.resize(triangles_.size());
    std::vector<std::int32_t> left;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (t % kPairRange == 0) context_.check();
      winds_[t] = winding(triangles_[t]);
      if (winds_[t] != 0) left.push_back(static_cast<std::int32_t>(t));
    }
    from_.assign(triangles_.size(), kNone);
    for (int reach = 2; reach <= kFarthest; reach *= 2) {
      context_.check();
      for (const std::int32_t t : left) {
        if (winds_[index(t)] != 0) search(t, reach);
      }
      std::erase_if(left, [&](std::int32_t t) { return winds_[index(t)] == 0; });
    }
  }

  // Moves all phases so that each link's advance is as near to its wave's as the others allow.
  void even_out(const std::vector<WaveAnchor>& anchors) {
    const std::size_t n = graph_.nodes.size();
    context_.check();
    std::vector<double> diagonal(n, 0), right(n, 0), x(n, 0);
    for (const WaveAnchor& a : anchors) {
      diagonal[a.node] += 1;
      right[a.node] -= std::remainder(phase_.at[a.node] - a.phase, kTurn);
    }
    // A link misses by its lack + sign x_b - x_a.
    const auto sign = [](const WaveLink& l) { return l.flips ? -1.0 : 1.0; };
    struct Coupling {
      std::uint32_t to = 0;
      float by = 0;
    };
    for (std::size_t k = 0; k < graph_.links.size(); ++k) {
      if (k % kPairRange == 0) context_.check();
      const WaveLink& l = graph_.links[k];
      const double lack = phase_.advance[k] - turn_along(graph_, l);
      right[l.a] += l.weight * lack;
      right[l.b] -= sign(l) * l.weight * lack;
      diagonal[l.a] += l.weight;
      diagonal[l.b] += l.weight;
    }
    context_.check();
    const auto couplings = at_nodes(graph_, [&](std::size_t k) {
      const WaveLink& l = graph_.links[k];
      const auto by = static_cast<float>(sign(l) * l.weight);
      return std::array{Coupling{l.b, by}, Coupling{l.a, by}};
    });
    const auto apply = [&](const std::vector<double>& in, std::vector<double>& out) {
      parallel_for(n, kPairRange, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          double sum = diagonal[i] * in[i];
          for (const Coupling& c : couplings[i]) sum -= c.by * in[c.to];
          out[i] = sum;
        }
      });
    };
    ConjugateGradients(n, kPairSmall, context_).solve(apply, diagonal, right, x, kPairSteps);
    for (std::size_t k = 0; k < graph_.links.size(); ++k) {
      const WaveLink& l = graph_.links[k];
      phase_.advance[k] += sign(l) * x[l.b] - x[l.a];
    }
    for (std::size_t i = 0; i < n; ++i) {
      phase_.at[i] = std::fmod(phase_.at[i] + x[i], kTurn);
      if (phase_.at[i] < 0) phase_.at[i] += kTurn;
    }
  }

 private:
  static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  // Those at a half singularity of the field are no dislocations, and nothing passes them.
  void add(const WaveTriangle& triangle) {
    for (const TriangleSide& s : triangle) {
      if (graph_.links[index(s.link)].flips) return;
    }
    const auto number = static_cast<std::int32_t>(triangles_.size());
    triangles_.push_back(triangle);
    for (const TriangleSide& s : triangle) {
      auto& b = beside_[index(s.link)];
      (b[0] == kNone ? b[0] : b[1]) = number;
    }
  }

  int winding(const WaveTriangle& triangle) const {
    double sum = 0;
    for (const TriangleSide& s : triangle) sum += s.way * phase_.advance[index(s.link)];
    return static_cast<int>(std::lround(sum / kTurn));
  }

  // Looks breadth first for an opposite dislocation or a border, and cancels with it.
  void search(std::int32_t start, int reach) {
    const int own = winds_[index(start)] > 0 ? 1 : -1;
    std::vector<std::int32_t> ring{start}, seen{start};
    from_[index(start)] = start;
    std::int32_t found = kNone, out = kNone;
    for (int far = 0; far < reach && found == kNone && out == kNone; ++far) {
      std::vector<std::int32_t> next;
      for (const std::int32_t t : ring) {
        for (const TriangleSide& s : triangles_[index(t)]) {
          const auto& b = beside_[index(s.link)];
          const std::int32_t other = b[0] == t ? b[1] : b[0];
          if (other == kNone) {
            if (far < kBorder && out == kNone) {
              out = s.link;
              found = t;
            }
            continue;
          }
          if (from_[index(other)] != kNone) continue;
          from_[index(other)] = t;
          seen.push_back(other);
          next.push_back(other);
          if (winds_[index(other)] * own < 0 && found == kNone) found = other;
        }
        if (found != kNone) break;
      }
      ring = std::move(next);
    }
    if (found != kNone) {
      if (out != kNone) {
        pass(out, found, -own);
      } else {
        winds_[index(found)] += own;
      }
      for (std::int32_t t = found; t != start; t = from_[index(t)]) {
        const std::int32_t before = from_[index(t)];
        for (const TriangleSide& s : triangles_[index(before)]) {
          const auto& b = beside_[index(s.link)];
          if (b[0] == t || b[1] == t) pass(s.link, before, -own);
        }
      }
      winds_[index(start)] -= own;
    }
    for (const std::int32_t t : seen) from_[index(t)] = kNone;
  }

  // Changes a link so that the phase winds around that triangle beside it by so much more.
  void pass(std::int32_t link, std::int32_t triangle, int by) {
    for (const TriangleSide& s : triangles_[index(triangle)]) {
      if (s.link == link) phase_.advance[index(link)] += s.way * by * kTurn;
    }
  }

  const WaveGraph& graph_;
  WavePhase& phase_;
  const RunContext& context_;
  std::vector<WaveTriangle> triangles_;
  std::vector<std::array<std::int32_t, 2>> beside_;  // triangles on both sides of a link
  std::vector<int> winds_;
  std::vector<std::int32_t> from_;
};

}  // namespace

void cancel_pairs(const ViewRaster& raster, const WaveGraph& graph,
                  const std::vector<WaveAnchor>& anchors, WavePhase& phase,
                  const RunContext& context) {
  Pairs pairs(raster, graph, phase, context);
  pairs.cancel();
  pairs.even_out(anchors);
}

}  // namespace burin::detail
