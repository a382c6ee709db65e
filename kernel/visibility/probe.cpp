#include "probe.h"

#include <burin/mesh/chord_error.h>
#include <burin/visibility/sight_ray.h>

#include "cutters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

// Triangles around a point on a fold that are the fold: over so many edges in any direction, which
// is two rings of vertices, or straight toward the viewer, where triangles are narrow across the
// line of sight. From a contour along a row of cuts it takes some twenty such; so far only to a
// triangle whose plane all but holds the point, or what truly lies before it would pass for its
// fold. Farthest while the surface's own normals face the viewer: to rise before its contour it
// would have to turn away first.
constexpr int kFoldSteps = 4, kFoldWalk = 8, kFoldLongWalk = 24, kFoldLongest = 64;
constexpr double kAllButOnPlane = 5;  // in what the proxies do not tell apart
// Edges of both triangles within which a fold can lie in front of its own contour: its polygons and
// its contour, which runs where interpolated normals turn away, differ by about an edge along the
// line of sight.
constexpr double kFoldReach = 2;

// Paper mm that an edge of an exact form lies off its own triangle, at the most: they follow it
// that closely.
constexpr double kMostOffEdge = 0.05;

// Paper mm by which fairing moves a stroke off its surface, at the most, where that bends evenly,
// and within which triangles that it was moved under lie before it: those that it runs over from
// one of its points to the next.
constexpr double kFaired = 0.005, kFairedReach = 0.5;

// Paper mm beside a contour, and its chord error, within which its own fold ends on its open side:
// contours run around facets that show over more than that.
constexpr double kFoldEnds = 0.1;

// Cosine below which a boundary is seen so flat that its own sheet may come to lie before it.
constexpr double kGrazing = 0.3;

// A fold that a point may lie on: a contour with the outside of the surface before it, or a
// stroke's point whose polygon faces away though its surface does not; a boundary seen flat.
enum class Fold { None, Contour, Stroke, Boundary };

// What a hit is judged by.
struct Origin {
  const Probe* probe;
  Vec3 point;
  std::int32_t part, face;
  double on_plane, error;
  bool on_edge;      // of a face, whose triangles end at its chords
  bool of_polygons;  // an intersection: it lies on the triangles of both, whatever they stand for
  Vec3 view;         // to the viewer
  Vec3 across;       // the normal of the plane of the line of sight and the surface normal
  Fold fold;
  double scale;  // paper mm a model mm, of what is faired: strokes; else 0
};

bool is_edge(LineClass kind) {
  return kind == LineClass::Boundary || kind == LineClass::Crease || kind == LineClass::Smooth ||
         kind == LineClass::Seam;
}

double plane_distance(const TriMesh& mesh, std::uint32_t face, Vec3 p) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 a = mesh.positions[t[0]];
  const Vec3 n = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
  const double length = glm::length(n);
  return length > 0 ? std::abs(glm::dot(n, p - a)) / length : 0;
}

// How far a point lies outside the edges of a triangle, along its plane.
double beside(const TriMesh& mesh, std::uint32_t face, Vec3 p) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 n = mesh.normal(face);
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = mesh.positions[t[i]], b = mesh.positions[t[(i + 1) % 3]];
    most = std::max(most, glm::dot(normalize_or(glm::cross(b - a, n), Vec3(0)), p - a));
  }
  return most;
}

double longest_edge(const TriMesh& mesh, std::uint32_t face) {
  double longest = 0;
  const Triangle& t = mesh.triangles[face];
  for (std::size_t i = 0; i < 3; ++i) {
    longest =
        std::max(longest, glm::distance(mesh.positions[t[i]], mesh.positions[t[(i + 1) % 3]]));
  }
  return longest;
}

// Whether `to` is among the triangles within kFoldSteps of `from`.
bool near_on_surface(const ProxyMesh& proxy, std::uint32_t from, std::uint32_t to) {
  std::array<std::uint32_t, 64> seen;  // steps 1 to 4 reach at most 3 + 6 + 12 + 24 others
  std::size_t count = 0, begin = 0;
  seen[count++] = from;
  for (int step = 0; step < kFoldSteps; ++step) {
    const std::size_t end = count;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t h = 3 * std::size_t{seen[i]} + k;
        if (proxy.edge_kind[h] != EdgeKind::Smooth) continue;
        const std::uint32_t next = face_of(proxy.topology.opposite[h]);
        if (next == to) return true;
        if (std::find(seen.begin(), seen.begin() + count, next) == seen.begin() + count) {
          seen[count++] = next;
        }
      }
    }
    begin = end;
  }
  return false;
}

