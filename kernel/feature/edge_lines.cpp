#include "edge_lines.h"

#include "hair.h"
#include "paper_limits.h"

#include <array>
#include <cmath>
#include <utility>

namespace burin {

namespace {

/// A part of an edge along which neither side changes its facing.
struct Step {
  Vec3 from{0}, to{0};
  /// Unit normals of the surface to the left and to the right at both ends; a boundary has no
  /// right.
  std::array<Vec3, 2> left, right;
  bool left_front = false, right_front = false;
  /// Of a smooth edge: a contour runs along it.
  bool on_contour = false;
  HalfEdge half_edge = kNoHalfEdge;
};

/// What a step is; steps with equal looks become one curve.
struct Look {
  LineClass kind = LineClass::Crease;
  bool drawn = true;
  bool face_left = true;
  /// Sign of the sum of both normals towards the open side.
  int open = 1;
  /// Drawn where nothing but paper is behind it.
  bool border_alone = false;
  friend bool operator==(const Look&, const Look&) = default;
};

struct LookAndHidden {
  Look look;
  bool hidden = false;
};

LookAndHidden crease_look(bool left_front, bool right_front, bool convex, bool closed) {
  if (left_front == right_front) {
    const bool away = !left_front;
    return {{LineClass::Crease, true, true, closed || !away ? 1 : -1}, closed && away};
  }
  // A fold. In a hollow the face turned away covers the one turned to the viewer.
  return {{LineClass::Contour, true, left_front, closed || convex ? 1 : -1}, closed && !convex};
}

class ChainWalk {
 public:
  ChainWalk(const Facing& facing, const EdgeChain& chain)
      : facing_(facing), smooth_(chain.kind == EdgeKind::Smooth && !chain.fold) {
    for (const HalfEdge h : chain.edges) add_edge(h);
  }
  const std::vector<Step>& steps() const { return steps_; }

 private:
  void add_edge(HalfEdge h) {
    const ProxyMesh& proxy = facing_.proxy();
    const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(h)];
    struct Cut {
      double share;
      Vec3 position;
      bool left;
    };
    std::array<Cut, 4> cuts{};
    std::size_t count = 0;
    cuts[count++] = {0, proxy.mesh.positions[origin(proxy.mesh, h)], false};
    if (facing_.crosses(h)) {
      const ZeroCrossing zero = facing_.crossing(h);
      cuts[count++] = {zero.share, zero.position, true};
    }
    if (o != kNoHalfEdge && facing_.crosses(o)) {
      const ZeroCrossing zero = facing_.crossing(o);
      cuts[count++] = {1 - zero.share, zero.position, false};
    }
    cuts[count++] = {1, proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))], false};
    if (count == 4 && cuts[1].share > cuts[2].share) std::swap(cuts[1], cuts[2]);
    Step step;
    step.half_edge = h;
    step.left_front = facing_.front_at(h);
    step.right_front = o != kNoHalfEdge && facing_.front_at(next_in_face(o));
    if (smooth_ && count == 2 && !step.left_front) {
      const bool left = front_beside(h), right = front_beside(o);
      step.left_front = step.right_front = left && right;
      step.on_contour = left != right;
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
      if (i > 0) (cuts[i].left ? step.left_front : step.right_front) ^= true;
      step.from = cuts[i].position;
      step.to = cuts[i + 1].position;
      if (step.from == step.to) continue;
      for (std::size_t end = 0; end < 2; ++end) {
        const double share = cuts[i + end].share;
        step.left[end] = facing_.normal(h, share);
        step.right[end] = o == kNoHalfEdge ? Vec3(0) : facing_.normal(o, 1 - share);
      }
      steps_.push_back(step);
    }
  }

  /// Whether the triangle of a half-edge with both ends turned away is turned to the viewer right
  /// from that edge on: then a contour runs along it.
  bool front_beside(HalfEdge h) const {
    const HalfEdge in = next_in_face(h), out = prev_in_face(h);
    if (!facing_.front_at(out)) return false;
    const TriMesh& mesh = facing_.proxy().mesh;
    const Vec3 &a = mesh.positions[origin(mesh, h)], &b = mesh.positions[origin(mesh, in)];
    const Vec3 along = normalize_or(b - a, Vec3(0));
    const auto near = [&](HalfEdge crossed) {
      const Vec3 off = reject(facing_.crossing(crossed).position - a, along);
      return glm::length(off) * facing_.camera().scale_at(a) < kAlongEdge;
    };
    return near(in) && near(out);
  }

  const Facing& facing_;
  bool smooth_;
  std::vector<Step> steps_;
};

/// Unit vectors across the edge into the triangles of both its sides.
std::array<Vec3, 2> into_faces(const ProxyMesh& proxy, const Step& step, Vec3 along) {
  const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(step.half_edge)];
  std::array<Vec3, 2> into{};
  for (std::size_t i = 0; i < 2; ++i) {
    const HalfEdge h = i == 0 ? step.half_edge : o;
    const Vec3& apex = proxy.mesh.positions[origin(proxy.mesh, prev_in_face(h))];
    into[i] = normalize_or(reject(apex - step.from, along), Vec3(0));
  }
  return into;
}

