#include "cut_mesh.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {

namespace {

constexpr std::size_t kCornerGrain = 8192;

/// Of a period or of the domain: (u,v) of one corner as both its triangles have it.
constexpr double kSameUv = 1e-9;

/// Wedges whose normals are as near as this (radians) to those of their faces have them.
constexpr double kAlike = 1e-6;

/// One partial is this small against the other, over the whole domain each: a pole.
constexpr double kPole = 1e-7;

double cross_at(Vec2 a, Vec2 b, Vec2 c) { return cross2(b - a, c - a); }

}  // namespace

CutMesh::CutMesh(ChartMesh& mesh, const Sampler& surface, const Camera& camera,
                 const RunContext& context)
    : mesh_(mesh),
      surface_(surface),
      camera_(camera),
      facing_(camera),
      opposite_(chart_mesh_opposites(mesh)),
      g_(opposite_.size()),
      shift_(opposite_.size(), 0),
      pole_(opposite_.size(), 0),
      version_(mesh.triangles.size(), 0),
      watch_(opposite_.size(), -1),
      requests_(opposite_.size(), 0) {
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    kinds_.push_back(surface.kind(static_cast<std::int32_t>(f)));
  }
  std::vector<std::uint8_t> blended(mesh.positions.size(), 0);
  for (std::size_t h = 0; h < opposite_.size(); ++h) {
    const auto half_edge = static_cast<HalfEdge>(h);
    if (mesh.border[h] < 0 || sharp(half_edge)) continue;
    blended[vertex(half_edge)] = blended[vertex(next_in_face(half_edge))] = 1;
  }
  parallel_for(
      g_.size(), kCornerGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = begin; h < end; ++h) {
          const auto corner = static_cast<HalfEdge>(h);
          const bool none = mesh_.normal[h] == Vec3(0);
          g_[h] = none ? 0 : facing_(position(corner), mesh_.normal[h]);
          mesh_.on_contour[h] = g_[h] == 0;
          if (!none && blended[vertex(corner)]) {
            shift_[h] = std::numeric_limits<double>::quiet_NaN();
          }
        }
      },
      &context);
  find_poles();
}

bool CutMesh::sharp(HalfEdge h) const { return sharp_edge(mesh_, opposite_[at(h)], at(h)); }

void CutMesh::find_poles() {
  std::vector<std::uint8_t> suspects;
  for (std::size_t i = 0; i < opposite_.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    const HalfEdge o = opposite_[i];
    if (o < h || mesh_.border[i] >= 0) continue;
    const Vec2 a = uv(next_in_face(o)) - uv(h), b = uv(o) - uv(next_in_face(h));
    if (a == b) continue;
    const Vec2 size = surface_.domain_size(face(h));
    if (std::abs(a.x - b.x) <= kSameUv * size.x && std::abs(a.y - b.y) <= kSameUv * size.y) {
      continue;
    }
    suspects.resize(mesh_.positions.size(), 0);
    suspects[vertex(h)] = suspects[vertex(o)] = 1;
  }
  if (!suspects.empty()) mark_poles(suspects);
}

void CutMesh::mark_poles(const std::vector<std::uint8_t>& suspects) {
  for (std::size_t i = 0; i < opposite_.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    if (!suspects[vertex(h)]) continue;
    const SurfaceSample d = surface_.sample(face(h), uv(h));
    const Vec2 size = surface_.domain_size(face(h));
    const double u = glm::length(d.u) * size.x, v = glm::length(d.v) * size.y;
    pole_[i] = u <= kPole * v ? 1 : v <= kPole * u ? 2 : 0;
  }
}

FaceSample CutMesh::sample(std::int32_t face, Vec2 uv) const {
  const SurfaceSample d = surface_.sample(face, uv);
  FaceSample s;
  s.uv = uv;
  s.position = d.position;
  s.normal = d.normal;
  s.g = facing_(d.position, s.normal);
  s.distance = std::numeric_limits<double>::infinity();
  const double area = glm::length(glm::cross(d.u, d.v));
  if (!(area > 0)) return s;
  // The viewer's own change is tangent and drops out.
  const Vec3 view = reject(facing_.to_viewer(d.position), s.normal);
  const Vec2 gradient(glm::dot(d.normal_u, view), glm::dot(d.normal_v, view));
  s.gradient = gradient;
  const double e = glm::dot(d.u, d.u), f = glm::dot(d.u, d.v), g = glm::dot(d.v, d.v);
  const Vec2 up = Vec2(g * gradient.x - f * gradient.y, e * gradient.y - f * gradient.x) /
                  (area * area);  // the steepest way, by the first fundamental form
  const double steep = glm::dot(gradient, up);
  if (!(steep > 0)) return s;
  s.to_zero = -s.g / steep * up;
  s.distance = std::abs(s.g) / std::sqrt(steep);
  s.along = gradient.x * d.v - gradient.y * d.u;
  return s;
}

