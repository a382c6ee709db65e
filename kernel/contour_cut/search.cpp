#include "search.h"

#include <burin/base/bracketed_zero.h>
#include <burin/base/nearest_along.h>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

using What = Incision::What;

/// Where on a chord the contour is looked at: off the middle, where an S would meet its chord.
constexpr double kLook = 0.4;

/// Chords of fewer times `chord` than this are short enough whatever the contour does there.
constexpr double kShortest = 2;

/// How far places are from a chord on paper.
class Chord {
 public:
  Chord(const Camera& camera, const Vec3& a, const Vec3& b)
      : camera_(camera), a_(a), b_(b), from_(camera.to_paper(a)), to_(camera.to_paper(b)) {
    const double length = glm::distance(a, b) * camera.scale_at(a);
    end_on_ = glm::distance(from_, to_) < kEndOn * length;
  }

  /// Where along the chord, in space, a place is.
  double share(const Vec3& p) const {
    const Vec3 d = b_ - a_;
    return std::clamp(glm::dot(p - a_, d) / glm::dot(d, d), 0.0, 1.0);
  }
  double off(const Vec3& p) const {
    const Vec2 q = camera_.to_paper(p);
    if (end_on_) return glm::distance(q, camera_.to_paper(a_ + share(p) * (b_ - a_)));
    return distance_to_segment(from_, to_, q);
  }

  /// How far an S may be from its chord that passes at a place near it at a slant: a fifth of the
  /// chord's length times the slope, as the cubic is that meets the chord in the middle.
  double slant(const FaceSample& s) const {
    const Vec2 way = camera_.velocity(s.position, s.along), d = to_ - from_;
    const double length = glm::length(way);
    return end_on_ || !(length > 0) ? 0 : 0.22 * std::abs(cross2(d, way)) / length;
  }

 private:
  // A contour that turns back on paper, in a cusp, runs along the view there: its tip may lie
  // beyond the end of a chord that it is near to in width. Cosine of the angle to the paper.
  static constexpr double kEndOn = 0.7;

  const Camera& camera_;
  Vec3 a_, b_;
  Vec2 from_, to_;
  bool end_on_ = false;
};

FaceSample side_sample(const EdgePoint& p, std::size_t side) {
  FaceSample s;
  s.uv = p.uv[side];
  s.position = p.position;
  s.normal = p.normal[side];
  s.g = p.own_g[side];
  return s;
}

}  // namespace

double CutSearch::edge_length(HalfEdge h) const {
  const Vec3& a = mesh_.position(h);
  return mesh_.on_paper(a, glm::distance(a, mesh_.position(next_in_face(h))));
}

Vec2 CutSearch::uv_at(std::uint32_t face, Vec3 bary) const {
  const auto h = static_cast<HalfEdge>(3 * face);
  return bary.x * mesh_.uv(h) + bary.y * mesh_.uv(h + 1) + bary.z * mesh_.uv(h + 2);
}

double CutSearch::shift_at(std::uint32_t face, Vec3 bary) const {
  const auto h = static_cast<HalfEdge>(3 * face);
  return bary.x * mesh_.shift(h) + bary.y * mesh_.shift(h + 1) + bary.z * mesh_.shift(h + 2);
}

/// A place on an edge, its g with the correction that the ends of an edge inside a face have: a
/// vertex that is put there has to see what the corners around it see. Without it a face seen
/// edge-on beside a tangent edge would change its sign at each new vertex.
EdgePoint CutSearch::point_on(HalfEdge h, double share) const {
  EdgePoint out = mesh_.edge_point(h, share);
  if (mesh_.mesh().border[static_cast<std::size_t>(h)] >= 0) return out;
  const double shift = (1 - share) * mesh_.shift(h) + share * mesh_.shift(next_in_face(h));
  for (double& g : out.g) g += shift;
  return out;
}

