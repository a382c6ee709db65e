#include "contours.h"

#include "noise.h"
#include "paper_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

/// Where a contour with the front side to its left leaves triangle `f`: the half-edge that runs
/// from back to front. It comes in over the one that runs from front to back.
HalfEdge exit_of(const Facing& facing, std::uint32_t f) {
  for (HalfEdge h = static_cast<HalfEdge>(3 * f);; ++h) {
    if (!facing.front_at(h) && facing.front_at(next_in_face(h))) return h;
  }
}

HalfEdge entry_of(const Facing& facing, std::uint32_t f) {
  for (HalfEdge h = static_cast<HalfEdge>(3 * f);; ++h) {
    if (facing.front_at(h) && !facing.front_at(next_in_face(h))) return h;
  }
}

/// The half-edge beyond `h`, over which a contour goes on; kNoHalfEdge where it ends: at creases,
/// and at tips, where the next triangle may face one way.
HalfEdge beyond(const Facing& facing, HalfEdge h) {
  const auto i = static_cast<std::size_t>(h);
  if (facing.proxy().edge_kind[i] != EdgeKind::Smooth) return kNoHalfEdge;
  const HalfEdge o = facing.proxy().topology.opposite[i];
  return facing.crosses(o) ? o : kNoHalfEdge;
}

/// Where a segment of a contour enters its triangle and where it leaves it.
struct Chord {
  Vec3 in, out;
};

// The contour of a cut proxy is made of samples of the exact line, near enough to one another; on
// any other there is a surface to follow between the edges of the mesh.
bool follows_surface(const ProxyMesh& proxy) { return proxy.on_contour.empty(); }

Vec3 bary_on(HalfEdge h, double share) {
  Vec3 bary(0);
  bary[static_cast<int>(h % 3)] = 1 - share;
  bary[static_cast<int>(next_in_face(h) % 3)] = share;
  return bary;
}

/// Points and triangles of a contour under way; steps of no length are left out.
struct Trail {
  std::vector<Vec3> points, normals;
  std::vector<std::int32_t> faces;
  std::vector<Chord> chords;  // where the contour follows the surface

  /// The first point.
  void begin(const Facing& facing, HalfEdge entry) { add(facing, facing.crossing(entry), entry); }
  /// The next one: the way out of a triangle that it came into by `entry`.
  void add(const Facing& facing, HalfEdge entry, HalfEdge exit) {
    const ZeroCrossing zero = facing.crossing(exit);
    if (zero.position == points.back()) return;
    faces.push_back(static_cast<std::int32_t>(face_of(exit)));
    if (follows_surface(facing.proxy())) {
      chords.push_back({bary_on(entry, facing.crossing(entry).share), bary_on(exit, zero.share)});
    }
    add(facing, zero, exit);
  }
  /// Drops the repeated first point of a closed trail.
  bool close() {
    if (points.size() > 1 && points.front() == points.back()) {
      points.pop_back();
      normals.pop_back();
    }
    return points.size() >= 3;
  }

 private:
  void add(const Facing& facing, const ZeroCrossing& zero, HalfEdge h) {
    points.push_back(zero.position);
    normals.push_back(facing.normal(h, zero.share));
  }
};

// Puts points on the smooth surface between those on the edges of the mesh, wherever a chord would
// show: the zero of g inside a triangle is straight, the surface over it is not.
void follow_surface(const Facing& facing, const std::vector<Chord>& chords, Curve3& curve,
                    std::vector<std::uint8_t>& folded) {
  constexpr double kMostPieces = 16;
  Curve3 out = curve;
  std::vector<std::uint8_t> folds;
  out.points.clear(), out.normals.clear(), out.faces.clear();
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const std::size_t j = curve.next(i);
    const Vec3 &p = curve.points[i], &q = curve.points[j];
    const RoundedFacet facet = facing.over(static_cast<std::uint32_t>(curve.faces[i]));
    const auto over = [&](double t) { return facet.at(glm::mix(chords[i].in, chords[i].out, t)); };
    const double bulge =
        glm::distance(over(0.5), glm::mix(p, q, 0.5)) * facing.camera().scale_at(p);
    const auto pieces = static_cast<std::size_t>(
        std::clamp(std::ceil(std::sqrt(bulge / kRoundness)), 1.0, kMostPieces));
    for (std::size_t k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(pieces);
      out.points.push_back(k == 0 ? p : over(t));
      out.normals.push_back(
          k == 0 ? curve.normals[i]
                 : normalize_or(glm::mix(curve.normals[i], curve.normals[j], t), curve.normals[i]));
      out.faces.push_back(curve.faces[i]);
      folds.push_back(folded[i]);
    }
  }
  if (!curve.closed) {
    out.points.push_back(curve.points.back());
    out.normals.push_back(curve.normals.back());
  }
  out.self_hidden.assign(out.faces.size(), 0);
  curve = std::move(out);
  folded = std::move(folds);
}

