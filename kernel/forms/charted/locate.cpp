#include "locate.h"

#include <burin/surface/candidates.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::detail {
namespace {

// A partial derivative whose effect over a triangle is below this share of the other's is none.
constexpr double kCollapsed = 1e-6;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Rounding of a place in (u,v) and of what is computed from it, as a share of its coordinates.
constexpr double kNoise = 1000 * std::numeric_limits<double>::epsilon();
}  // namespace

UvTriangles::UvTriangles(const PlacedAtlas& atlas, const ChartMesh& mesh,
                         const std::vector<HalfEdge>& opposite, const RunContext& context)
    : atlas_(atlas), mesh_(mesh), opposite_(opposite) {
  const std::size_t faces = atlas.atlas->face_count();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto id = static_cast<std::int32_t>(f);
    turn_.push_back(atlas.reversed(id) ? -1 : 1);
    period_.push_back(atlas.atlas->chart(id).period());
    box_.push_back(atlas.atlas->chart(id).domain());
    for (int i = 0; i < 2; ++i) {
      if (!(period_.back()[i] > 0)) continue;
      box_.back().min[i] = -kInfinite;
      box_.back().max[i] = kInfinite;
    }
  }
  find_poles();
  find_bulges(context);
}

// Corners of one vertex that differ in (u,v) within a face are seams or poles; the partial
// derivatives tell which.
void UvTriangles::find_poles() {
  pole_.assign(mesh_.triangles.size(), 0);
  std::vector<HalfEdge> first(mesh_.positions.size(), kNoHalfEdge);
  std::vector<std::uint8_t> differs(mesh_.positions.size(), 0);
  const auto count = static_cast<HalfEdge>(3 * mesh_.triangles.size());
  const auto vertex = [&](HalfEdge h) {
    return mesh_.triangles[face_of(h)][static_cast<std::size_t>(h % 3)];
  };
  for (HalfEdge h = 0; h < count; ++h) {
    HalfEdge& f = first[vertex(h)];
    if (f == kNoHalfEdge || face(face_of(f)) != face(face_of(h))) {
      f = h;
    } else if (corner(f) != corner(h)) {
      differs[vertex(h)] = 1;
    }
  }
  for (HalfEdge h = 0; h < count; ++h) {
    if (!differs[vertex(h)]) continue;
    const SurfaceDerivatives d = atlas_.derivatives(face(face_of(h)), corner(h));
    const Vec2 a = corner(next_in_face(h)), b = corner(prev_in_face(h)), p = corner(h);
    const Vec2 extent = glm::max(glm::max(a, b), p) - glm::min(glm::min(a, b), p);
    const double u = glm::length(d.u) * extent.x, v = glm::length(d.v) * extent.y;
    const int direction = u < v ? 0 : 1;
    if (std::min(u, v) >= kCollapsed * std::max(u, v)) continue;
    // The sides to the pole have to be strips, not points.
    if (a[direction] == b[direction]) continue;
    pole_[face_of(h)] = static_cast<std::uint8_t>(1 + h % 3 + 4 * direction);
  }
}

UvTriangles::Side UvTriangles::side(HalfEdge h) const {
  Side s{corner(h), corner(next_in_face(h))};
  const std::uint8_t pole = pole_[face_of(h)];
  if (pole == 0) return s;
  const int at = (pole - 1) % 4, i = (pole - 1) / 4;
  if (h % 3 == at) s.a[i] = s.b[i];
  if (next_in_face(h) % 3 == at) s.b[i] = s.a[i];
  return s;
}

Vec2 UvTriangles::uv(std::uint32_t triangle, Vec3 bary) const {
  const auto h = static_cast<HalfEdge>(3 * triangle);
  const Vec2 flat = bary.x * corner(h) + bary.y * corner(h + 1) + bary.z * corner(h + 2);
  const std::uint8_t pole = pole_[triangle];
  if (pole == 0) return flat;
  const int p = (pole - 1) % 4, i = (pole - 1) / 4;
  const double la = bary[(p + 1) % 3], lb = bary[(p + 2) % 3], s = la + lb;
  Vec2 result = flat;
  const Vec2 a = corner(h + (p + 1) % 3), b = corner(h + (p + 2) % 3);
  if (s > 0) result[i] = (la * a[i] + lb * b[i]) / s;
  return result;
}