Incision CutSearch::zero(HalfEdge h) const {
  const HalfEdge o = mesh_.opposite(h);
  const std::size_t side = crosses_in(h) ? 0 : 1;
  Incision out;
  out.half_edge = h;
  const bool sharp = mesh_.sharp(h);
  const HalfEdge from = side == 0 ? h : next_in_face(o), to = side == 0 ? next_in_face(h) : o;
  const bool border = mesh_.mesh().border[static_cast<std::size_t>(h)] >= 0;
  double shift_0 = 0, shift_1 = 0;
  if (border && !sharp) {  // g of the edge is by the mean of both faces
    shift_0 = mesh_.g(from) - mesh_.edge_point(h, 0).g[side];
    shift_1 = mesh_.g(to) - mesh_.edge_point(h, 1).g[side];
  } else {
    shift_0 = mesh_.shift(from);
    shift_1 = mesh_.shift(to);
  }
  EdgePoint last;
  const auto value = [&](double t) {
    last = mesh_.edge_point(h, t);
    return last.g[side] + (1 - t) * shift_0 + t * shift_1;
  };
  const double t = bracketed_zero(value, mesh_.g(from), mesh_.g(to));
  if (last.share != t) last = mesh_.edge_point(h, t);
  const double scale = mesh_.on_paper(last.position, 1);
  const double to_origin = glm::distance(last.position, mesh_.position(h)) * scale;
  const double to_target = glm::distance(last.position, mesh_.position(next_in_face(h))) * scale;
  last.zero = {!sharp || side == 0, !sharp || side == 1};
  out.point = last;
  out.side = side;
  out.what = What::SplitEdge;
  if (std::min(to_origin, to_target) < options_.snap || t <= 0 || t >= 1) {
    out.what = to_origin <= to_target ? What::MarkOrigin : What::MarkTarget;
    out.place = side_sample(last, side);
  }
  return out;
}

bool CutSearch::chord(HalfEdge h) const {
  return !mesh_.sharp(h) && mesh_.sign(h) == 0 && mesh_.sign(next_in_face(h)) == 0;
}

/// The sign of g in the triangle of `h` beyond its edge, whose ends are zero.
int CutSearch::side_sign(HalfEdge h) const {
  const int apex = mesh_.sign(prev_in_face(h));
  if (apex != 0) return apex;
  const std::uint32_t f = face_of(h);
  const Vec3 middle(1.0 / 3);
  const double g = mesh_.sample(mesh_.face(h), uv_at(f, middle)).g + shift_at(f, middle);
  return g > 0 ? 1 : -1;
}

Incision CutSearch::bulge(HalfEdge h) const {
  for (const HalfEdge side : {h, mesh_.opposite(h)}) {
    const Incision inside = all_zero(side);
    if (inside.what != What::Nothing) return inside;
  }
  const int left = side_sign(h), right = side_sign(mesh_.opposite(h));
  return left == right ? false_chord(h, left, right) : true_chord(h, left);
}

/// A triangle with three zeros that is turned to the viewer needs a corner that says so.
Incision CutSearch::all_zero(HalfEdge h) const {
  Incision out;
  if (mesh_.sign(prev_in_face(h)) != 0 || side_sign(h) < 0) return out;
  out.face = face_of(h);
  const Vec3 middle(1.0 / 3);
  out.place = mesh_.sample(mesh_.face(h), uv_at(out.face, middle));
  out.shift = shift_at(out.face, middle);
  if (out.place.g + out.shift > kNumericNoise) out.what = What::SplitFace;
  return out;
}

/// An edge between two zeros with the same sign on both sides is no contour, but would be taken
/// for one (twice) between two front triangles.
Incision CutSearch::false_chord(HalfEdge h, int left, int) const {
  Incision out;
  out.half_edge = h;
  const double length = edge_length(h);
  if (length < options_.snap) return out;
  out.point = point_on(h, 0.5);
  const double g = out.point.g[0];
  if (std::abs(g) <= kNumericNoise) return out;
  if (left > 0 || (g > 0 && length > 4 * options_.chord)) out.what = What::SplitEdge;
  return out;
}

