#include <burin/base/parallel.h>
#include <burin/feature/light_normals.h>
#include <burin/mesh/corners.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t kGrain = 4096;
/// How far normals bend beside how far they turn from wedge to wedge: up to the first a mesh is
/// even, from the second on all of it is noise. Means of whole meshes: machine parts 0.03 to 0.2,
/// scans and coarse figures 0.27 to 0.5.
constexpr double kEven = 0.2, kNoise = 0.5;
/// How like equilateral triangles are: below the first a tessellator chose them, not a scan.
constexpr double kLong = 0.4, kCompact = 0.6;
/// A neighbour is alike whose normal turns by that share of the most that any does. With three of
/// them a wedge lies on a flat face or a ruling, and its normal is no noise: where a fillet begins
/// it bends on one side alone.
constexpr double kAlike = 0.1;
constexpr int kFewAlike = 3;
/// Means over the neighbours.
constexpr int kRings = 3;
/// Widths of the pen, and lengths of edges, that noise is averaged over.
constexpr double kPens = 8, kEdges = 2;
constexpr int kSweeps = 20;
/// Of the way to the mean, in a sweep: all of it would swing to and fro on grids.
constexpr double kStep = 0.75;
/// A cotangent of needles.
constexpr double kMostWeight = 5;

/// What is uneven about a place: how far normals turn there from wedge to wedge, how far they bend
/// between them, and the shape of its triangles from 0 (needles) to 1 (equilateral).
struct Evenness {
  float turn = 0, bend = 0, shape = 0;

  Evenness& operator+=(const Evenness& other) {
    turn += other.turn, bend += other.bend, shape += other.shape;
    return *this;
  }
  bool is_even() const { return bend <= static_cast<float>(kEven) * turn; }
  /// Of noise, from 0 to 1.
  double noise() const {
    if (!(turn > 0)) return 0;
    return std::clamp((bend / turn - kEven) / (kNoise - kEven), 0.0, 1.0) *
           std::clamp((shape - kLong) / (kCompact - kLong), 0.0, 1.0);
  }
};

/// The means of uneven wedges with their neighbours, as sums with weights.
struct Means {
  std::vector<std::uint32_t> wedges;
  /// What the wedge's own normal adds.
  std::vector<Vec3> own;
  /// The neighbours of wedge i are from first[i] to first[i + 1].
  std::vector<std::uint32_t> first{0}, to;
  std::vector<double> weight;
};

class Fairing {
 public:
  Fairing(const ProxyMesh& proxy, const RunContext& context)
      : proxy_(proxy),
        context_(context),
        corners_(corners_at(proxy.wedges, proxy.wedge_normal.size())),
        weights_(3 * proxy.wedges.size()),
        shapes_(proxy.wedges.size()) {
    each(proxy.wedges.size(), [&](std::size_t f) { weigh(f); });
  }

  std::vector<Vec3> run(const Camera& camera, double pen) const {
    std::vector<Evenness> evenness(proxy_.wedge_normal.size());
    each(evenness.size(), [&](std::size_t w) { evenness[w] = evenness_at(w); });
    if (std::ranges::all_of(evenness, &Evenness::is_even)) return {};  // and so are means
    for (int k = 0; k < kRings; ++k) spread(evenness);
    if (std::ranges::none_of(evenness, [](const Evenness& e) { return e.noise() > 0; })) return {};
    std::vector<Vec3> normals = proxy_.wedge_normal;
    const Means means = means_of(evenness, camera, pen);
    std::vector<Vec3> next(means.wedges.size());
    for (int k = 0; k < kSweeps; ++k) {
      each(next.size(), [&](std::size_t i) {
        Vec3 sum = means.own[i];
        for (std::uint32_t j = means.first[i]; j < means.first[i + 1]; ++j) {
          sum += means.weight[j] * normals[means.to[j]];
        }
        next[i] = glm::mix(normals[means.wedges[i]], sum, kStep);
      });
      for (std::size_t i = 0; i < next.size(); ++i) normals[means.wedges[i]] = next[i];
    }
    for (const std::uint32_t w : means.wedges) {
      normals[w] = normalize_or(normals[w], proxy_.wedge_normal[w]);
    }
    return normals;
  }