/// Across the edge, away from both its triangles: where their normals cancel out (a knife's edge).
Vec3 away_from_faces(const ProxyMesh& proxy, const Step& step) {
  const Vec3 along = normalize_or(step.to - step.from, Vec3(1, 0, 0));
  const auto into = into_faces(proxy, step, along);
  return normalize_or(-(into[0] + into[1]), any_orthogonal(along));
}

/// What the triangles at an edge say of its bend.
enum class Bend { Knife, Flat, Plain };

/// Knife: both lie on each other, so that nothing of them tells a knife's edge from a hollow. Flat:
/// they do not bend although the normals do. The normals of a surface that is bent sharply right at
/// its edge, as lofts are at their tips, may tell both wrong.
Bend bend_of(const ProxyMesh& proxy, const Step& step) {
  constexpr double kSameSide = 0.94;    // cosine: 20 degrees
  constexpr double kNoBend = 0.035;     // sine: 2 degrees
  constexpr double kBentNormals = 0.2;  // sine: 12 degrees
  const Vec3 along = normalize_or(step.to - step.from, Vec3(1, 0, 0));
  const auto into = into_faces(proxy, step, along);
  if (glm::dot(into[0], into[1]) > kSameSide) return Bend::Knife;
  const bool flat = glm::length(glm::cross(into[0], into[1])) < kNoBend;
  for (std::size_t end = 0; flat && end < 2; ++end) {
    if (glm::length(glm::cross(step.left[end], step.right[end])) > kBentNormals) return Bend::Flat;
  }
  return Bend::Plain;
}

Vec3 crease_normal(const ProxyMesh& proxy, const Step& step, std::size_t end, int open) {
  const Vec3 sum = step.left[end] + step.right[end];
  constexpr double kCancelled = 1e-3;  // Radians off a knife's edge: the sum is rounding below it.
  if (glm::dot(sum, sum) < kCancelled * kCancelled) return away_from_faces(proxy, step);
  return glm::normalize(sum) * static_cast<double>(open);
}

class LineMaker {
 public:
  LineMaker(const Facing& facing, const EdgeChain& chain, SourceId source)
      : facing_(facing), chain_(chain), source_(source), walk_(facing, chain) {
    closed_mesh_ = facing.proxy().closed(face_of(chain.edges.front()));
  }

  void make(const FeatureOptions& options, std::vector<Curve3>& out) {
    const std::vector<Step>& steps = walk_.steps();
    const std::size_t n = steps.size();
    if (n == 0) return;
    std::size_t start = 0;
    if (chain_.closed) {
      while (start < n && look(start).look == look((start + n - 1) % n).look) ++start;
    }
    if (start == n) return add(0, n, true, options, out);
    for (std::size_t i = start, end = start + n; i < end;) {
      std::size_t j = i + 1;
      while (j < end && look(j % n).look == look(i % n).look) ++j;
      add(i, j, false, options, out);
      i = j;
    }
  }

 private:
  LookAndHidden look(std::size_t i) const {
    if (chain_.kind == EdgeKind::Boundary) return {{LineClass::Boundary, true, true, 1}, false};
    const Step& s = walk_.steps()[i];
    if (chain_.fold) {
      LookAndHidden out = crease_look(s.left_front, s.right_front, is_ridge(s), closed_mesh_);
      out.look.drawn = s.left_front != s.right_front;
      return out;
    }
    if (chain_.kind == EdgeKind::Smooth) {
      if (s.on_contour) return {{LineClass::Smooth, false, true, 1}, false};
      LookAndHidden out = crease_look(s.left_front, s.right_front, true, closed_mesh_);
      out.look.kind = chain_.seam ? LineClass::Seam : LineClass::Smooth;
      return out;
    }
    LookAndHidden out =
        crease_look(s.left_front, s.right_front,
                    chain_.kind == EdgeKind::ConvexCrease || doubtful(s), closed_mesh_);
    if (out.look.kind == LineClass::Crease && at_cut(s)) out.look.kind = LineClass::Section;
    if (changes_plane(s)) {
      out.look.border_alone = out.look.kind == LineClass::Contour;
      out.look.drawn = out.look.border_alone;
    }
    return out;
  }

