#include "constraints.h"

#include <burin/base/parallel.h>

#include "fallback.h"
#include "links.h"

#include <algorithm>
#include <cmath>

namespace burin::field {
namespace {

// The field follows curvature over lengths of 1 / (kAlignment |k1-k2|) and more: about the radius
// of a cylinder, at confidence one half.
constexpr double kAlignment = 1;
// Full confidence follows this many times as closely as half confidence.
constexpr double kFullConfidence = 50;
// Curvature of smaller radius than this share of its region's size (square root of its area) pulls
// no more strongly: small bumps may not bend the field around them.
constexpr double kSmallRadius = 0.12;
// Exact lines are followed whatever the crosses say: they are given, up to this multiple of the
// pull of a wedge's neighbours.
constexpr double kCertain = 100;
// Directions must agree over this share of the region's size to count.
constexpr double kAgreement = 0.04;
// A crease outweighs the wedge's links by this factor where curvature says nothing.
constexpr double kCrease = 4;
// Pull of the style's direction on a region, relative to the stiffness of the region as a whole:
// where nothing else pulls, and where something does (there it only decides what is open).
constexpr double kFallback = 200;
constexpr double kOpen = 1e-6;
// A region whose curvature pulls with more than this has a field of its own.
constexpr double kInformed = 0.5;
// Pull on family labels relative to the region's stiffness: larger lets labels change over shorter
// distances.
constexpr double kLabel = 10;

struct Builder {
  const ProxyMesh& proxy;
  const std::vector<Frame>& frames;
  const std::vector<CurvedFrames::Other>& others;
  bool exact;
  const FlatPatches& flats;
  const SmoothedOptions& options;
  const WedgeGraph& graph;
  const Hierarchy<Vec2>& hierarchy;
  const RunContext& context;

  std::vector<Vec2> line = {};          // d1 to the second power
  std::vector<double> confidence = {};  // what is left of it
  std::vector<double> agreed = {};      // the share that is left
  std::vector<double> region_area = {};
  Constraints result = {};

