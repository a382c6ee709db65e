// Contours that no corner of a triangle sees.

#include "search.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

using What = Incision::What;

/// Where in (0,1) the parabola through the values at 0, 1/2 and 1 is lowest; 1/2 where it is not
/// inside.
double lowest_of_parabola(double at_0, double at_half, double at_1) {
  const double bend = 2 * (at_0 + at_1) - 4 * at_half;
  if (!(bend > 0)) return 0.5;
  const double t = (3 * at_0 - 4 * at_half + at_1) / (2 * bend);
  return t > 0.02 && t < 0.98 ? t : 0.5;
}

}  // namespace

bool CutSearch::within_reach(HalfEdge a, HalfEdge b, double lowest, double length) const {
  const double turn = glm::distance(mesh_.normal(a), mesh_.normal(b));
  const FaceKind kind = mesh_.kind(a);
  if (kind == FaceKind::Plane) return false;
  // On surfaces whose normals turn evenly g is within an eighth of turn^2 of linear; on others the
  // normals may turn to and fro as far as the tolerance of the triangles lets them.
  const double reach = kind == FaceKind::Freeform ? 0.5 * turn + 8 * mesh_.mesh().tolerance / length
                                                  : 0.25 * turn * turn;
  return lowest <= reach;
}

bool CutSearch::suspect_in(HalfEdge h) const {
  if (h == kNoHalfEdge) return false;
  const HalfEdge to = next_in_face(h);
  const int a = mesh_.sign(h), b = mesh_.sign(to);
  if (a * b < 0 || (a == 0 && b == 0)) return false;
  const double length = glm::distance(mesh_.position(h), mesh_.position(to));
  if (mesh_.on_paper(mesh_.position(h), length) < 4 * options_.chord) return false;
  return within_reach(h, to, std::min(std::abs(mesh_.g(h)), std::abs(mesh_.g(to))), length);
}

/// Whether a place with g of the wrong sign is far enough beyond the contour to matter.
bool CutSearch::deep(const FaceSample& s, double g) const {
  return std::abs(g) > kNumericNoise &&
         mesh_.on_paper(s.position, s.distance) > 0.5 * options_.chord;
}

Incision CutSearch::hidden_crossing(HalfEdge h) const {
  for (const int side : {0, 1}) {
    const HalfEdge in = side == 0 ? h : mesh_.opposite(h);
    if (!suspect_in(in)) continue;
    const Incision found = dip_in(h, side);
    if (found.what != What::Nothing || !mesh_.sharp(h)) return found;
  }
  return {};
}

Incision CutSearch::dip_in(HalfEdge h, int side) const {
  const auto k = static_cast<std::size_t>(side);
  const HalfEdge o = mesh_.opposite(h), in = side == 0 ? h : o;
  const HalfEdge from = side == 0 ? h : next_in_face(o), to = side == 0 ? next_in_face(h) : o;
  const double sign = mesh_.g(from) + mesh_.g(to) > 0 ? 1 : -1;
  Incision out;
  out.half_edge = h;
  FaceSample here;
  double lowest = 1e300, at = 0;
  const auto look = [&](double t) {
    const EdgePoint point = point_on(h, t);
    const double g = sign * point.g[k];
    if (g >= lowest) return false;
    lowest = g, at = t;
    out.point = point;
    here = mesh_.sample(mesh_.face(in), point.uv[k]);
    if (g < 0 && deep(here, g)) out.what = What::SplitEdge;
    return out.what == What::Nothing;
  };
  look(0.5);
  const double ends = std::min(sign * mesh_.g(from), sign * mesh_.g(to)), middle = lowest;
  const double t = lowest_of_parabola(sign * mesh_.g(from), middle, sign * mesh_.g(to));
  if (out.what == What::Nothing && std::abs(t - 0.5) > 0.05) look(t);
  for (const HalfEdge beside : {h, o}) {  // where a contour comes near over a triangle beside it
    if (out.what != What::Nothing || beside == kNoHalfEdge) continue;
    const HalfEdge apex = prev_in_face(beside);
    if (mesh_.face(apex) != mesh_.face(in) || sign * mesh_.g(apex) > 0) continue;
    const Vec3 &a = mesh_.position(h), along = mesh_.position(next_in_face(h)) - a;
    const double share = glm::dot(mesh_.position(apex) - a, along) / glm::dot(along, along);
    if (share > 0.02 && share < 0.98) look(share);
  }
  if (lowest > 0.9 * ends) return out;
  // Down along the edge to the zero and beyond it.
  const Vec2 way = (mesh_.uv(next_in_face(in)) - mesh_.uv(in)) * (side == 0 ? 1.0 : -1.0);
  for (int step = 0; step < 3 && out.what == What::Nothing && lowest > 0; ++step) {
    const double slope = sign * glm::dot(here.gradient, way);
    if (slope == 0 || !look(std::clamp(at - 1.5 * lowest / slope, 0.02, 0.98))) break;
  }
  return out;
}

