#include "cut_area.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace burin::detail {
namespace {

/// Pairs of segments that are looked at for two areas; beyond, boxes that overlap touch.
constexpr std::size_t kMostPairs = 4'000'000;

double distance_to(Vec2 p, const std::array<Vec2, 2>& segment) {
  const Vec2 e = segment[1] - segment[0];
  const double length = glm::dot(e, e);
  const double t = length > 0 ? std::clamp(glm::dot(p - segment[0], e) / length, 0.0, 1.0) : 0;
  return glm::distance(p, segment[0] + t * e);
}

double turn(Vec2 a, Vec2 b, Vec2 c) { return cross2(b - a, c - a); }

bool cross(const std::array<Vec2, 2>& s, const std::array<Vec2, 2>& t) {
  return turn(s[0], s[1], t[0]) * turn(s[0], s[1], t[1]) < 0 &&
         turn(t[0], t[1], s[0]) * turn(t[0], t[1], s[1]) < 0;
}

bool holds(const Area& area, Vec2 p) {
  return std::ranges::any_of(area.triangles, [&](const auto& t) {
    const double a = turn(t[0], t[1], p), b = turn(t[1], t[2], p), c = turn(t[2], t[0], p);
    return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
  });
}

/// Whether the outline of one begins within the other: with no outlines that cross, one piece lies
/// in the other.
bool begins_in(const Area& inner, const Area& outer) {
  std::set<std::int32_t> seen;
  for (std::size_t i = 0; i < inner.outline.size(); ++i) {
    if (!seen.insert(inner.outline_regions[i]).second) continue;
    if (holds(outer, inner.outline[i][0])) return true;
  }
  return false;
}

Area new_area(std::int32_t part, const ProxyMesh& proxy, std::uint32_t face) {
  Area area{.part = part};
  area.normal = proxy.mesh.normal(face);
  area.u = normalize_or(glm::cross(Vec3(0, 0, 1), area.normal), Vec3(1, 0, 0));
  area.v = glm::cross(area.normal, area.u);
  area.offset = glm::dot(area.normal, proxy.mesh.positions[proxy.mesh.triangles[face][0]]);
  return area;
}

}  // namespace