Vec3 UvTriangles::bary(std::uint32_t triangle, Vec2 uv) const {
  const auto h = static_cast<HalfEdge>(3 * triangle);
  const std::uint8_t pole = pole_[triangle];
  if (pole == 0) {
    const Vec2 o = corner(h), x = corner(h + 1) - o, y = corner(h + 2) - o, q = uv - o;
    const double area = cross2(x, y);
    if (area == 0) return Vec3(1.0 / 3);
    const double b = cross2(q, y) / area, c = cross2(x, q) / area;
    return {1 - b - c, b, c};
  }
  const int k = (pole - 1) % 4, i = (pole - 1) / 4, j = 1 - i;
  const Vec2 p = corner(h + k), a = corner(h + (k + 1) % 3), b = corner(h + (k + 2) % 3);
  const double x = (uv[i] - a[i]) / (b[i] - a[i]);
  const double base = (1 - x) * a[j] + x * b[j] - p[j];
  const double s = base != 0 ? (uv[j] - p[j]) / base : 0;
  Vec3 result;
  result[k] = 1 - s;
  result[(k + 1) % 3] = s * (1 - x);
  result[(k + 2) % 3] = s * x;
  return result;
}

UvTriangles::Strip UvTriangles::strip(std::uint32_t triangle) const {
  const int k = (pole_[triangle] - 1) % 4, i = (pole_[triangle] - 1) / 4, j = 1 - i;
  const auto h = static_cast<HalfEdge>(3 * triangle);
  const Vec2 p = corner(h + k), a = corner(h + (k + 1) % 3), b = corner(h + (k + 2) % 3);
  return {std::abs(b[i] - a[i]), a[j] - p[j], b[j] - p[j]};
}

double UvTriangles::draw_area(std::uint32_t triangle) const {
  if (pole_[triangle] != 0) {
    const Strip s = strip(triangle);
    return s.width * s.tallest();
  }
  const auto h = static_cast<HalfEdge>(3 * triangle);
  return 0.5 * std::abs(cross2(corner(h + 1) - corner(h), corner(h + 2) - corner(h)));
}

UvDraw UvTriangles::draw(std::uint32_t triangle, double a, double b) const {
  if (pole_[triangle] == 0) return {uniform_bary(a, b)};
  const Strip s = strip(triangle);
  const int k = (pole_[triangle] - 1) % 4;
  UvDraw at;
  at.bary[k] = 1 - b;
  at.bary[(k + 1) % 3] = b * (1 - a);
  at.bary[(k + 2) % 3] = b * a;
  const double tallest = s.tallest();
  at.keep = tallest > 0 ? std::abs((1 - a) * s.first + a * s.second) / tallest : 0;
  return at;
}

bool UvTriangles::meets_pole(std::uint32_t triangle, Vec2 from, Vec2 to, double& share) const {
  const std::uint8_t pole = pole_[triangle];
  if (pole == 0) return false;
  const int k = (pole - 1) % 4, j = 1 - (pole - 1) / 4;
  const auto h = static_cast<HalfEdge>(3 * triangle);
  const double p = corner(h + k)[j], inwards = corner(h + (k + 1) % 3)[j] - p;
  if ((to[j] - p) * inwards > 0) return false;
  const double step = from[j] - to[j];
  share = step != 0 ? std::clamp((from[j] - p) / step, 0.0, 1.0) : 0;
  return true;
}

// As in the walk over a mesh only sides that the segment points out of count, wherever it begins:
// rounding, and the gap between a chord and its curve, cannot send it back.
UvExit UvTriangles::exit(std::uint32_t triangle, Vec2 from, Vec2 to) const {
  const auto first = static_cast<HalfEdge>(3 * triangle);
  const double sign = turn(triangle);
  const Vec2 d = to - from;
  UvExit result;
  for (int k = 0; k < 3; ++k) {
    const Side s = side(first + k);
    const Vec2 e = s.b - s.a;
    const double outwards = sign * cross2(d, e);
    if (!(outwards > 0)) continue;
    const double share = sign * cross2(s.a - from, e) / outwards;
    if (share < result.share) result = {first + k, share};
  }
  return result;
}