// Whether a walk over smooth edges from the point, straight as the viewer sees it, comes to
// triangle `to` within so many steps; at first toward the viewer or away from it. `facing`: only
// over what faces the viewer by its normals.
bool walk_reaches(const ProxyMesh& proxy, const Origin& o, double direction, std::uint32_t to,
                  int steps, bool facing = false) {
  const TriMesh& mesh = proxy.mesh;
  const auto side = [&](std::uint32_t v) {
    return glm::dot(o.across, mesh.positions[v] - o.point);
  };
  auto face = static_cast<std::uint32_t>(o.face);
  HalfEdge from = kNoHalfEdge;
  for (int step = 0; step < steps; ++step) {
    HalfEdge out = kNoHalfEdge;
    double farthest = -std::numeric_limits<double>::infinity(), share = 0;
    for (HalfEdge h = static_cast<HalfEdge>(3 * face), end = h + 3; h < end; ++h) {
      const std::uint32_t a = origin(mesh, h), b = origin(mesh, next_in_face(h));
      const double u = side(a), v = side(b);
      if (h == from || (u < 0) == (v < 0)) continue;
      const Vec3 p = mesh.positions[a] + (u / (u - v)) * (mesh.positions[b] - mesh.positions[a]);
      const double along = direction * glm::dot(p - o.point, o.view);
      if (along > farthest) farthest = along, share = u / (u - v), out = h;
    }
    if (out == kNoHalfEdge || proxy.edge_kind[static_cast<std::size_t>(out)] != EdgeKind::Smooth) {
      return false;
    }
    if (facing) {
      Vec3 bary(0);
      bary[static_cast<int>(out % 3)] = 1 - share;
      bary[static_cast<int>(next_in_face(out) % 3)] = share;
      const Vec3 n = proxy.normal(face, bary);
      if (glm::dot(n, o.view) < 0) return false;
    }
    from = proxy.topology.opposite[static_cast<std::size_t>(out)];
    face = face_of(from);
    if (face == to) return true;
  }
  return false;
}

// Whether a hit belongs to the fold that the point lies on. `reported`: as clearance() has it.
bool on_same_fold(const ProxyMesh& proxy, const Origin& o, const Hit& hit, double reported) {
  const auto own = static_cast<std::uint32_t>(o.face);
  const double reach =
      kFoldReach * (longest_edge(proxy.mesh, own) + longest_edge(proxy.mesh, hit.where.face));
  if (hit.distance > reach) return false;
  // Of a rim the fold is exact but for the chord errors: what passes farther off is its other side.
  if (o.fold == Fold::Boundary && reported > kAllButOnPlane) return false;
  const int steps =
      o.fold == Fold::Contour && reported <= kAllButOnPlane ? kFoldLongWalk : kFoldWalk;
  return near_on_surface(proxy, own, hit.where.face) ||
         walk_reaches(proxy, o, +1, hit.where.face, steps) ||
         (o.fold == Fold::Contour &&
          walk_reaches(proxy, o, +1, hit.where.face, kFoldLongest, true)) ||
         (o.fold == Fold::Boundary && walk_reaches(proxy, o, -1, hit.where.face, steps));
}

// Whether a stroke was on a triangle before fairing moved it; `off`: model mm beyond what the
// proxies do not tell apart.
bool faired_under(const ProxyMesh& proxy, const Origin& o, const Hit& hit, double off) {
  return o.scale > 0 && off * o.scale < kFaired && hit.distance * o.scale < kFairedReach &&
         proxy.face_region[hit.where.face] == proxy.face_region[static_cast<std::size_t>(o.face)];
}