std::vector<Area> areas_of(const ProxyMesh& proxy, std::int32_t part) {
  std::map<std::int32_t, Area> found;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    if (!proxy.is_cut(f) || !(proxy.mesh.area(f) > 0)) continue;
    const std::int32_t plane = proxy.cut_plane[static_cast<std::size_t>(proxy.face_region[f])];
    auto it = found.find(plane);
    if (it == found.end()) it = found.emplace(plane, new_area(part, proxy, f)).first;
    Area& area = it->second;
    std::array<Vec2, 3> flat{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = proxy.mesh.positions[proxy.mesh.triangles[f][k]];
      flat[k] = {glm::dot(area.u, p), glm::dot(area.v, p)};
      area.box.add(flat[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge o = proxy.topology.opposite[3 * std::size_t{f} + k];
      const bool inside = o != kNoHalfEdge && proxy.is_cut(face_of(o));
      if (inside) continue;
      area.outline.push_back({flat[k], flat[(k + 1) % 3]});
      area.outline_regions.push_back(proxy.face_region[f]);
    }
    area.faces.push_back(f);
    area.triangles.push_back(flat);
    area.regions.push_back(proxy.face_region[f]);
    area.size += proxy.mesh.area(f);
  }
  std::vector<Area> out;
  for (auto& [plane, area] : found) out.push_back(std::move(area));
  return out;
}

bool in_one_plane(const Area& a, const Area& b, double near) {
  constexpr double kSamePlane = 1e-9;
  return glm::dot(a.normal, b.normal) >= 1 - kSamePlane && std::abs(a.offset - b.offset) <= near;
}

bool neighbours(const Area& a, const Area& b, double near) {
  if (!in_one_plane(a, b, near)) return false;
  Box2 wide = a.box;
  wide.min -= Vec2(near), wide.max += Vec2(near);
  if (!wide.overlaps(b.box)) return false;
  if (a.outline.size() * b.outline.size() > kMostPairs) return true;
  const bool meet = std::ranges::any_of(a.outline, [&](const auto& s) {
    return std::ranges::any_of(b.outline, [&](const auto& t) {
      return distance_to(s[0], t) <= near || distance_to(t[0], s) <= near || cross(s, t);
    });
  });
  return meet || begins_in(a, b) || begins_in(b, a);
}

double scale_of(const Area& area, const Camera& camera) {
  const Vec2 middle = area.box.center();
  return camera.scale_at(middle.x * area.u + middle.y * area.v + area.offset * area.normal);
}

bool edge_on(const Area& area, const Camera& camera) {
  constexpr double kSine = 1e-3;
  const Vec2 middle = area.box.center();
  const Vec3 p = middle.x * area.u + middle.y * area.v + area.offset * area.normal;
  return std::abs(glm::dot(area.normal, camera.to_viewer(p))) < kSine;
}

namespace {

/// A piece of an area by itself.
Area piece_of(const Area& area, std::int32_t region) {
  Area piece{.part = area.part, .normal = area.normal, .u = area.u, .v = area.v};
  piece.offset = area.offset;
  piece.angle = area.angle;
  for (std::size_t i = 0; i < area.triangles.size(); ++i) {
    if (area.regions[i] != region) continue;
    const auto& t = area.triangles[i];
    piece.faces.push_back(area.faces[i]);
    piece.triangles.push_back(t);
    piece.regions.push_back(region);
    for (const Vec2& p : t) piece.box.add(p);
    const Vec2 a = t[1] - t[0], b = t[2] - t[0];
    piece.size += 0.5 * std::abs(a.x * b.y - a.y * b.x);
  }
  for (std::size_t i = 0; i < area.outline.size(); ++i) {
    if (area.outline_regions[i] != region) continue;
    piece.outline.push_back(area.outline[i]);
    piece.outline_regions.push_back(region);
  }
  return piece;
}

/// Whether a circle as wide fits nowhere in. Its middle would lie on an edge between two triangles,
/// near the middle of it, or in one of them.
bool is_narrow(const Area& piece, double width) {
  double around = 0;
  for (const auto& [a, b] : piece.outline) around += glm::distance(a, b);
  // Of an area with such a circle twice its size over its outline may be less, never more.
  if (2 * piece.size >= width * around) return false;
  if (4 * piece.triangles.size() * piece.outline.size() > kMostPairs) return false;
  const auto fits = [&](Vec2 p) {
    return std::ranges::all_of(
        piece.outline, [&](const auto& segment) { return 2 * distance_to(p, segment) >= width; });
  };
  return std::ranges::none_of(piece.triangles, [&](const auto& t) {
    return fits(0.5 * (t[0] + t[1])) || fits(0.5 * (t[1] + t[2])) || fits(0.5 * (t[2] + t[0])) ||
           fits((t[0] + t[1] + t[2]) / 3.0);
  });
}

/// Without these pieces.
void drop(Area& area, const std::set<std::int32_t>& regions) {
  Area left = area;
  left.faces.clear(), left.triangles.clear(), left.regions.clear();
  left.outline.clear(), left.outline_regions.clear();
  for (std::size_t i = 0; i < area.triangles.size(); ++i) {
    if (regions.contains(area.regions[i])) continue;
    left.faces.push_back(area.faces[i]);
    left.triangles.push_back(area.triangles[i]);
    left.regions.push_back(area.regions[i]);
  }
  for (std::size_t i = 0; i < area.outline.size(); ++i) {
    if (regions.contains(area.outline_regions[i])) continue;
    left.outline.push_back(area.outline[i]);
    left.outline_regions.push_back(area.outline_regions[i]);
  }
  area = std::move(left);
}

}  // namespace

std::vector<Area> take_narrow(Area& area, double width) {
  const std::set<std::int32_t> regions(area.regions.begin(), area.regions.end());
  std::vector<Area> narrow;
  std::set<std::int32_t> taken;
  for (const std::int32_t region : regions) {
    Area piece = piece_of(area, region);
    if (!is_narrow(piece, width)) continue;
    narrow.push_back(std::move(piece));
    taken.insert(region);
  }
  if (!taken.empty()) drop(area, taken);
  return narrow;
}

}  // namespace burin::detail