  /// Whether a cut goes on in another plane here and one of the two is seen edge-on: drawings show
  /// a stepped section as if it lay in one plane. @cite ISO128
  bool changes_plane(const Step& step) const {
    constexpr double kEdgeOn = 1e-3;  // sine
    const ProxyMesh& proxy = facing_.proxy();
    const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(step.half_edge)];
    if (facing_.camera().perspective() || o == kNoHalfEdge) return false;
    const std::uint32_t f = face_of(step.half_edge), g = face_of(o);
    if (!proxy.is_cut(f) || !proxy.is_cut(g)) return false;
    const Vec3 to_viewer = facing_.camera().direction();
    const auto edge_on = [&](std::uint32_t face) {
      return std::abs(glm::dot(proxy.mesh.normal(face), to_viewer)) < kEdgeOn;
    };
    return edge_on(f) != edge_on(g);
  }

  /// Whether one of its sides closes a cut.
  bool at_cut(const Step& step) const {
    const ProxyMesh& proxy = facing_.proxy();
    const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(step.half_edge)];
    return proxy.is_cut(face_of(step.half_edge)) || (o != kNoHalfEdge && proxy.is_cut(face_of(o)));
  }

  /// Whether the triangles at a fold bend away from the outside.
  bool is_ridge(const Step& step) const {
    const ProxyMesh& proxy = facing_.proxy();
    const HalfEdge h = step.half_edge, o = proxy.topology.opposite[static_cast<std::size_t>(h)];
    const Vec3& apex = proxy.mesh.positions[origin(proxy.mesh, prev_in_face(o))];
    return glm::dot(proxy.mesh.normal(face_of(h)), apex - step.from) <= 0;
  }

  /// A hollow that may be none.
  bool doubtful(const Step& step) const {
    return chain_.kind == EdgeKind::ConcaveCrease && bend_of(facing_.proxy(), step) != Bend::Plain;
  }

  Vec3 normal(const Step& step, std::size_t end, int open) const {
    if (chain_.kind != EdgeKind::Boundary) {
      if (doubtful(step) && bend_of(facing_.proxy(), step) == Bend::Knife) {
        return away_from_faces(facing_.proxy(), step);
      }
      return crease_normal(facing_.proxy(), step, end, open);
    }
    const Vec3& n = step.left[end];
    const Vec3 v = facing_.camera().to_viewer(end == 0 ? step.from : step.to);
    return glm::dot(n, v) < 0 ? -n : n;
  }

  static bool wanted(LineClass kind, const FeatureOptions& options) {
    if (kind == LineClass::Boundary) return options.boundaries;
    if (kind == LineClass::Contour) return options.contours;
    if (kind == LineClass::Smooth || kind == LineClass::Seam) return true;  // else not in the list
    return options.creases;
  }

  void add(std::size_t begin, std::size_t end, bool closed, const FeatureOptions& options,
           std::vector<Curve3>& out) const {
    const std::vector<Step>& steps = walk_.steps();
    const std::size_t n = steps.size();
    const Look first = look(begin % n).look;
    if (!first.drawn || !wanted(first.kind, options)) return;
    const auto& proxy = facing_.proxy();
    Curve3 curve;
    curve.kind = first.kind;
    curve.closed = closed;
    curve.border_alone = first.border_alone;
    curve.occluding = first.kind == LineClass::Contour || first.kind == LineClass::Boundary;
    if (chain_.kind == EdgeKind::ConvexCrease) curve.crease_sign = 1;
    if (chain_.kind == EdgeKind::ConcaveCrease) curve.crease_sign = -1;
    for (std::size_t i = begin; i < end; ++i) {
      const Step& s = steps[i % n];
      const HalfEdge h = first.face_left
                             ? s.half_edge
                             : proxy.topology.opposite[static_cast<std::size_t>(s.half_edge)];
      curve.points.push_back(s.from);
      curve.normals.push_back(normal(s, 0, first.open));
      curve.faces.push_back(static_cast<std::int32_t>(face_of(h)));
      curve.self_hidden.push_back(look(i % n).hidden);
    }
    if (!closed) {
      const Step& last = steps[(end - 1) % n];
      curve.points.push_back(last.to);
      curve.normals.push_back(normal(last, 1, first.open));
    }
    curve.source = source_;
    curve.source.face = proxy.face_source(static_cast<std::uint32_t>(curve.faces.front()));
    out.push_back(std::move(curve));
  }

  const Facing& facing_;
  const EdgeChain& chain_;
  SourceId source_;
  ChainWalk walk_;
  bool closed_mesh_ = false;
};

}  // namespace

std::vector<Curve3> edge_lines(const Facing& facing, std::span<const EdgeChain> chains,
                               std::int32_t part, const FeatureOptions& options,
                               const RunContext& context) {
  std::vector<Curve3> out;
  const bool exact = !facing.proxy().source_edge.empty();  // its creases are no noise
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (i % 1024 == 0) context.check();
    FeatureOptions wanted = options;
    wanted.contours |= wanted.creases;  // a crease that is a contour is still a crease
    SourceId source{part, -1, chains[i].source};
    if (!exact && !chains[i].fold && is_hair(facing, chains[i])) {
      // Folds of the picture that run along a hair are contours like those before and after it.
      wanted.creases = false;
      source.edge = -1;
    }
    LineMaker(facing, chains[i], source).make(wanted, out);
  }
  return out;
}

}  // namespace burin
