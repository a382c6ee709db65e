#include <burin/base/box.h>
#include <burin/section/hatch_cuts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace burin {
namespace {

constexpr std::array kAngles = {45.0, 135.0, 30.0, 120.0, 60.0, 150.0};
/// Degrees within which an outline is taken for parallel to the hatching, and its share.
constexpr double kParallel = 15, kMostParallel = 0.5;
/// Paper mm: the distance of the lines, and what it is of the root of the area.
constexpr double kClosest = 0.7, kWidest = 3.5, kOfRoot = 0.12;
/// Lines over one area at the most; wider apart beyond.
constexpr double kMostLines = 5000;
/// Paper mm: areas so near are neighbours, as a bolt and the hole around it.
constexpr double kNeighbour = 1;
/// Of an area's size: pieces of one line so near are one.
constexpr double kJoined = 1e-9;
/// Pairs of segments that are looked at for two areas; beyond, boxes that overlap touch.
constexpr std::size_t kMostPairs = 4'000'000;

/// What one part shows in one plane.
struct Area {
  std::int32_t part = 0;
  Vec3 normal{0}, u{0}, v{0};  // u: horizontal
  double offset = 0;
  std::vector<std::uint32_t> faces = {};
  std::vector<std::array<Vec2, 3>> triangles = {};
  std::vector<std::array<Vec2, 2>> outline = {};
  Box2 box = {};
  double size = 0;  // model mm2
  double angle = 0;
  bool again = false;  // a neighbour has the angle
};

double distance_to(Vec2 p, const std::array<Vec2, 2>& segment) {
  const Vec2 e = segment[1] - segment[0];
  const double length = glm::dot(e, e);
  const double t = length > 0 ? std::clamp(glm::dot(p - segment[0], e) / length, 0.0, 1.0) : 0;
  return glm::distance(p, segment[0] + t * e);
}

Area new_area(std::int32_t part, const ProxyMesh& proxy, std::uint32_t face) {
  Area area{.part = part};
  area.normal = proxy.mesh.normal(face);
  area.u = normalize_or(glm::cross(Vec3(0, 0, 1), area.normal), Vec3(1, 0, 0));
  area.v = glm::cross(area.normal, area.u);
  area.offset = glm::dot(area.normal, proxy.mesh.positions[proxy.mesh.triangles[face][0]]);
  return area;
}

/// The areas of a part, in the order of their planes.
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
      if (!inside) area.outline.push_back({flat[k], flat[(k + 1) % 3]});
    }
    area.faces.push_back(f);
    area.triangles.push_back(flat);
    area.size += proxy.mesh.area(f);
  }
  std::vector<Area> out;
  for (auto& [plane, area] : found) out.push_back(std::move(area));
  return out;
}

/// `near`: model mm.
bool neighbours(const Area& a, const Area& b, double near) {
  constexpr double kSamePlane = 1e-9;
  if (glm::dot(a.normal, b.normal) < 1 - kSamePlane) return false;
  if (std::abs(a.offset - b.offset) > near) return false;
  Box2 wide = a.box;
  wide.min -= Vec2(near), wide.max += Vec2(near);
  if (!wide.overlaps(b.box)) return false;
  if (a.outline.size() * b.outline.size() > kMostPairs) return true;
  return std::ranges::any_of(a.outline, [&](const auto& s) {
    return std::ranges::any_of(b.outline, [&](const auto& t) {
      return distance_to(s[0], t) <= near || distance_to(t[0], s) <= near;
    });
  });
}

/// The share of the outline that runs within kParallel degrees of an angle.
double parallel_share(const Area& area, double angle) {
  double all = 0, parallel = 0;
  for (const auto& [a, b] : area.outline) {
    const Vec2 e = b - a;
    const double length = glm::length(e);
    const double degrees = std::atan2(e.y, e.x) * 180 / std::numbers::pi;
    const double off = std::abs(std::remainder(degrees - angle, 180.0));
    all += length;
    if (off < kParallel) parallel += length;
  }
  return all > 0 ? parallel / all : 0;
}

double scale_of(const Area& area, const Camera& camera) {
  const Vec2 middle = area.box.center();
  return camera.scale_at(middle.x * area.u + middle.y * area.v + area.offset * area.normal);
}

Vec3 direction(const Area& area, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return std::cos(angle) * area.u + std::sin(angle) * area.v;
}

/// Whether the lines of two planes of a part would lie on each other if these were folded together
/// about the line where they meet, each cut lying beyond the other's plane.
bool folds_onto(const Area& a, double degrees_a, const Area& b, double degrees_b) {
  const Vec3 fold = glm::cross(a.normal, b.normal);
  const auto slope = [&](const Area& area, const Area& other, double degrees) {
    const Vec3 line = direction(area, degrees);
    return glm::dot(line, fold) * glm::dot(line, reject(other.normal, area.normal));
  };
  return slope(a, b, degrees_a) * slope(b, a, degrees_b) > 0;
}

/// The angles in the order in which they are wanted: as in another plane of the part, then by rule.
std::vector<double> wanted_angles(const std::vector<Area>& areas, std::size_t i) {
  constexpr double kParallelPlanes = 1e-6;
  std::vector<double> wanted;
  for (std::size_t j = 0; j < i; ++j) {
    if (areas[j].part != areas[i].part) continue;
    if (std::abs(glm::dot(areas[j].normal, areas[i].normal)) > 1 - kParallelPlanes) {
      wanted = {areas[j].angle};
      break;
    }
    for (const double angle : {areas[j].angle, 180 - areas[j].angle}) {
      if (!wanted.empty() || !folds_onto(areas[j], areas[j].angle, areas[i], angle)) continue;
      wanted = {angle};
    }
  }
  wanted.insert(wanted.end(), kAngles.begin(), kAngles.end());
  return wanted;
}

