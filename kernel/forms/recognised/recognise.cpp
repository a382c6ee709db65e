#include "recognise.h"

#include "profiles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace burin::recognised {
namespace {

constexpr double kTurnOfFacets = 0.707;  // 40.5 degrees
// Sine of the angle between axes that are one.
constexpr double kOneAxis = 1e-4;

/// A band, or a flat ring or cap across the axis of one.
struct Node {
  std::int32_t band = -1, flat = -1;
  /// Other nodes that it meets along a circle at a small angle.
  std::vector<std::int32_t> next;
};

/// Flat: one or two circles around an axis.
struct Ring {
  double inner = 0, outer = 0, height = 0, side = 1;
  bool found = false;
};

class Joiner {
 public:
  Joiner(const TriMesh& mesh, const Facets& facets, Bands bands, const RunContext& context)
      : mesh_(mesh), facets_(facets), bands_(std::move(bands)), context_(context) {}

  Recognised run() {
    out_.patch_of = bands_.of;
    for (const Patch& p : bands_.spheres) chains_ = std::max(chains_, p.chain + 1);
    for (const Band& b : bands_.list) {
      out_.patches.push_back(b.patch);
      nodes_.push_back({static_cast<std::int32_t>(nodes_.size()), -1, {}});
    }
    const auto first = static_cast<std::int32_t>(out_.patches.size());
    out_.patches.insert(out_.patches.end(), bands_.spheres.begin(), bands_.spheres.end());
    for (std::size_t f = 0; f < facets_.list.size(); ++f) {
      if (bands_.of_sphere[f] >= 0) out_.patch_of[f] = first + bands_.of_sphere[f];
    }
    for (std::size_t b = 0; b < bands_.list.size(); ++b) {
      if (b % 16 == 0) context_.check();
      meet(static_cast<std::int32_t>(b));
    }
    follow();
    take_crescents();
    return std::move(out_);
  }

 private:
  const Facet& facet(std::int32_t f) const { return facets_.list[static_cast<std::size_t>(f)]; }
  Node& node(std::int32_t n) { return nodes_[static_cast<std::size_t>(n)]; }
  const Patch& patch(std::int32_t b) const {
    return bands_.list[static_cast<std::size_t>(b)].patch;
  }

  bool same_axis(const Patch& a, const Patch& b) const {
    if (std::abs(a.step - b.step) > 1e-3 * a.step) return false;
    if (glm::length(glm::cross(a.axis.direction, b.axis.direction)) > kOneAxis) return false;
    const double off = a.axis.profile(b.axis.origin).x;
    return off <= 0.05 * std::min(a.sagitta, b.sagitta) + 10 * facets_.noise;
  }

  /// Joints of a band with others and with flats.
  void meet(std::int32_t b) {
    for (const std::int32_t f : bands_.list[static_cast<std::size_t>(b)].facets) {
      for (const FacetLink& l : facet(f).links) {
        const std::int32_t other = bands_.of[static_cast<std::size_t>(l.facet)];
        if (other == b || bands_.of_sphere[static_cast<std::size_t>(l.facet)] >= 0) continue;
        if (glm::dot(facet(f).normal, facet(l.facet).normal) < std::cos(kTurnOfFacets)) continue;
        if (other >= 0) {
          if (linked(b, other) || !same_axis(patch(b), patch(other))) continue;
          if (on_ring(patch(b), facet(f), facet(l.facet))) connect(b, other);
        } else {
          meet_flat(b, l.facet);
        }
      }
    }
  }

  bool linked(std::int32_t a, std::int32_t b) {
    const auto& list = node(a).next;
    return std::find(list.begin(), list.end(), b) != list.end();
  }
  void connect(std::int32_t a, std::int32_t b) {
    if (linked(a, b)) return;
    node(a).next.push_back(b);
    node(b).next.push_back(a);
  }

  /// Whether the common vertices of two facets lie on one circle around the axis.
  bool on_ring(const Patch& p, const Facet& a, const Facet& b) const {
    std::vector<std::uint32_t> common;
    std::set_intersection(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                          b.vertices.end(), std::back_inserter(common));
    if (common.size() < 2) return false;
    const Vec2 first = p.axis.profile(mesh_.positions[common.front()]);
    return std::all_of(common.begin(), common.end(), [&](std::uint32_t v) {
      return glm::length(p.axis.profile(mesh_.positions[v]) - first) <=
             0.1 * p.sagitta + 10 * facets_.noise;
    });
  }