class Tracer {
 public:
  Tracer(const Facing& facing, const RunContext& context)
      : facing_(facing),
        context_(context),
        mixed_(facing.mixed_faces(context)),
        used_(mixed_.size(), 0) {}

  const std::vector<std::uint32_t>& mixed() const { return mixed_; }
  bool used(std::size_t i) const { return used_[i] != 0; }

  /// Follows the contour from triangle `f` on; true where it came back to `f`.
  bool follow(std::uint32_t f, Trail& trail) {
    trail.begin(facing_, entry_of(facing_, f));
    for (std::uint32_t at = f;;) {
      mark(at);
      const HalfEdge out = exit_of(facing_, at);
      trail.add(facing_, entry_of(facing_, at), out);
      const HalfEdge in = beyond(facing_, out);
      if (in == kNoHalfEdge) return false;
      at = face_of(in);
      if (at == f) return true;
    }
  }

 private:
  void mark(std::uint32_t f) {
    used_[static_cast<std::size_t>(std::ranges::lower_bound(mixed_, f) - mixed_.begin())] = 1;
    if (++steps_ % 4096 == 0) context_.check();
  }

  const Facing& facing_;
  const RunContext& context_;
  std::vector<std::uint32_t> mixed_;
  std::vector<std::uint8_t> used_;
  std::size_t steps_ = 0;
};

/// Normals to the open side of the picture: outward where the front side is the nearer one, inward
/// under a fold. A point between both states follows the one that can be seen.
void open_normals(Curve3& curve, const std::vector<std::uint8_t>& folded) {
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool after = i < folded.size() ? folded[i] != 0 : folded.back() != 0;
    const bool before = i > 0 ? folded[i - 1] != 0 : (curve.closed ? folded.back() != 0 : after);
    if (before && after) curve.normals[i] = -curve.normals[i];
  }
}

/// The points from `begin` to `end` (segments; over the end of a closed curve) as a curve of its
/// own.
Curve3 piece(const Curve3& curve, std::size_t begin, std::size_t end) {
  Curve3 out;
  out.kind = curve.kind;
  out.source = curve.source;
  out.occluding = curve.occluding;
  const std::size_t n = curve.points.size();
  for (std::size_t i = begin; i <= end; ++i) {
    out.points.push_back(curve.points[i % n]);
    out.normals.push_back(curve.normals[i % n]);
    if (i < end) out.faces.push_back(curve.faces[i % n]);
  }
  out.self_hidden.assign(out.faces.size(), 0);
  return out;
}

/// Cuts at the cusps: an open sheet shows both its sides, so nothing of it hides itself for
/// certain, but the open side changes there.
void add_pieces(const Curve3& curve, const std::vector<std::uint8_t>& folded,
                std::vector<Curve3>& out) {
  const std::size_t m = folded.size();
  std::size_t start = 0;
  if (curve.closed) {
    while (start < m && folded[start] == folded[(start + m - 1) % m]) ++start;
  }
  if (start == m) {  // one state all round
    out.push_back(curve);
    if (folded[0]) open_normals(out.back(), folded);
    return;
  }
  for (std::size_t i = start, end = start + m; i < end;) {
    std::size_t j = i + 1;
    while (j < end && folded[j % m] == folded[i % m]) ++j;
    out.push_back(piece(curve, i, j));
    if (folded[i % m]) open_normals(out.back(), std::vector<std::uint8_t>(j - i, 1));
    i = j;
  }
}

}  // namespace

Contours trace_contours(const Facing& facing, std::int32_t part, const RunContext& context) {
  const ProxyMesh& proxy = facing.proxy();
  Tracer tracer(facing, context);
  Contours out;
  const auto trace = [&](std::uint32_t f) {
    Trail trail;
    Curve3 curve;
    curve.closed = tracer.follow(f, trail);
    if (curve.closed ? !trail.close() : trail.points.size() < 2) return;
    curve.kind = LineClass::Contour;
    curve.source = {part, proxy.face_region[f], -1};
    curve.occluding = true;
    curve.points = std::move(trail.points);
    curve.normals = std::move(trail.normals);
    curve.faces = std::move(trail.faces);
    curve.self_hidden.assign(curve.faces.size(), 0);
    if (curve.closed && is_noise(facing, curve)) {
      ++out.noise;
      return;
    }
    auto folded = folded_under(curve.points, curve.normals, curve.closed, facing.camera());
    if (follows_surface(proxy)) follow_surface(facing, trail.chords, curve, folded);
    if (proxy.closed(f)) {
      curve.self_hidden = std::move(folded);
      open_normals(curve, curve.self_hidden);
      out.curves.push_back(std::move(curve));
    } else {
      add_pieces(curve, folded, out.curves);
    }
  };
  for (const std::uint32_t f : tracer.mixed()) {  // open ones first: they must begin at their start
    if (beyond(facing, entry_of(facing, f)) == kNoHalfEdge) trace(f);
  }
  for (std::size_t i = 0; i < tracer.mixed().size(); ++i) {
    if (!tracer.used(i)) trace(tracer.mixed()[i]);
  }
  return out;
}

}  // namespace burin