Incision CutSearch::true_chord(HalfEdge h, int left) const {
  Incision out;
  out.half_edge = h;
  const Vec3 &a = mesh_.position(h), &b = mesh_.position(next_in_face(h));
  if (edge_length(h) < kShortest * options_.chord) return out;
  const Chord line(mesh_.camera(), a, b);
  const bool border = mesh_.mesh().border[static_cast<std::size_t>(h)] >= 0;
  const double shift = (1 - kLook) * mesh_.shift(h) + kLook * mesh_.shift(next_in_face(h));
  const FaceSample middle = mesh_.sample(mesh_.face(h), mesh_.uv_on(h, kLook));
  const double g = middle.g + shift;
  if (std::abs(g) <= kNumericNoise && line.off(middle.position) <= options_.chord) return out;
  bool slanted = false;
  if (middle.distance < 1e300) {  // to first order the contour is near: is that so?
    const FaceSample near = mesh_.sample(mesh_.face(h), middle.uv + middle.to_zero);
    slanted = line.slant(near) > 0.7 * options_.chord;
    if (!slanted && line.off(near.position) <= 0.5 * options_.chord &&
        near.distance <= 0.5 * middle.distance) {
      return out;
    }
  }
  out.point = point_on(h, kLook);
  // The contour lies on the side where g beyond the edge has the other sign than on it.
  out.side = (g > 0) == (left > 0) ? 1 : 0;
  const HalfEdge apex = prev_in_face(out.side == 0 ? h : mesh_.opposite(h));
  if (border || mesh_.sign(apex) == 0) {
    if (mesh_.on_paper(middle.position, middle.distance) <= options_.snap) {
      if (line.off(middle.position) <= options_.chord) return out;
      out.point.zero = {true, true};
    }
    out.what = What::SplitEdge;
    return out;
  }
  const Vec2 start = out.point.uv[out.side];
  const HalfEdge in = next_in_face(apex);
  FaceSample end;
  if (const auto exit = across(in, start, middle.to_zero)) {  // straight to the contour
    end = mesh_.sample(mesh_.face(in), start + 0.999 * (exit->uv - start));
    if ((end.g > 0) == (g > 0)) {
      const Incision leaves = split_at_exit(*exit, g);
      if (leaves.what != What::Nothing) return leaves;
    } else {
      out.place = zero_between(mesh_.face(in), {start, g, shift}, {end.uv, end.g, 0});
      if (slanted || line.off(out.place.position) > options_.chord) out.what = What::Detour;
      return out;
    }
  }
  out.place = zero_between(mesh_.face(in), {start, g, shift},
                           {mesh_.uv(apex), mesh_.g(apex), mesh_.shift(apex)});
  if (std::abs(line.share(out.place.position) - 0.5) > 0.35) {
    out.what = What::SplitEdge;  // seen from the apex it is behind the ends of the chord
  } else if (slanted || line.off(out.place.position) > options_.chord) {
    out.what = What::Detour;
  }
  return out;
}

/// A contour that leaves the triangle of its chord by an edge that does not know of it: the edge
/// gets a vertex there.
Incision CutSearch::split_at_exit(const Exit& exit, double g) const {
  Incision out;
  out.half_edge = exit.half_edge;
  out.point = point_on(exit.half_edge, exit.share);
  const double scale = mesh_.on_paper(out.point.position, 1);
  for (const HalfEdge end : {exit.half_edge, next_in_face(exit.half_edge)}) {
    if (glm::distance(out.point.position, mesh_.position(end)) * scale < options_.snap) return out;
  }
  if ((out.point.g[0] > 0) == (g > 0)) out.what = What::SplitEdge;
  return out;
}

/// Where the straight line in (u,v) from a place on the edge of `h` along `way` leaves the
/// triangle; nowhere where `way` does not lead into it.
std::optional<CutSearch::Exit> CutSearch::across(HalfEdge h, Vec2 from, Vec2 way) const {
  const Vec2 a = mesh_.uv(h), b = mesh_.uv(next_in_face(h)), apex = mesh_.uv(prev_in_face(h));
  const double area = cross2(b - a, apex - a);
  const double up = cross2(b - a, way) / area;  // how fast the weights of the corners change
  if (!(up > 0) || !std::isfinite(up)) return {};
  const double left = cross2(apex - b, way) / area, right = -up - left;
  const double at_a = cross2(b - from, apex - from) / area, at_b = 1 - at_a;
  const double t_left = left < 0 ? at_a / -left : 1e300;
  const double t_right = right < 0 ? at_b / -right : 1e300;
  const double t = std::min(t_left, t_right);
  if (!(t > 0) || !(t < 1e300)) return {};
  Exit out;
  out.uv = from + t * way;
  const double high = std::clamp(t * up, 0.0, 1.0);
  out.half_edge = t_left <= t_right ? next_in_face(h) : prev_in_face(h);
  out.share = t_left <= t_right ? high : 1 - high;
  return out;
}

/// The zero on the straight line in (u,v) between two places.
FaceSample CutSearch::zero_between(std::int32_t face, const Known& from, const Known& to) const {
  FaceSample last;
  double last_t = -1;
  const auto value = [&](double t) {
    last = mesh_.sample(face, from.uv + t * (to.uv - from.uv));
    last_t = t;
    return last.g + (1 - t) * from.shift + t * to.shift;
  };
  const double t = bracketed_zero(value, from.g, to.g);
  if (last_t != t) value(t);
  return last;
}

}  // namespace burin