bool CutSearch::suspect_face(std::uint32_t face) const {
  const auto h = static_cast<HalfEdge>(3 * face);
  int front = 0, back = 0;
  double lowest = 1e300, longest = 0;
  for (HalfEdge k = h; k < h + 3; ++k) {
    front += mesh_.sign(k) > 0;
    back += mesh_.sign(k) < 0;
    lowest = std::min(lowest, std::abs(mesh_.g(k)));
    longest = std::max(longest, glm::distance(mesh_.position(k), mesh_.position(next_in_face(k))));
  }
  if (front * back > 0 || front + back == 0) return false;
  const Vec3 &a = mesh_.position(h), &b = mesh_.position(h + 1), &c = mesh_.position(h + 2);
  const double height = glm::length(glm::cross(b - a, c - a)) / std::max(longest, 1e-300);
  if (mesh_.on_paper(a, height) < 4 * options_.chord) return false;
  return within_reach(h, h + 1, lowest, longest) || within_reach(h + 1, h + 2, lowest, longest) ||
         within_reach(h + 2, h, lowest, longest);
}

Incision CutSearch::hidden_loop(std::uint32_t face) const {
  const auto h = static_cast<HalfEdge>(3 * face);
  const double sign = mesh_.g(h) + mesh_.g(h + 1) + mesh_.g(h + 2) > 0 ? 1 : -1;
  Incision out;
  out.face = face;
  Vec3 best(1.0 / 3);
  FaceSample at_best;
  double lowest = 1e300;
  const auto look = [&](Vec3 bary) {
    const FaceSample s = mesh_.sample(mesh_.face(h), uv_at(face, bary));
    const double g = sign * (s.g + shift_at(face, bary));
    if (g < lowest) best = bary, at_best = s, lowest = g;
    return g;
  };
  look(Vec3(1.0 / 3));
  const double corner = std::min({sign * mesh_.g(h), sign * mesh_.g(h + 1), sign * mesh_.g(h + 2)});
  for (int k = 0; k < 3; ++k) {
    Vec3 bary(0.5);
    bary[k] = 0;
    look(bary);
  }
  if (lowest > 0.9 * corner && lowest > 0 && corner > 0) return out;
  // Down to the zero and beyond it, by steps half as long again as first order asks for, or shorter
  // ones where those lead out of the triangle or up again.
  const Vec2 p = mesh_.uv(h), q = mesh_.uv(h + 1) - p, r = mesh_.uv(h + 2) - p;
  const double area = cross2(q, r);
  double stride = 1.5;
  for (int step = 0; step < 10 && stride > 0.2; ++step) {
    if (!(at_best.distance < 1e300) || area == 0) break;
    const Vec2 next = at_best.uv + (lowest > 0 ? stride : -stride) * at_best.to_zero - p;
    const double y = cross2(next, r) / area, z = cross2(q, next) / area;
    const Vec3 bary(1 - y - z, y, z);
    const double before = lowest;
    if (std::min({bary.x, bary.y, bary.z}) < 0.02 || look(bary) >= before) {
      stride *= 0.5;
    } else if (lowest < 0 && deep(at_best, lowest)) {
      break;
    }
  }
  if (lowest >= 0 || !deep(at_best, lowest)) return out;
  if (std::min({best.x, best.y, best.z}) < 0.02) return out;  // edges are looked at themselves
  out.place = at_best;
  out.shift = sign * lowest - at_best.g;
  out.what = What::SplitFace;
  return out;
}

}  // namespace burin