// How far the plane of a hit passes the point, in what the proxies do not tell apart there: no more
// than 1, or 0 on its own fold, where it does not hide.
// `folded` becomes true there.
double clearance(const Origin& o, const Hit& hit, bool& folded) {
  const bool own_part = hit.where.part == o.part && o.face >= 0;
  if (own_part && static_cast<std::int32_t>(hit.where.face) == o.face) return 0;
  const ProxyMesh& proxy = *o.probe->proxy(hit.where.part);
  const double distance = plane_distance(proxy.mesh, hit.where.face, o.point);
  const double error =
      o.of_polygons
          ? 0
          : o.probe->chord_error(hit.where.part, static_cast<std::int32_t>(hit.where.face));
  const double untold = o.on_plane + o.error + error;
  double reported = distance / untold;
  if (reported <= 1 || (own_part && faired_under(proxy, o, hit, distance - untold))) {
    return std::min(reported, 1.0);
  }
  // Edges of exact forms are drawn round, up to the sagitta of a chord beside it: there they are
  // over the next triangle, under which they lie where the surface rises.
  if (own_part && o.on_edge) {
    const double off = beside(proxy.mesh, static_cast<std::uint32_t>(o.face), o.point);
    reported = distance / (untold + std::min(off, o.probe->most_off_edge(o.point)));
    if (reported <= 1) return reported;
  }
  if (!own_part || o.fold == Fold::None || !on_same_fold(proxy, o, hit, reported)) return reported;
  folded = true;
  return 0;
}

// `normal` is the curve's; `back`: an open sheet is seen from behind.
Fold fold_at(const Curve3& curve, const ProxyMesh* proxy, std::int32_t face, Vec3 normal,
             bool sheet, bool back, Vec3 view) {
  if (!proxy || face < 0 || proxy->edge_kind.empty()) return Fold::None;
  const Vec3 polygon = proxy->mesh.normal(static_cast<std::uint32_t>(face));
  switch (curve.kind) {
    case LineClass::Contour:
      // An open sheet may be seen from behind: then the normals to the open side are turned round.
      return sheet || glm::dot(polygon, normal) > 0 ? Fold::Contour : Fold::None;
    case LineClass::Boundary:
      return std::abs(glm::dot(normal, view)) < kGrazing ? Fold::Boundary : Fold::None;
    case LineClass::Stroke:
    case LineClass::Pattern:
    case LineClass::Isophote:
      return glm::dot(back ? -polygon : polygon, view) < 0 ? Fold::Stroke : Fold::None;
    default:
      return Fold::None;
  }
}

// Whether what was taken for the fold of a contour goes on beside it: its own ends there. The outer
// outline is none of that, however far off its fold, and no other line is between it and the paper:
// contours zigzag across long narrow triangles, and a part of one may run along the outline.
bool covered_beside(const Origin& fold, double clear) {
  const Probe& probe = *fold.probe;
  const ProxyMesh& own = *probe.proxy(fold.part);
  const auto region = own.face_region[static_cast<std::size_t>(fold.face)];
  Origin o = fold;
  o.fold = Fold::None;
  const double off = kFoldEnds / probe.camera().scale_at(o.point) + o.error;
  bool folded = false;
  const auto covered = [&](Vec3 beside) {
    return probe.occluder().occluded_by(
        beside, o.view, 2 * probe.occluder().resolution(),
        probe.camera().distance_to_viewer(beside), [&](const Hit& hit) {
          return hit.where.part == o.part && own.face_region[hit.where.face] == region &&
                 clearance(o, hit, folded) > clear;
        });
  };
  const Vec3 side = off * normalize_or(glm::cross(o.across, o.view), Vec3(0));
  // Beside the outer outline is nothing a little farther out.
  constexpr double kFarther = 3;
  const auto outer = [&](Vec3 beside) {
    const double far = 2 * probe.occluder().diagonal();
    const Camera& camera = probe.camera();
    return !probe.occluder().occluded(beside, o.view, 0, far) &&
           !probe.occluder().occluded(beside, -o.view, 0, far) &&
           !probe.line_between(camera.to_paper(o.point), camera.to_paper(beside));
  };
  return covered(o.point + side) && !outer(o.point + kFarther * side);
}

}  // namespace

const ProxyMesh* Probe::proxy(std::int32_t part) const {
  const auto i = static_cast<std::size_t>(part);
  return part >= 0 && i < proxies_.size() ? proxies_[i] : nullptr;
}

double Probe::chord_error(std::int32_t part, std::int32_t face) const {
  const ProxyMesh* p = proxy(part);
  return p && face >= 0 ? burin::chord_error(*p, static_cast<std::uint32_t>(face)) : 0;
}