double CutMesh::shift(HalfEdge corner) const {
  const double known = shift_[at(corner)];
  if (!std::isnan(known)) return known;
  const std::int32_t f = face(corner);
  const SurfaceSample d = surface_.sample(f, uv(corner));
  return g(corner) - facing_(d.position, d.normal);
}

Vec2 CutMesh::uv_on(HalfEdge h, double share) const {
  Vec2 a = uv(h), b = uv(next_in_face(h));
  const std::uint8_t pole_a = pole_[at(h)], pole_b = pole_[at(next_in_face(h))];
  if (pole_a == 1) a.x = b.x;
  if (pole_a == 2) a.y = b.y;
  if (pole_b == 1) b.x = a.x;
  if (pole_b == 2) b.y = a.y;
  const Vec2 straight = a + share * (b - a);
  if (mesh_.border[at(h)] < 0) return straight;
  const ChartMesh::Border& border = mesh_.borders[static_cast<std::size_t>(mesh_.border[at(h)])];
  if (border.coedge < 0) return straight;
  Vec2 on = surface_.on_coedge(border.coedge, border.t0 + share * (border.t1 - border.t0));
  const Vec2 period = surface_.period(face(h));
  for (int k = 0; k < 2; ++k) {
    if (period[k] > 0) on[k] += period[k] * std::round((straight[k] - on[k]) / period[k]);
  }
  return on;
}

EdgePoint CutMesh::edge_point(HalfEdge h, double share) const {
  const HalfEdge o = opposite_[at(h)];
  EdgePoint out;
  out.share = share;
  const std::size_t sides = o == kNoHalfEdge ? 1 : 2;
  const bool inside = mesh_.border[at(h)] < 0;
  for (std::size_t k = 0; k < sides; ++k) {
    const HalfEdge side = k == 0 ? h : o;
    out.uv[k] = uv_on(side, k == 0 ? share : 1 - share);
    if (k == 1 && inside) {
      out.normal[1] = out.normal[0];
      out.own_g[1] = out.own_g[0];
      break;
    }
    const SurfaceSample d = surface_.sample(face(side), out.uv[k]);
    out.normal[k] = d.normal;
    out.own_g[k] = facing_(d.position, out.normal[k]);
    out.position += d.position;
  }
  if (sides == 2 && !inside) {
    out.position *= 0.5;
    if (!sharp(h)) out.normal[0] = out.normal[1] = border_normal(h, share, out.normal);
  }
  for (std::size_t k = 0; k < sides; ++k) out.g[k] = facing_(out.position, out.normal[k]);
  return out;
}

/// The normal on a smooth model edge: the mean of those of both faces there, and what the wedges at
/// its ends have beside that mean, spread along the edge: faces may agree but roughly.
Vec3 CutMesh::border_normal(HalfEdge h, double share, const std::array<Vec3, 2>& faces) const {
  const HalfEdge o = opposite_[at(h)];
  const auto mean = [](Vec3 a, Vec3 b) { return normalize_or(a + b, a); };
  const auto own = [&](HalfEdge corner) {
    return surface_.sample(face(corner), uv(corner)).normal;
  };
  const auto lean = [&](HalfEdge one, HalfEdge other) {
    if (normal(one) == Vec3(0)) return Vec3(0);
    const Vec3 off = normal(one) - mean(own(one), own(other));
    return glm::dot(off, off) > kAlike * kAlike ? off : Vec3(0);
  };
  const Vec3 more = (1 - share) * lean(h, next_in_face(o)) + share * lean(next_in_face(h), o);
  const Vec3 n = mean(faces[0], faces[1]);
  return more == Vec3(0) ? n : normalize_or(n + more, n);
}

void CutMesh::watch(std::vector<HalfEdge>& edges) {
  watched_ = &edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    watch_[at(edges[i])] = static_cast<std::int32_t>(i);
  }
}

void CutMesh::unwatch() {
  for (const HalfEdge h : *watched_) watch_[at(h)] = -1;
  watched_ = nullptr;
}

void CutMesh::request(HalfEdge h, Request what) {
  requests_[at(h)] |= what;
  requested_[what - 1].push_back(h);
}

