#include "constraints.h"

#include <burin/base/parallel.h>

#include "fallback.h"

#include <cmath>

namespace burin::field {
namespace {

constexpr std::size_t kGrain = 4096;
// The field follows curvature over lengths of 1 / (kAlignment |k1-k2|) and more: about half the
// radius of a cylinder, at confidence one half.
constexpr double kAlignment = 2;
// Full confidence follows this many times as closely as half confidence.
constexpr double kFullConfidence = 50;
// A crease outweighs the wedge's links by this factor where curvature says nothing.
constexpr double kCrease = 4;
// Passes over which directions must agree to count.
constexpr int kCoherencePasses = 2;
// Pull of the style's direction on a region, relative to the stiffness of the region as a whole:
// where nothing else pulls, and where something does (there it only decides what is open).
constexpr double kFallback = 8;
constexpr double kOpen = 1e-3;
// A region whose curvature pulls with more than this has a field of its own.
constexpr double kInformed = 0.5;
// Pull on family labels relative to the region's stiffness: larger lets labels change over shorter
// distances.
constexpr double kLabel = 30;

struct Builder {
  const ProxyMesh& proxy;
  const std::vector<Frame>& frames;
  const FlatPatches& flats;
  const SmoothedOptions& options;
  WedgeGraph& graph;
  const RunContext& context;

  std::vector<Vec2> line = {};          // d1 to the second power
  std::vector<double> confidence = {};  // what is left of it
  std::vector<double> region_area = {};
  std::vector<double> region_pull = {};

  std::size_t size() const { return frames.size(); }
  template <class Body>
  void for_wedges(const Body& body) {
    parallel_for(
        size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t w = begin; w < end; ++w) {
            if (graph.area[w] > 0) body(w);
          }
        },
        &context);
  }

  void read_frames() {
    line.assign(size(), Vec2(0));
    confidence.assign(size(), 0);
    for_wedges([&](std::size_t w) {
      const TangentBasis basis(proxy.wedge_normal[w], graph.axis[w]);
      const Vec2 d = basis.coords(frames[w].d1);
      const double length = glm::length(d);
      if (!(length > 0) || frames[w].umbilic) return;
      line[w] = complex_square(d / length);
      confidence[w] = frames[w].confidence;
    });
  }

  // Keeps of each confidence what the neighbours' directions agree with: noise contradicts itself.
  void weigh_by_coherence() {
    const System<Vec2>& s = graph.crosses;
    std::vector<Vec2> sum(size(), Vec2(0)), next(size(), Vec2(0));
    std::vector<double> total(size(), 0), next_total(size(), 0);
    for_wedges([&](std::size_t w) {
      total[w] = graph.area[w] * confidence[w] * (frames[w].k1 - frames[w].k2);
      sum[w] = total[w] * complex_square(line[w]);
    });
    for (int pass = 0; pass < kCoherencePasses; ++pass) {
      for_wedges([&](std::size_t w) {
        next[w] = s.stiffness[w] * sum[w];
        next_total[w] = s.stiffness[w] * total[w];
        for (std::uint32_t k = s.first[w]; k < s.first[w + 1]; ++k) {
          next[w] += complex_mul(s.coupling[k], sum[s.neighbour[k]]);
          next_total[w] += glm::length(s.coupling[k]) * total[s.neighbour[k]];
        }
        const double scale = s.stiffness[w] > 0 ? 0.5 / s.stiffness[w] : 1;
        next[w] *= scale;
        next_total[w] *= scale;
      });
      sum.swap(next);
      total.swap(next_total);
    }
    for_wedges([&](std::size_t w) {
      const double c = total[w] > 0 ? glm::length(sum[w]) / total[w] : 0;
      confidence[w] *= c * c;
    });
  }

  void follow_curvature() {
    const double rate = kAlignment * kAlignment * std::max(options.alignment, 0.0);
    for_wedges([&](std::size_t w) {
      const double bend = frames[w].k1 - frames[w].k2, c = confidence[w];
      const double mass = rate * graph.area[w] * bend * bend * c / (1 + 1 / kFullConfidence - c);
      graph.crosses.mass[w] = mass;
      graph.crosses.pull[w] = mass * complex_square(line[w]);
    });
  }