// What is known of how far a point lies beside its triangle: strokes are lifted off flat ones where
// those run into round ones, of which the triangle's own normals know little; edges of CAD files
// may bend where their faces do not.
double Probe::own_error(const Curve3& curve, std::int32_t face, Vec3 p) const {
  if (curve.kind == LineClass::Intersection) return 0;
  const double error = chord_error(curve.source.part, face);
  const ProxyMesh* own = proxy(curve.source.part);
  if (!own || face < 0) return error;
  const double most = lies_on_surface(curve) ? std::numeric_limits<double>::infinity()
                      : is_edge(curve.kind)  ? most_off_edge(p)
                                             : 0;
  if (!(most > error)) return error;
  const double off = plane_distance(own->mesh, static_cast<std::uint32_t>(face), p);
  return std::max(error, std::min(off, most));
}

double Probe::most_off_edge(Vec3 p) const { return kMostOffEdge / camera_.scale_at(p); }

bool Probe::line_between(Vec2 from, Vec2 to) const {
  constexpr double kClear = 0.02;  // paper mm, from the line that the first point is on
  if (!lines_) return false;
  Crossings crossings;
  lines_->cross({.a = from, .b = to}, CutRule::AnyDepth, crossings);
  const double clear = kClear / glm::distance(from, to);
  return std::ranges::any_of(crossings.cuts, [&](double share) { return share > clear; });
}

bool Probe::visible(const Curve3& curve, std::size_t segment, double t) const {
  return !hidden_by(curve, segment, t, 1);
}

bool Probe::hidden_by(const Curve3& curve, std::size_t segment, double t, double clear) const {
  return hidden(curve, segment, t, {.clear = clear});
}

bool Probe::hidden_by_smooth(const Curve3& curve, std::size_t segment, double t,
                             double clear) const {
  return hidden(curve, segment, t, {.clear = clear, .smooth = true});
}

bool Probe::hidden_by_others(const Curve3& curve, std::size_t segment, double t) const {
  return hidden(curve, segment, t, {.others = true});
}

bool Probe::hidden(const Curve3& curve, std::size_t segment, double t, Asked asked) const {
  const std::size_t after = curve.next(segment);
  const Vec3 p = glm::mix(curve.points[segment], curve.points[after], t);
  const Vec3 view = camera_.to_viewer(p);
  const std::int32_t face = curve.faces.empty() ? -1 : curve.faces[segment];
  const double resolution = occluder_.resolution();
  const std::int32_t part = curve.source.part;
  const ProxyMesh* own = proxy(part);
  Vec3 n(0);
  const bool sheet = own && face >= 0 && !own->topology.face_component.empty() &&
                     !own->closed(static_cast<std::uint32_t>(face));
  bool back = false;
  if (!curve.normals.empty()) {
    n = normalize_or(glm::mix(curve.normals[segment], curve.normals[after], t), Vec3(0));
    back = sheet && curve.kind != LineClass::Contour && glm::dot(n, view) < 0;
    if (back) n = -n;  // an open sheet is seen from both sides
  }
  const Origin origin{this,
                      p,
                      part,
                      face,
                      kOnPlane * resolution,
                      asked.smooth ? chord_error(part, face) : own_error(curve, face, p),
                      is_edge(curve.kind),
                      curve.kind == LineClass::Intersection && !asked.smooth,
                      view,
                      glm::cross(view, n),
                      fold_at(curve, own, face, n, sheet, back, view),
                      lies_on_surface(curve) ? camera_.scale_at(p) : 0};
  const Vec3 start = p + n * (origin.error + resolution);
  const Origin* o = &origin;
  bool folded = false;
  const bool hides = occluder_.occluded_by(start, view, 2 * resolution,
                                           camera_.distance_to_viewer(start), [&](const Hit& hit) {
                                             if (asked.others && hit.where.part == o->part)
                                               return false;
                                             return clearance(*o, hit, folded) > asked.clear;
                                           });
  if (hides || !folded || origin.fold != Fold::Contour) return hides;
  return covered_beside(origin, asked.clear);
}

bool Probe::paper_covered(Vec2 paper) const {
  const ViewRay ray = sight_ray(camera_, paper, occluder_);
  return occluder_.occluded(ray.origin, ray.direction, 0, std::numeric_limits<double>::infinity());
}

std::optional<Probe::Seen> Probe::seen_at(Vec2 paper) const {
  const ViewRay ray = sight_ray(camera_, paper, occluder_);
  const auto hit =
      occluder_.first_hit(ray.origin, ray.direction, 0, std::numeric_limits<double>::infinity());
  if (!hit) return std::nullopt;
  return Seen{hit->where, ray.origin + hit->distance * ray.direction};
}

}  // namespace burin