std::vector<HalfEdge> CutMesh::take_requests(Request what) {
  std::vector<HalfEdge> out = std::exchange(requested_[what - 1], {});
  std::erase_if(out, [&](HalfEdge h) { return (requests_[at(h)] & what) == 0; });
  for (HalfEdge& h : out) {
    requests_[at(h)] &= static_cast<std::uint8_t>(~what);
    if (opposite_[at(h)] != kNoHalfEdge) h = std::min(h, opposite_[at(h)]);
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::uint32_t CutMesh::add_triangle(std::uint32_t like) {
  const auto f = static_cast<std::uint32_t>(mesh_.triangles.size());
  mesh_.triangles.push_back(mesh_.triangles[like]);
  mesh_.face.push_back(mesh_.face[like]);
  const std::size_t n = 3 * mesh_.triangles.size();
  mesh_.uv.resize(n);
  mesh_.normal.resize(n);
  mesh_.on_contour.resize(n);
  mesh_.border.resize(n, -1);
  opposite_.resize(n, kNoHalfEdge);
  g_.resize(n);
  shift_.resize(n);
  pole_.resize(n);
  watch_.resize(n, -1);
  requests_.resize(n, 0);
  version_.push_back(0);
  return f;
}

void CutMesh::copy_corner(HalfEdge from, HalfEdge to) {
  const std::size_t a = at(from), b = at(to);
  mesh_.triangles[b / 3][b % 3] = mesh_.triangles[a / 3][a % 3];
  mesh_.uv[b] = mesh_.uv[a];
  mesh_.normal[b] = mesh_.normal[a];
  mesh_.on_contour[b] = mesh_.on_contour[a];
  g_[b] = g_[a];
  shift_[b] = shift_[a];
  pole_[b] = pole_[a];
}

void CutMesh::set_corner(HalfEdge corner, std::uint32_t vertex, const EdgePoint& point,
                         std::size_t side) {
  const std::size_t c = at(corner);
  mesh_.triangles[c / 3][c % 3] = vertex;
  mesh_.uv[c] = point.uv[side];
  mesh_.normal[c] = point.normal[side];
  g_[c] = point.zero[side] ? 0 : point.g[side];
  mesh_.on_contour[c] = g_[c] == 0;
  shift_[c] = g_[c] - point.own_g[side];
  pole_[c] = 0;
}

void CutMesh::link(HalfEdge a, HalfEdge b) {
  if (a != kNoHalfEdge) opposite_[at(a)] = b;
  if (b != kNoHalfEdge) opposite_[at(b)] = a;
}

/// The edge of half-edge `from` as that of `to`: its border, its opposite, who watches it and what
/// is to be done there.
void CutMesh::move_edge(HalfEdge from, HalfEdge to) {
  mesh_.border[at(to)] = mesh_.border[at(from)];
  link(to, opposite_[at(from)]);
  mesh_.border[at(from)] = -1;
  opposite_[at(from)] = kNoHalfEdge;
  if (watched_ != nullptr && watch_[at(from)] >= 0) {
    (*watched_)[static_cast<std::size_t>(watch_[at(from)])] = to;
    std::swap(watch_[at(from)], watch_[at(to)]);
  }
  requests_[at(to)] = std::exchange(requests_[at(from)], std::uint8_t{0});
  for (const Request what : {Cut, Look}) {
    if ((requests_[at(to)] & what) != 0) requested_[what - 1].push_back(to);
  }
}

/// (a, b, c) becomes (a, m, c) and (m, b, c), the first in the place of the old triangle. Returns
/// the half-edge from m to b.
HalfEdge CutMesh::split_side(HalfEdge h, std::uint32_t vertex, const EdgePoint& point,
                             std::size_t side, double edge_parameter) {
  const std::uint32_t f = face_of(h), f2 = add_triangle(f);
  const HalfEdge next = next_in_face(h), last = prev_in_face(h);
  const auto in_new = [&](HalfEdge e) { return static_cast<HalfEdge>(3 * f2) + e % 3; };
  const HalfEdge h2 = in_new(h);
  copy_corner(next, in_new(next));
  copy_corner(last, in_new(last));
  move_edge(next, in_new(next));
  set_corner(next, vertex, point, side);
  set_corner(h2, vertex, point, side);
  link(next, in_new(last));
  if (mesh_.border[at(h)] >= 0) {
    mesh_.border[at(h2)] = static_cast<std::int32_t>(mesh_.borders.size());
    mesh_.borders.push_back(mesh_.borders[static_cast<std::size_t>(mesh_.border[at(h)])]);
    mesh_.borders.back().t0 = edge_parameter;
    mesh_.borders[static_cast<std::size_t>(mesh_.border[at(h)])].t1 = edge_parameter;
  }
  ++version_[f];
  return h2;
}

HalfEdge CutMesh::split_edge(HalfEdge h, const EdgePoint& point) {
  const HalfEdge o = opposite_[at(h)];
  const auto vertex = static_cast<std::uint32_t>(mesh_.positions.size());
  mesh_.positions.push_back(point.position);
  const auto parameter = [&](HalfEdge e, double share) {
    if (mesh_.border[at(e)] < 0) return 0.0;
    const auto& border = mesh_.borders[static_cast<std::size_t>(mesh_.border[at(e)])];
    return border.t0 + share * (border.t1 - border.t0);
  };
  const double t = parameter(h, point.share);
  double t_other = o == kNoHalfEdge ? 0 : parameter(o, 1 - point.share);
  // Both sides have the same bits where they count alike.
  if (std::abs(t - t_other) <= 1e-9 * std::max(std::abs(t), std::abs(t_other))) t_other = t;
  const HalfEdge h2 = split_side(h, vertex, point, 0, t);
  if (o != kNoHalfEdge) {
    const HalfEdge o2 = split_side(o, vertex, point, 1, t_other);
    link(h, o2);
    link(h2, o);
  }
  return h2;
}

void CutMesh::split_face(std::uint32_t f, const FaceSample& sample, double shift) {
  const auto vertex = static_cast<std::uint32_t>(mesh_.positions.size());
  mesh_.positions.push_back(sample.position);
  EdgePoint point;
  point.uv[0] = sample.uv;
  point.normal[0] = sample.normal;
  point.own_g[0] = sample.g;
  point.g[0] = sample.g + shift;
  const auto a = static_cast<HalfEdge>(3 * f), b = a + 1, c = a + 2;
  const auto b2 = static_cast<HalfEdge>(3 * add_triangle(f));
  const auto c2 = static_cast<HalfEdge>(3 * add_triangle(f));
  // (a, b, m), (b, c, m), (c, a, m)
  copy_corner(b, b2);
  copy_corner(c, b2 + 1);
  copy_corner(c, c2);
  copy_corner(a, c2 + 1);
  move_edge(b, b2);
  move_edge(c, c2);
  for (const HalfEdge m : {c, b2 + 2, c2 + 2}) set_corner(m, vertex, point, 0);
  link(b, b2 + 2);
  link(b2 + 1, c2 + 2);
  link(c2 + 1, c);
  ++version_[f];
}

std::vector<HalfEdge> CutMesh::wedge(HalfEdge corner) const {
  std::vector<HalfEdge> out;
  HalfEdge h = corner;
  for (;;) {
    out.push_back(h);
    const HalfEdge in = prev_in_face(h);
    if (sharp(in)) break;
    h = opposite_[at(in)];
    if (h == corner) return out;
  }
  for (h = corner; !sharp(h);) {
    h = next_in_face(opposite_[at(h)]);
    out.push_back(h);
  }
  return out;
}

/// Whether all corners of a vertex may move by a step in (u,v): none on an edge of the model, and
/// no triangle turns over.
bool CutMesh::may_move(const std::vector<HalfEdge>& wedge, Vec2 by) const {
  for (const HalfEdge h : wedge) {
    const HalfEdge next = next_in_face(h), last = prev_in_face(h);
    if (sharp(last) || mesh_.border[at(h)] >= 0 || mesh_.border[at(last)] >= 0 || pole(h)) {
      return false;
    }
    const double before = cross_at(uv(h), uv(next), uv(last));
    const double after = cross_at(uv(h) + by, uv(next), uv(last));
    if (!(after * before > 0) || std::abs(after) < 0.5 * std::abs(before)) return false;
  }
  return true;
}

void CutMesh::mark_zero(HalfEdge corner, const FaceSample* zero) {
  const std::vector<HalfEdge> corners = wedge(corner);
  const Vec2 by = zero == nullptr ? Vec2(0) : zero->uv - uv(corner);
  const bool move = zero != nullptr && may_move(corners, by);
  if (move) mesh_.positions[vertex(corner)] = zero->position;
  for (const HalfEdge h : corners) {
    const std::size_t c = at(h);
    if (move) {
      mesh_.uv[c] += by;
      mesh_.normal[c] = zero->normal;
      shift_[c] = -zero->g;
    } else {
      shift_[c] = shift(h) - g_[c];
    }
    g_[c] = 0;
    mesh_.on_contour[c] = 1;
    ++version_[face_of(h)];
  }
}

}  // namespace burin