  std::size_t size() const { return frames.size(); }
  // The directions of these are known for certain, however small the face is.
  bool is_certain(std::size_t w) const { return is_certain(frames[w]); }
  bool is_certain(const Frame& frame) const { return exact && has_exact_lines(frame); }
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
      result.certain[w] = static_cast<std::uint8_t>(is_certain(w));
      confidence[w] = is_certain(w) ? 1 : frames[w].confidence;
    });
  }

  // |k1-k2| as far as it counts, 1/mm.
  double bend(std::size_t w) const {
    const double k = frames[w].k1 - frames[w].k2, most = 1 / (kSmallRadius * region_size(w));
    return k / std::sqrt(1 + (k / most) * (k / most));
  }
  double region_size(std::size_t w) const {
    return std::sqrt(region_area[static_cast<std::size_t>(graph.region[w])]);
  }

  // Keeps of each confidence what the directions around agree with: noise contradicts itself.
  void weigh_by_agreement() {
    std::vector<Vec2> directions(size(), Vec2(0));
    std::vector<double> limit(size(), 0);
    for_wedges([&](std::size_t w) {
      directions[w] = graph.area[w] * confidence[w] * bend(w) * complex_square(line[w]);
      limit[w] = kAgreement * kAgreement * region_size(w) * region_size(w);
    });
    agreed = hierarchy.agreement(directions, graph.area, limit);
    for_wedges([&](std::size_t w) {
      agreed[w] *= agreed[w];
      if (!is_certain(w)) confidence[w] *= agreed[w];
    });
  }

  void follow_curvature() {
    const double rate = kAlignment * kAlignment * std::max(options.alignment, 0.0);
    for_wedges([&](std::size_t w) {
      const double k = bend(w), c = confidence[w];
      result.mass[w] = rate * graph.area[w] * k * k * c / (1 + 1 / kFullConfidence - c);
      if (is_certain(w)) {
        result.mass[w] = std::max(result.mass[w], kCertain * graph.crosses.stiffness[w]);
      }
      result.pull[w] = result.mass[w] * complex_square(line[w]);
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
      result.mass[w] += mass;
      result.pull[w] += mass * (sum[w] / size_w);
    });
  }

  std::vector<double> region_sums(const std::vector<double>& values) const {
    std::vector<double> sums(static_cast<std::size_t>(proxy.region_count), 0);
    for (std::size_t w = 0; w < size(); ++w) {
      sums[static_cast<std::size_t>(graph.region[w])] += values[w];
    }
    return sums;
  }

  Vec2 fallback_line(std::size_t w) const {
    const TangentBasis basis(proxy.wedge_normal[w], graph.axis[w]);
    return complex_square(basis.coords(normalize_or(options.fallback, Vec3(0, 0, 1))));
  }

  // How clearly family 1 is to follow d1 (positive) or d2 of a frame of that confidence.
  double lead(const Frame& frame, double sure) const {
    if (is_certain(frame) && frame.kind != FaceKind::Torus) {
      const auto ruled =
          frame.kind == FaceKind::Cone ? options.policy.cone : options.policy.cylinder;
      const bool first_is_circle = std::abs(frame.k1) > std::abs(frame.k2);
      return first_is_circle == (ruled == FacePolicy::Ruled::Circles) ? 1 : -1;
    }
    const double a = std::abs(frame.k1), b = std::abs(frame.k2);
    return a + b > 0 ? sure * (a - b) / (a + b) : 0;
  }

  void follow_fallback() {
    const std::vector<double> region_pull = region_sums(result.mass);
    for_wedges([&](std::size_t w) {
      const auto r = static_cast<std::size_t>(graph.region[w]);
      const double open = std::max(0.0, 1 - region_pull[r] / kInformed);
      const double mass = (kOpen + kFallback * open) * graph.area[w] / region_area[r];
      const Vec2 target =
          fallback_line(w);  // its length falls to 0 where the surface faces the direction
      result.mass[w] += mass * glm::length(target);
      result.pull[w] += mass * glm::length(target) * complex_square(target);
    });
  }

  void want_label(std::size_t w, double area, double towards, Vec2 d1) {
    const double share = area / region_area[static_cast<std::size_t>(graph.region[w])];
    result.line_pull[w] += kLabel * share * towards * d1;
    result.line_mass[w] += kLabel * share * std::abs(towards);
  }

  // On the border of two faces each speaks for its own area: in a wall between two fillets, whose
  // triangles have no inner vertex, the fillets would name the families otherwise.
  void set_labels() {
    std::vector<double> area = graph.area;
    for (const CurvedFrames::Other& o : others) area[o.wedge] -= o.area;
    for_wedges(
        [&](std::size_t w) { want_label(w, area[w], lead(frames[w], confidence[w]), line[w]); });
    for (const CurvedFrames::Other& o : others) {
      const Vec2 d =
          TangentBasis(proxy.wedge_normal[o.wedge], graph.axis[o.wedge]).coords(o.frame.d1);
      const double length = glm::length(d);
      if (o.frame.umbilic || !(length > 0)) continue;
      const double sure = is_certain(o.frame) ? 1 : o.frame.confidence * agreed[o.wedge];
      want_label(o.wedge, o.area, lead(o.frame, sure), complex_square(d / length));
    }
    for_wedges([&](std::size_t w) {
      const double share = graph.area[w] / region_area[static_cast<std::size_t>(graph.region[w])];
      const Vec2 open = kOpen * share * fallback_line(w);
      result.line_pull[w] += open;
      result.line_mass[w] += glm::length(open);
    });
  }
};

}  // namespace

Constraints find_constraints(const ProxyMesh& proxy, const CurvedFrames& frames, bool exact,
                             const FlatPatches& flats, const WedgeGraph& graph,
                             const Hierarchy<Vec2>& hierarchy, const SmoothedOptions& options,
                             const RunContext& context) {
  Builder b{proxy, frames.best, frames.others, exact, flats, options, graph, hierarchy, context};
  b.result.mass.assign(b.size(), 0);
  b.result.line_mass.assign(b.size(), 0);
  b.result.certain.assign(b.size(), 0);
  b.result.pull.assign(b.size(), Vec2(0));
  b.result.line_pull.assign(b.size(), Vec2(0));
  b.region_area = b.region_sums(graph.area);
  b.read_frames();
  b.weigh_by_agreement();
  b.follow_curvature();
  b.follow_creases();
  b.follow_fallback();
  b.set_labels();
  return std::move(b.result);
}

}  // namespace burin::field