 private:
  template <class What>
  void each(std::size_t count, const What& what) const {
    parallel_for(
        count, kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) what(i);
        },
        &context_);
  }

  /// Calls `link(wedge, weight)` for the other corners of the triangles at a wedge.
  template <class Link>
  void each_link(std::size_t wedge, const Link& link) const {
    for (const HalfEdge h : corners_[wedge]) {
      const std::size_t f = face_of(h);
      const auto on = static_cast<std::size_t>(next_in_face(h) % 3);
      const auto back = static_cast<std::size_t>(prev_in_face(h) % 3);
      link(proxy_.wedges[f][on], weights_[3 * f + back]);
      link(proxy_.wedges[f][back], weights_[3 * f + on]);
    }
  }

  /// Half the cotangent at each corner, and the shape.
  void weigh(std::size_t face) {
    const Triangle& t = proxy_.mesh.triangles[face];
    const Vec3 &a = proxy_.mesh.positions[t[0]], &b = proxy_.mesh.positions[t[1]],
               &c = proxy_.mesh.positions[t[2]];
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const double across = glm::length(glm::cross(ab, bc));
    const std::array along{-glm::dot(ca, ab), -glm::dot(ab, bc), -glm::dot(bc, ca)};
    for (std::size_t k = 0; k < 3; ++k) {
      const bool needle = along[k] >= kMostWeight * across;
      const double cotangent = needle ? kMostWeight : std::max(along[k], 0.0) / across;
      weights_[3 * face + k] = static_cast<float>(0.5 * cotangent);
    }
    const double sides = glm::dot(ab, ab) + glm::dot(bc, bc) + glm::dot(ca, ca);
    if (sides > 0) {
      shapes_[face] = static_cast<float>(2 * std::numbers::sqrt3 * across / sides);
    }
  }

  Evenness evenness_at(std::size_t wedge) const {
    const Vec3& own = proxy_.wedge_normal[wedge];
    double all = 0, turn = 0, most = 0;
    Vec3 bend(0);
    each_link(wedge, [&](std::uint32_t to, double weight) {
      const Vec3 d = proxy_.wedge_normal[to] - own;
      const double length = glm::length(d);
      all += weight;
      turn += weight * length;
      bend += weight * d;
      most = std::max(most, length);
    });
    Evenness out;
    for (const HalfEdge h : corners_[wedge]) out.shape += shapes_[face_of(h)];
    out.shape /= static_cast<float>(std::max<std::size_t>(corners_[wedge].size(), 1));
    if (!(turn > 0)) return out;
    bend -= glm::dot(bend, own) * own;  // where the surface turns evenly that is all of it
    out.turn = static_cast<float>(turn / all);
    out.bend = static_cast<float>(glm::length(bend) / all);
    if (out.is_even()) return out;
    int alike = 0;
    each_link(wedge, [&](std::uint32_t to, double) {
      alike += glm::distance(proxy_.wedge_normal[to], own) <= kAlike * most ? 1 : 0;
    });
    if (alike >= kFewAlike) out.bend = 0;
    return out;
  }

  /// Takes the mean of the triangles, and of those around each wedge.
  void spread(std::vector<Evenness>& evenness) const {
    std::vector<Evenness> faces(proxy_.wedges.size());
    each(faces.size(), [&](std::size_t f) {
      for (const std::uint32_t w : proxy_.wedges[f]) faces[f] += evenness[w];
    });
    each(evenness.size(), [&](std::size_t w) {
      Evenness sum;
      for (const HalfEdge h : corners_[w]) sum += faces[face_of(h)];
      const float share =
          1 / (3 * static_cast<float>(std::max<std::size_t>(corners_[w].size(), 1)));
      evenness[w] = {share * sum.turn, share * sum.bend, share * sum.shape};
    });
  }

  Means means_of(const std::vector<Evenness>& evenness, const Camera& camera, double pen) const {
    Means means;
    std::vector<std::pair<std::uint32_t, double>> links;
    for (std::uint32_t w = 0; w < evenness.size(); ++w) {
      const double noise = evenness[w].noise();
      if (noise <= 0) continue;
      links.clear();
      double edges = 0, area = 0;
      each_link(w, [&](std::uint32_t to, double weight) {
        edges += glm::distance(proxy_.wedge_position(w), proxy_.wedge_position(to));
        const auto before = std::ranges::find(links, to, [](const auto& l) { return l.first; });
        if (before != links.end())
          before->second += weight;
        else
          links.emplace_back(to, weight);
      });
      edges /= static_cast<double>(2 * corners_[w].size());
      for (const HalfEdge h : corners_[w]) area += proxy_.mesh.area(face_of(h)) / 3;
      const double pens = kPens * pen / camera.scale_at(proxy_.wedge_position(w));
      const double reach = noise * std::max(pens, kEdges * edges);
      double all = area;
      for (auto& [to, weight] : links) all += weight *= reach * reach;
      if (!(all > 0)) continue;
      means.wedges.push_back(w);
      means.own.push_back(area / all * proxy_.wedge_normal[w]);
      for (const auto& [to, weight] : links) {
        means.to.push_back(to);
        means.weight.push_back(weight / all);
      }
      means.first.push_back(static_cast<std::uint32_t>(means.to.size()));
    }
    return means;
  }

  const ProxyMesh& proxy_;
  const RunContext& context_;
  Corners corners_;
  /// For each corner of a triangle that of the edge opposite.
  std::vector<float> weights_;
  std::vector<float> shapes_;
};

}  // namespace

std::vector<Vec3> light_normals(const ProxyMesh& proxy, const Camera& camera, double pen,
                                const RunContext& context) {
  if (proxy.wedge_normal.empty()) return {};
  return Fairing(proxy, context).run(camera, pen);
}

Vec3 light_normal(const ProxyMesh& proxy, std::span<const Vec3> normals, std::uint32_t face,
                  Vec3 bary) {
  if (normals.empty()) return proxy.normal(face, bary);
  const auto& [a, b, c] = proxy.wedges[face];
  return normalize_or(bary.x * normals[a] + bary.y * normals[b] + bary.z * normals[c], normals[a]);
}

}  // namespace burin
