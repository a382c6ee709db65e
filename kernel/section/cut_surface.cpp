#include "cut_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin::detail {
namespace {

/// Halvings of a step that goes over a plane.
constexpr int kBisections = 26;
/// A march takes steps of at least this share of it beside a cut: what goes into it for less is not
/// seen.
constexpr double kFewestSteps = 64;
/// Barycentric: a place so far beside a piece lies in it.
constexpr double kBeside = 1e-6;
/// Triangles that a march on the flat face goes over.
constexpr int kMostTriangles = 10'000;

/// Barycentric coordinates of `p` in a triangle of barycentric corners: all of them lie in the
/// plane where the sum is 1, so two of the three equations tell.
Vec3 within(const std::array<Vec3, 3>& corners, Vec3 p) {
  const Vec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], d = p - corners[0];
  const double a = glm::dot(e1, e1), b = glm::dot(e1, e2), c = glm::dot(e2, e2);
  const double det = a * c - b * b;
  if (!(det > 0)) return {1, 0, 0};
  const double x = glm::dot(d, e1), y = glm::dot(d, e2);
  const double u = (c * x - b * y) / det, v = (a * y - b * x) / det;
  return {1 - u - v, u, v};
}

Vec3 clamped(Vec3 bary) {
  bary = glm::max(bary, Vec3(0));
  return bary / (bary.x + bary.y + bary.z);
}

}  // namespace

CutSurface::CutSurface(std::shared_ptr<const Surface> whole, CutProxy cut, CutRegion region)
    : whole_(std::move(whole)),
      proxy_(std::move(cut.proxy)),
      pieces_(std::move(cut.pieces)),
      first_(whole_->proxy().mesh.triangles.size() + 1, 0),
      region_(std::move(region)) {
  for (const FacetPiece& piece : pieces_) {
    if (piece.facet != kNoFacet) ++first_[piece.facet + 1];
  }
  for (std::size_t f = 1; f < first_.size(); ++f) first_[f] += first_[f - 1];
}

SurfacePoint CutSurface::inner(SurfacePoint point) const {
  point.triangle = pieces_[point.triangle].facet;
  return point;
}

double CutSurface::locate(std::uint32_t facet, Vec3 bary, ProxyPoint& out) const {
  double best = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = first_[facet]; i < first_[facet + 1]; ++i) {
    const Vec3 local = within(pieces_[i].bary, bary);
    const double least = std::min({local.x, local.y, local.z});
    if (least > best) best = least, out = {i, local};
  }
  if (std::isfinite(best)) out.bary = clamped(out.bary);
  return best;
}

double CutSurface::beyond(Vec3 p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const CutPlane& plane : region_) {
    least = std::min(least, glm::dot(plane.normal, p) - plane.offset);
  }
  return least;
}

bool CutSurface::adopt(SurfacePoint& end) const {
  if (beyond(end.position) > 0) return false;
  ProxyPoint place;
  const ProxyPoint there = whole_->to_proxy(end);
  // The proxy may end before the surface does: there it ends.
  if (locate(there.face, there.bary, place) < -kBeside) return false;
  end.triangle = place.face;
  return true;
}

MarchStep CutSurface::march(const SurfacePoint& from, Vec3 tangent, double length) const {
  if (closes(from.triangle)) return march_flat(from, tangent, length);
  // No step is longer than the way to the cut, so that none goes into it and comes back.
  MarchStep all{.end = from, .direction = tangent};
  for (const double least = length / kFewestSteps; all.length < length;) {
    const double way = std::min(length - all.length, std::max(least, -beyond(all.end.position)));
    const MarchStep step = march_to_cut(all.end, all.direction, way);
    all = {.end = step.end,
           .direction = step.direction,
           .length = all.length + step.length,
           .stop = step.stop};
    if (step.stop != MarchStop::Completed) break;
  }
  return all;
}

std::optional<double> CutSurface::inside_of_chord(Vec3 from, Vec3 to) const {
  double enters = 0, leaves = 1;
  for (const CutPlane& plane : region_) {
    const double a = glm::dot(plane.normal, from) - plane.offset;
    const double b = glm::dot(plane.normal, to) - plane.offset;
    if (a <= 0 && b <= 0) return std::nullopt;
    if ((a > 0) == (b > 0)) continue;
    double& end = b > 0 ? enters : leaves;
    end = b > 0 ? std::max(end, a / (a - b)) : std::min(end, a / (a - b));
  }
  if (!(enters < leaves)) return std::nullopt;
  return 0.5 * (enters + leaves);
}