  Ring ring_of(const Patch& p, const Facet& f) const {
    Ring ring;
    const double along = glm::dot(f.normal, p.axis.direction);
    if (std::abs(along) < 1 - 0.5 * kOneAxis * kOneAxis - 1e-9) return ring;
    ring.side = along > 0 ? 1 : -1;
    std::vector<double> radii;
    for (const std::uint32_t v : f.vertices) {
      const Vec2 q = p.axis.profile(mesh_.positions[v]);
      radii.push_back(q.x);
      ring.height += q.y / static_cast<double>(f.vertices.size());
    }
    std::sort(radii.begin(), radii.end());
    const double most = 0.1 * p.sagitta + 10 * facets_.noise;
    ring.outer = radii.back();
    ring.inner = radii.front() < ring.outer - most ? radii.front() : 0;
    ring.found = std::all_of(radii.begin(), radii.end(), [&](double r) {
      return r <= ring.inner + most || r >= ring.outer - most;
    });
    return ring;
  }

  void meet_flat(std::int32_t b, std::int32_t f) {
    const auto known = flats_.find(f);
    if (known != flats_.end() && linked(b, known->second)) return;
    if (!ring_of(patch(b), facet(f)).found) return;
    if (known != flats_.end()) {
      connect(b, known->second);
      return;
    }
    const auto id = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({-1, f, {}});
    flats_[f] = id;
    connect(b, id);
  }

  /// The line of a node in the plane of the chain's axis.
  Segment segment_of(const Node& n, const Patch& frame) const {
    Segment s;
    if (n.flat >= 0) {
      const Ring ring = ring_of(frame, facet(n.flat));
      s.normal = {0, ring.side};
      s.offset = ring.side * ring.height;
      s.begin = {ring.inner > 0 ? ring.inner : -ring.outer, ring.height};
      s.end = {ring.outer, ring.height};
      s.begin_known = s.end_known = true;
      if (ring.side > 0) std::swap(s.begin, s.end);
      return s;
    }
    const Patch& p = patch(n.band);
    const double turned = glm::dot(p.axis.direction, frame.axis.direction) > 0 ? 1 : -1;
    const double shift = glm::dot(p.axis.origin - frame.axis.origin, frame.axis.direction);
    s.normal = {p.normal.x, turned * p.normal.y};
    s.offset = p.offset + s.normal.y * shift;
    double low = 1e300, high = -1e300;
    for (const std::int32_t f : bands_.list[static_cast<std::size_t>(n.band)].facets) {
      for (const std::uint32_t v : facet(f).vertices) {
        const double x = glm::dot(frame.axis.profile(mesh_.positions[v]), s.along());
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    s.begin = s.offset * s.normal + low * s.along();
    s.end = s.offset * s.normal + high * s.along();
    return s;
  }

  /// Chains of nodes that have two neighbours at the most.
  void follow() {
    std::vector<std::uint8_t> done(nodes_.size(), 0);
    std::vector<std::uint8_t> crowded;
    for (const Node& n : nodes_) crowded.push_back(n.next.size() > 2);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      std::erase_if(nodes_[i].next, [&](std::int32_t n) {
        return crowded[i] || crowded[static_cast<std::size_t>(n)];
      });
    }
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (done[i] || nodes_[i].next.empty()) continue;
        if (pass == 0 && nodes_[i].next.size() != 1) continue;  // open chains from their ends
        std::vector<std::int32_t> path{static_cast<std::int32_t>(i)};
        done[i] = 1;
        for (bool more = true; more;) {
          more = false;
          for (const std::int32_t next : node(path.back()).next) {
            if (done[static_cast<std::size_t>(next)]) continue;
            done[static_cast<std::size_t>(next)] = 1;
            path.push_back(next);
            more = true;
            break;
          }
        }
        if (path.size() >= 4) shape(path, pass == 1 && linked(path.back(), path.front()));
      }
    }
  }