Vec2 UvTriangles::branch_step(HalfEdge h) const {
  const Vec2 period = period_[static_cast<std::size_t>(face(face_of(h)))];
  Vec2 step(0);
  if (period == step) return step;
  // At the end that is no pole, where both sides have the same point.
  const HalfEdge o = opposite(h);
  const Side mine = side(h), other = side(o);
  const Vec2 gap = 0.5 * (other.a + other.b - mine.a - mine.b);
  for (int i = 0; i < 2; ++i) {
    if (period[i] > 0) step[i] = period[i] * std::round(gap[i] / period[i]);
  }
  return step;
}

double UvTriangles::to_side(std::uint32_t triangle, Vec2 uv, Vec2 velocity) const {
  const ParameterBox& box = box_[static_cast<std::size_t>(face(triangle))];
  double way = kInfinite;
  for (int i = 0; i < 2; ++i) {
    if (velocity[i] > 0) way = std::min(way, (box.max[i] - uv[i]) / velocity[i]);
    if (velocity[i] < 0) way = std::min(way, (box.min[i] - uv[i]) / velocity[i]);
  }
  return way;
}

bool UvTriangles::lies_on_flat(std::uint32_t triangle, Vec2 p) const {
  const auto h = static_cast<HalfEdge>(3 * triangle);
  const Vec2 o = corner(h), a = corner(h + 1) - o, b = corner(h + 2) - o;
  const Vec2 along = glm::length(a) > glm::length(b) ? a : b;
  const Vec2 low = glm::min(o, o + glm::min(a, b)), high = glm::max(o, o + glm::max(a, b));
  const double noise = kNoise * std::max(glm::length(low), glm::length(high));
  const double beside = std::max(std::abs(cross2(a, b)), std::abs(cross2(along, p - o)));
  return beside <= noise * glm::length(along) &&
         glm::distance(p, glm::clamp(p, low, high)) <= noise;
}

std::uint32_t UvTriangles::locate(std::uint32_t triangle, Vec2& target) const {
  const Vec3 b = bary(triangle, target);
  if (std::min({b.x, b.y, b.z}) >= 0 || lies_on_flat(triangle, target)) return triangle;
  Vec2 from = uv(triangle, Vec3(1.0 / 3));
  WalkGuard guard;
  while (guard.go_on(triangle, target)) {
    const UvExit e = exit(triangle, from, target);
    if (e.edge == kNoHalfEdge || is_border(e.edge) || opposite(e.edge) == kNoHalfEdge) break;
    const Vec2 step = branch_step(e.edge);
    from += step;
    target += step;
    triangle = face_of(opposite(e.edge));
  }
  return triangle;
}

HalfEdge UvTriangles::next_border(HalfEdge h, Vec2& step) const {
  HalfEdge e = next_in_face(h);
  WalkGuard guard;
  while (!is_border(e) && guard.go_on(static_cast<std::uint32_t>(e), Vec2(0))) {
    if (opposite(e) == kNoHalfEdge) return kNoHalfEdge;
    step += branch_step(e);
    e = next_in_face(opposite(e));
  }
  return is_border(e) ? e : kNoHalfEdge;
}

HalfEdge UvTriangles::previous_border(HalfEdge h, Vec2& step) const {
  HalfEdge e = prev_in_face(h);
  WalkGuard guard;
  while (!is_border(e) && guard.go_on(static_cast<std::uint32_t>(e), Vec2(0))) {
    if (opposite(e) == kNoHalfEdge) return kNoHalfEdge;
    step += branch_step(e);
    e = prev_in_face(opposite(e));
  }
  return is_border(e) ? e : kNoHalfEdge;
}

double UvTriangles::noise(HalfEdge h) const {
  // 1e-9 of the triangle: far above rounding, far below anything drawn.
  const Side s = side(h);
  return 1e-9 * std::abs(cross2(s.b - s.a, corner(prev_in_face(h)) - s.a)) / glm::length(s.b - s.a);
}

}  // namespace burin::detail