  // Edges where a wedge's curved patch ends: creases, boundaries, flat parts.
  void follow_creases() {
    std::vector<Vec2> sum(size(), Vec2(0));
    std::vector<double> total(size(), 0);
    for (std::uint32_t f = 0; f < proxy.wedges.size(); ++f) {
      if (flats.face_patch[f] >= 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t h = 3 * f + k;
        const HalfEdge other = proxy.topology.opposite[h];
        if (proxy.edge_kind[h] == EdgeKind::Smooth && flats.face_patch[face_of(other)] < 0)
          continue;
        const std::uint32_t a = proxy.wedges[f][k], b = proxy.wedges[f][(k + 1) % 3];
        const Vec3 e = proxy.wedge_position(b) - proxy.wedge_position(a);
        for (const std::uint32_t w : {a, b}) {
          const Vec2 d = TangentBasis(proxy.wedge_normal[w], graph.axis[w]).coords(e);
          const double length = glm::length(d);
          if (!(length > 0)) continue;
          sum[w] += length * complex_square(complex_square(d / length));
          total[w] += length;
        }
      }
    }
    for_wedges([&](std::size_t w) {
      const double size_w = glm::length(sum[w]), doubt = 1 - 2 * confidence[w];
      if (!(size_w > 0) || doubt <= 0) return;
      const double mass = kCrease * doubt * graph.crosses.stiffness[w] * size_w / total[w];
      graph.crosses.mass[w] += mass;
      graph.crosses.pull[w] += mass * (sum[w] / size_w);
    });
  }

  void measure_regions() {
    region_area.assign(static_cast<std::size_t>(proxy.region_count), 0);
    region_pull = region_area;
    for (std::size_t w = 0; w < size(); ++w) {
      const auto r = static_cast<std::size_t>(graph.region[w]);
      region_area[r] += graph.area[w];
      region_pull[r] += graph.crosses.mass[w];
    }
  }

  Vec2 fallback_line(std::size_t w) const {
    const TangentBasis basis(proxy.wedge_normal[w], graph.axis[w]);
    return complex_square(basis.coords(normalize_or(options.fallback, Vec3(0, 0, 1))));
  }

  void follow_fallback() {
    for_wedges([&](std::size_t w) {
      const auto r = static_cast<std::size_t>(graph.region[w]);
      const double open = std::max(0.0, 1 - region_pull[r] / kInformed);
      const double mass = (kOpen + kFallback * open) * graph.area[w] / region_area[r];
      const Vec2 target =
          fallback_line(w);  // its length falls to 0 where the surface faces the direction
      graph.crosses.mass[w] += mass * glm::length(target);
      graph.crosses.pull[w] += mass * glm::length(target) * complex_square(target);
    });
  }

  LabelTargets label_targets() {
    LabelTargets t;
    t.line.assign(size(), Vec2(0));
    t.weight.assign(size(), 0);
    for_wedges([&](std::size_t w) {
      const double share = graph.area[w] / region_area[static_cast<std::size_t>(graph.region[w])];
      const double a = std::abs(frames[w].k1), b = std::abs(frames[w].k2);
      const double lead = a + b > 0 ? confidence[w] * (a - b) / (a + b) : 0;
      const Vec2 open = kOpen * share * fallback_line(w);
      t.line[w] = kLabel * share * lead * line[w] + open;
      t.weight[w] = kLabel * share * std::abs(lead) + glm::length(open);
    });
    return t;
  }
};

}  // namespace

LabelTargets set_constraints(const ProxyMesh& proxy, const std::vector<Frame>& frames,
                             const FlatPatches& flats, const SmoothedOptions& options,
                             WedgeGraph& graph, const RunContext& context) {
  Builder b{proxy, frames, flats, options, graph, context};
  b.read_frames();
  b.weigh_by_coherence();
  b.follow_curvature();
  b.follow_creases();
  b.measure_regions();
  b.follow_fallback();
  return b.label_targets();
}

}  // namespace burin::field