  /// Orders the path along its profile and finds its joints; false where lines do not cross.
  bool join_ends(std::vector<std::int32_t>& path, std::vector<Segment>& list, bool closed) const {
    const auto cross = [](const Segment& a, const Segment& b, Vec2& point) {
      const double det = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
      if (std::abs(det) < 1e-9) return false;
      point = Vec2(a.offset * b.normal.y - b.offset * a.normal.y,
                   b.offset * a.normal.x - a.offset * b.normal.x) /
              det;
      return true;
    };
    Vec2 joint;
    if (!cross(list[0], list[1], joint)) return false;
    const Vec2 middle = 0.5 * (list[0].begin + list[0].end);
    if (glm::dot(joint - middle, list[0].along()) < 0) {
      std::reverse(path.begin(), path.end());
      std::reverse(list.begin(), list.end());
    }
    const std::size_t n = list.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
      Segment& a = list[i];
      Segment& b = list[(i + 1) % n];
      if (!cross(a, b, joint)) return false;
      a.end = b.begin = joint;
      a.end_known = b.begin_known = true;
    }
    return std::all_of(list.begin(), list.end(),
                       [](const Segment& s) { return glm::dot(s.end - s.begin, s.along()) > 0; });
  }

  void shape(std::vector<std::int32_t> path, bool closed) {
    const auto widest = std::max_element(path.begin(), path.end(), [&](auto a, auto b) {
      return size_of(node(a)) < size_of(node(b));
    });
    const Patch frame = patch(node(*widest).band);
    std::vector<Segment> list;
    for (const std::int32_t n : path) list.push_back(segment_of(node(n), frame));
    if (!join_ends(path, list, closed)) return;
    const std::vector<bool> smooth = smooth_joints(list, closed);
    if (closed && std::find(smooth.begin(), smooth.end(), false) == smooth.end()) {
      make(path, list, true, frame);
      return;
    }
    for (std::size_t i = 0; i + 1 < list.size();) {
      std::size_t end = i;
      while (end + 1 < list.size() && smooth[end]) ++end;
      if (end > i) {
        const auto from = static_cast<std::ptrdiff_t>(i), to = static_cast<std::ptrdiff_t>(end) + 1;
        make({path.begin() + from, path.begin() + to}, {list.begin() + from, list.begin() + to},
             false, frame);
      }
      i = std::max(end, i + 1);
    }
  }

  std::size_t size_of(const Node& n) const {
    return n.band < 0 ? 0 : bands_.list[static_cast<std::size_t>(n.band)].facets.size();
  }

  void make(const std::vector<std::int32_t>& path, const std::vector<Segment>& list, bool closed,
            const Patch& frame) {
    std::vector<Patch> made(path.size(), frame);
    std::vector<Patch*> pointers;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Node& n = node(path[i]);
      if (n.band >= 0) made[i] = patch(n.band);
      made[i].axis = frame.axis;
      made[i].normal = list[i].normal;
      made[i].offset = list[i].offset;
      made[i].chain = chains_;
      pointers.push_back(&made[i]);
    }
    bend(list, closed, facets_.noise, pointers);
    ++chains_;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Node& n = node(path[i]);
      if (n.band >= 0) {
        out_.patches[static_cast<std::size_t>(n.band)] = made[i];
      } else if (made[i].profile != Patch::Profile::Line) {
        out_.patch_of[static_cast<std::size_t>(n.flat)] =
            static_cast<std::int32_t>(out_.patches.size());
        out_.patches.push_back(made[i]);
      }
    }
  }

  /// Where round surfaces of one radius are united their polygons leave facets between them that
  /// are thinner than either sagitta: no more than rounding.
  void take_crescents() {
    for (std::size_t f = 0; f < facets_.list.size(); ++f) {
      if (f % 256 == 0) context_.check();
      if (out_.patch_of[f] >= 0) continue;
      const Facet& g = facets_.list[f];
      std::int32_t first = -1, second = -1;
      for (const FacetLink& l : g.links) {
        const std::int32_t p = out_.patch_of[static_cast<std::size_t>(l.facet)];
        if (p < 0 || p == first || p == second || !along(p, g)) continue;
        (first < 0 ? first : second) = p;
      }
      if (second >= 0) crescents_.emplace_back(f, first);
    }
    for (const auto& [f, p] : crescents_) out_.patch_of[f] = p;
  }

  /// Whether a facet lies within the sagitta of a patch and across it. All of it: the corners of
  /// half a disc lie on the ball that it halves.
  bool along(std::int32_t p, const Facet& g) const {
    const Patch& patch = out_.patches[static_cast<std::size_t>(p)];
    if (std::abs(glm::dot(patch.normal_at(g.center), g.normal)) > 0.5) return false;
    const auto near = [&](Vec3 q) {
      return glm::length(q - patch.project(q)) <= 1.2 * patch.sagitta + 3 * facets_.noise;
    };
    return std::ranges::all_of(g.vertices, [&](auto v) { return near(mesh_.positions[v]); }) &&
           std::ranges::all_of(g.triangles, [&](std::uint32_t t) {
             const Triangle& tri = mesh_.triangles[t];
             return near(
                 (mesh_.positions[tri[0]] + mesh_.positions[tri[1]] + mesh_.positions[tri[2]]) /
                 3.0);
           });
  }

  const TriMesh& mesh_;
  const Facets& facets_;
  std::vector<std::pair<std::size_t, std::int32_t>> crescents_;
  Bands bands_;
  const RunContext& context_;
  std::vector<Node> nodes_;
  std::map<std::int32_t, std::int32_t> flats_;
  std::int32_t chains_ = 0;
  Recognised out_;
};

}  // namespace

Recognised join_profiles(const TriMesh& mesh, const Facets& facets, Bands bands,
                         const RunContext& context) {
  return Joiner(mesh, facets, std::move(bands), context).run();
}

}  // namespace burin::recognised