void choose_angles(std::vector<Area>& areas, const Camera& camera) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double near = kNeighbour / scale_of(areas[i], camera);
    const auto taken = [&](double angle) {
      for (std::size_t j = 0; j < i; ++j) {
        if (areas[j].angle == angle && neighbours(areas[i], areas[j], near)) return true;
      }
      return false;
    };
    const auto bad = [&](double angle) { return parallel_share(areas[i], angle) > kMostParallel; };
    const std::vector<double> angles = wanted_angles(areas, i);
    const auto best =
        std::ranges::find_if(angles, [&](double angle) { return !taken(angle) && !bad(angle); });
    const auto any = best != angles.end()
                         ? best
                         : std::ranges::find_if(angles, [&](double a) { return !taken(a); });
    areas[i].again = any == angles.end();
    areas[i].angle = areas[i].again ? kAngles[0] : *any;
  }
}

/// Nothing is seen of such an area but its outline, which the lines would blacken.
bool edge_on(const Area& area, const Camera& camera) {
  constexpr double kSine = 1e-3;
  const Vec2 middle = area.box.center();
  const Vec3 p = middle.x * area.u + middle.y * area.v + area.offset * area.normal;
  return std::abs(glm::dot(area.normal, camera.to_viewer(p))) < kSine;
}

/// A part has one distance of lines in all its planes: that of its largest area.
void share_sizes(std::vector<Area>& areas) {
  std::map<std::int32_t, double> largest;
  for (const Area& area : areas) {
    largest[area.part] = std::max(largest[area.part], area.size);
  }
  for (Area& area : areas) area.size = largest[area.part];
}

struct Run {
  double from, to;
  std::uint32_t face;
};

/// Where line `at` (its coordinate across) runs over a triangle, along it; nothing: empty.
Run over_triangle(const std::array<Vec2, 3>& triangle, Vec2 along, Vec2 across, double at,
                  std::uint32_t face) {
  Run run{1, 0, face};
  bool any = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 &p = triangle[k], &q = triangle[(k + 1) % 3];
    const double a = glm::dot(across, p) - at, b = glm::dot(across, q) - at;
    if ((a > 0) == (b > 0)) continue;
    const double t = glm::dot(along, glm::mix(p, q, a / (a - b)));
    run.from = any ? std::min(run.from, t) : t;
    run.to = any ? std::max(run.to, t) : t;
    any = true;
  }
  return run;
}

void hatch(const Area& area, const Camera& camera, std::vector<Curve3>& out) {
  const double scale = scale_of(area, camera);
  const double on_paper = std::clamp(kOfRoot * std::sqrt(area.size) * scale, kClosest, kWidest);
  const double angle = area.angle * std::numbers::pi / 180;
  const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
  const double spacing =
      std::max((area.again ? 1.5 : 1) * on_paper / scale, area.box.diagonal() / kMostLines);
  std::map<std::int64_t, std::vector<Run>> lines;
  for (std::size_t i = 0; i < area.triangles.size(); ++i) {
    double low = glm::dot(across, area.triangles[i][0]), high = low;
    for (const Vec2& p : area.triangles[i]) {
      low = std::min(low, glm::dot(across, p)), high = std::max(high, glm::dot(across, p));
    }
    for (auto k = static_cast<std::int64_t>(std::ceil(low / spacing));
         static_cast<double>(k) * spacing <= high; ++k) {
      const Run run = over_triangle(area.triangles[i], along, across,
                                    static_cast<double>(k) * spacing, area.faces[i]);
      if (run.to > run.from) lines[k].push_back(run);
    }
  }
  const double joined = kJoined * area.box.diagonal();
  const auto point = [&](std::int64_t k, double t) {
    const Vec2 p = t * along + static_cast<double>(k) * spacing * across;
    return p.x * area.u + p.y * area.v + area.offset * area.normal;
  };
  for (auto& [k, runs] : lines) {
    std::ranges::sort(runs, {}, &Run::from);
    for (std::size_t i = 0; i < runs.size();) {
      std::size_t j = i + 1;
      double to = runs[i].to;
      while (j < runs.size() && runs[j].from <= to + joined) to = std::max(to, runs[j++].to);
      Curve3 curve;
      curve.kind = LineClass::Pattern;
      curve.source.part = area.part;
      curve.points = {point(k, runs[i].from), point(k, to)};
      curve.normals = {area.normal, area.normal};
      curve.faces = {static_cast<std::int32_t>(runs[i].face)};
      out.push_back(std::move(curve));
      i = j;
    }
  }
}

}  // namespace

std::vector<Curve3> hatch_cuts(std::span<const ProxyMesh* const> proxies, const Camera& camera,
                               const RunContext& context) {
  std::vector<Area> areas;
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    if (proxies[i]->cut_plane.empty()) continue;
    for (Area& area : areas_of(*proxies[i], static_cast<std::int32_t>(i))) {
      areas.push_back(std::move(area));
    }
  }
  choose_angles(areas, camera);
  share_sizes(areas);
  std::vector<Curve3> out;
  for (const Area& area : areas) {
    context.check();
    if (!edge_on(area, camera)) hatch(area, camera, out);
  }
  return out;
}

}  // namespace burin