MarchStep CutSurface::march_to_cut(const SurfacePoint& from, Vec3 tangent, double length) const {
  const SurfacePoint start = inner(from);
  MarchStep step = whole_->march(start, tangent, length);
  double near = 0, far = step.length;
  if (adopt(step.end)) {
    // Over a corner of what is gone, from one of its sides to another?
    const auto share = inside_of_chord(from.position, step.end.position);
    if (!share) return step;
    far *= *share;
    MarchStep middle = whole_->march(start, tangent, far);
    if (adopt(middle.end)) return step;
  }
  MarchStep last{.end = from, .direction = step.direction, .length = 0};
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (near + far);
    MarchStep tried = whole_->march(start, tangent, middle);
    if (adopt(tried.end)) {
      near = middle;
      last = tried;
    } else {
      far = middle;
    }
  }
  last.stop = MarchStop::Crease;
  return last;
}

MarchStep CutSurface::march_flat(const SurfacePoint& from, Vec3 tangent, double length) const {
  const Vec3 normal = normal_of(from.triangle);
  MarchStep step{.end = from, .direction = reject(tangent, normal)};
  const double size = glm::length(step.direction);
  if (!(size > 0)) {
    step.stop = MarchStop::Singular;
    return step;
  }
  step.direction /= size;
  const TriMesh& mesh = proxy_.mesh;
  HalfEdge came = kNoHalfEdge;
  for (int i = 0; i < kMostTriangles; ++i) {
    const auto first = static_cast<HalfEdge>(3 * step.end.triangle);
    HalfEdge out = kNoHalfEdge;
    double way = length - step.length;
    for (HalfEdge h = first; h < first + 3; ++h) {
      if (h == came) continue;
      const Vec3 &a = mesh.positions[origin(mesh, h)],
                 &b = mesh.positions[origin(mesh, next_in_face(h))];
      const Vec3 outward = glm::cross(b - a, normal);
      const double speed = glm::dot(outward, step.direction);
      if (!(speed > 0)) continue;
      const double until = std::max(0.0, glm::dot(outward, a - step.end.position) / speed);
      if (until < way) way = until, out = h;
    }
    step.end.position += way * step.direction;
    step.length += way;
    const HalfEdge over =
        out == kNoHalfEdge ? kNoHalfEdge : proxy_.topology.opposite[static_cast<std::size_t>(out)];
    if (out != kNoHalfEdge && (over == kNoHalfEdge || !closes(face_of(over)) ||
                               pieces_[face_of(over)].plane != pieces_[from.triangle].plane)) {
      step.stop = over == kNoHalfEdge ? MarchStop::Boundary : MarchStop::Crease;
    }
    if (out == kNoHalfEdge || step.stop != MarchStop::Completed) break;
    came = over;
    step.end.triangle = face_of(over);
  }
  const Triangle& t = mesh.triangles[step.end.triangle];
  step.end.coords = clamped(within(
      {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, step.end.position));
  return step;
}

Frame CutSurface::frame(const SurfacePoint& point) const {
  if (!closes(point.triangle)) return whole_->frame(inner(point));
  Frame frame;
  frame.position = point.position;
  frame.normal = normal_of(point.triangle);
  frame.d1 = any_orthogonal(frame.normal);
  frame.d2 = glm::cross(frame.normal, frame.d1);
  frame.kind = FaceKind::Plane;
  return frame;
}

ProxyPoint CutSurface::to_proxy(const SurfacePoint& point) const {
  if (closes(point.triangle)) return {point.triangle, point.coords};
  const ProxyPoint there = whole_->to_proxy(inner(point));
  ProxyPoint place;
  if (!std::isfinite(locate(there.face, there.bary, place))) {
    place = {point.triangle, clamped(within(pieces_[point.triangle].bary, there.bary))};
  }
  return place;
}

SurfacePoint CutSurface::lift(const ProxyPoint& point) const {
  if (closes(point.face)) {
    return {.chart = 0,
            .coords = point.bary,
            .position = proxy_.position(point.face, point.bary),
            .triangle = point.face};
  }
  const FacetPiece& piece = pieces_[point.face];
  const Vec3 bary =
      point.bary.x * piece.bary[0] + point.bary.y * piece.bary[1] + point.bary.z * piece.bary[2];
  SurfacePoint lifted = whole_->lift({piece.facet, bary});
  lifted.triangle = point.face;
  return lifted;
}

Vec3 CutSurface::drawn_position(const SurfacePoint& point) const {
  return closes(point.triangle) ? point.position : whole_->drawn_position(inner(point));
}

}  // namespace burin::detail
