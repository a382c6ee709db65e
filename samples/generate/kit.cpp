#include "kit.h"

#include <burin/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace burin::samples {

namespace {

constexpr double kPi = std::numbers::pi;

Vec2 unit(Vec2 v) { return v / glm::length(v); }

// The tangent arc that replaces corner `b` between its neighbours.
void append_corner(Outline& out, Vec2 a, const Corner& b, Vec2 c, double tolerance) {
  if (b.radius <= 0) {
    out.push_back(b.at);
    return;
  }
  const Vec2 u = unit(a - b.at), v = unit(c - b.at);
  const double half = 0.5 * std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
  const double reach = b.radius / std::tan(half);
  const Vec2 center = b.at + unit(u + v) * (b.radius / std::sin(half));
  const Vec2 p = b.at + u * reach - center, q = b.at + v * reach - center;
  const double from = std::atan2(p.y, p.x);
  const double turn = std::atan2(cross2(p, q), glm::dot(p, q));
  for (const Vec2 point : arc(center, b.radius, from, from + turn, tolerance)) out.push_back(point);
}

}  // namespace

int circle_segments(double radius, double tolerance) {
  const double ratio = std::max(0.0, 1 - tolerance / radius);
  // A multiple of four, so that the quadrants fall on points.
  return std::max(16, 4 * static_cast<int>(std::ceil(kPi / std::acos(ratio) / 4)));
}

Outline arc(Vec2 center, double radius, double from, double to, double tolerance) {
  const double share = std::abs(to - from) / (2 * kPi);
  const int n =
      std::max(2, static_cast<int>(std::ceil(share * circle_segments(radius, tolerance))));
  Outline out;
  for (int i = 0; i <= n; ++i) {
    const double t = from + (to - from) * i / n;
    out.push_back(center + radius * Vec2(std::cos(t), std::sin(t)));
  }
  return out;
}

Outline circle(Vec2 center, double radius, int segments) {
  Outline out;
  for (int i = 0; i < segments; ++i) {
    const double t = 2 * kPi * i / segments;
    out.push_back(center + radius * Vec2(std::cos(t), std::sin(t)));
  }
  return out;
}

Outline rounded(const std::vector<Corner>& corners, bool closed, double tolerance) {
  Outline out;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!closed && (i == 0 || i + 1 == n)) {
      out.push_back(corners[i].at);
    } else {
      append_corner(out, corners[(i + n - 1) % n].at, corners[i], corners[(i + 1) % n].at,
                    tolerance);
    }
  }
  // Arcs that meet without a straight piece between them share their end.
  const auto meet = [](Vec2 a, Vec2 b) { return glm::distance(a, b) < 1e-4; };
  out.erase(std::unique(out.begin(), out.end(), meet), out.end());
  if (closed && meet(out.front(), out.back())) out.pop_back();
  return out;
}

Loop place(const Outline& outline, Vec3 origin, Vec3 u, Vec3 v) {
  Loop loop;
  for (const Vec2 p : outline) loop.push_back(origin + p.x * u + p.y * v);
  return loop;
}

void Builder::triangle(Vec3 a, Vec3 b, Vec3 c) { corners_.insert(corners_.end(), {a, b, c}); }

void Builder::strip(const Loop& a, const Loop& b, bool closed) {
  if (a.size() == 1 || b.size() == 1) {
    const Loop& rim = a.size() == 1 ? b : a;
    const Vec3 tip = a.size() == 1 ? a[0] : b[0];
    for (std::size_t i = 0; i + (closed ? 0 : 1) < rim.size(); ++i) {
      triangle(tip, rim[i], rim[(i + 1) % rim.size()]);
    }
    return;
  }
  if (a.size() != b.size()) throw GeometryError("strip between loops of different sizes");
  for (std::size_t i = 0; i + (closed ? 0 : 1) < a.size(); ++i) {
    const std::size_t j = (i + 1) % a.size();
    if (glm::distance(a[i], b[j]) < glm::distance(a[j], b[i])) {
      triangle(a[i], a[j], b[j]);
      triangle(a[i], b[j], b[i]);
    } else {
      triangle(a[i], a[j], b[i]);
      triangle(a[j], b[j], b[i]);
    }
  }
}

void Builder::loft(const std::vector<Loop>& loops, bool closed) {
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) strip(loops[i], loops[i + 1], closed);
}

std::vector<Loop> Builder::revolve(const Outline& profile, Vec3 origin, Vec3 axis, int segments) {
  const Vec3 u = any_orthogonal(axis), v = glm::cross(axis, u);
  std::vector<Loop> loops;
  for (const Vec2 p : profile) {
    const Vec3 center = origin + p.y * axis;
    loops.push_back(p.x == 0 ? Loop{center} : place(circle({0, 0}, p.x, segments), center, u, v));
  }
  loft(loops);
  return loops;
}

void Builder::add(const TriMesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    triangle(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
  }
}

namespace {

// Equal points become one: 1e-7 mm is far below any feature and above the rounding of a loop
// computed twice.
TriMesh weld(const std::vector<Vec3>& corners) {
  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  const auto cell = [](double x) { return std::llround(x * 1e6); };
  std::map<Key, std::uint32_t> seen;
  TriMesh mesh;
  std::vector<std::uint32_t> ids;
  for (const Vec3& p : corners) {
    const auto [it, fresh] = seen.try_emplace({cell(p.x), cell(p.y), cell(p.z)},
                                              static_cast<std::uint32_t>(mesh.positions.size()));
    if (fresh) mesh.positions.push_back(p);
    ids.push_back(it->second);
  }
  for (std::size_t i = 0; i < ids.size(); i += 3) {
    const Triangle t{ids[i], ids[i + 1], ids[i + 2]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  return mesh;
}

using EdgeMap = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>;

EdgeMap edges_of(const TriMesh& mesh, bool open) {
  EdgeMap edges;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      edges[std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3])].push_back(t);
    }
  }
  for (const auto& [edge, faces] : edges) {
    if (faces.size() > 2 || (!open && faces.size() != 2)) {
      const Vec3 p = mesh.positions[edge.first];
      throw GeometryError("an edge with " + std::to_string(faces.size()) + " triangles at " +
                          std::to_string(p.x) + " " + std::to_string(p.y) + " " +
                          std::to_string(p.z));
    }
  }
  return edges;
}

bool has_edge(const Triangle& t, std::uint32_t a, std::uint32_t b) {
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

double volume6(const TriMesh& mesh, const std::vector<std::uint32_t>& component) {
  double sum = 0;
  for (const std::uint32_t t : component) {
    const Triangle& f = mesh.triangles[t];
    sum += glm::dot(mesh.positions[f[0]], glm::cross(mesh.positions[f[1]], mesh.positions[f[2]]));
  }
  return sum;
}

}  // namespace

TriMesh Builder::finish(bool open) const {
  TriMesh mesh = weld(corners_);
  const EdgeMap edges = edges_of(mesh, open);
  std::vector<char> done(mesh.triangles.size(), 0);
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (done[seed]) continue;
    std::vector<std::uint32_t> component{seed};
    done[seed] = 1;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Triangle f = mesh.triangles[component[i]];
      for (int k = 0; k < 3; ++k) {
        for (const std::uint32_t other : edges.at(std::minmax(f[k], f[(k + 1) % 3]))) {
          if (done[other]) continue;
          if (has_edge(mesh.triangles[other], f[k], f[(k + 1) % 3])) {
            std::swap(mesh.triangles[other][1], mesh.triangles[other][2]);
          }
          done[other] = 1;
          component.push_back(other);
        }
      }
    }
    if (volume6(mesh, component) < 0) {
      for (const std::uint32_t t : component) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
  }
  return mesh;
}

namespace {

// The outline moved inwards by `d` along the mean normal of both sides: right for outlines whose
// arcs are wider than `d`.
Outline inset(const Outline& outline, double d) {
  Outline out;
  const std::size_t n = outline.size();
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) area += cross2(outline[i], outline[(i + 1) % n]);
  const double side = area > 0 ? 1 : -1;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = unit(outline[i] - outline[(i + n - 1) % n]),
               b = unit(outline[(i + 1) % n] - outline[i]);
    const Vec2 na = Vec2(-a.y, a.x) * side, nb = Vec2(-b.y, b.x) * side;
    const Vec2 bisector = unit(na + nb);
    out.push_back(outline[i] + bisector * (d / glm::dot(bisector, na)));
  }
  return out;
}

}  // namespace

TriMesh plate(const Outline& outline, const std::vector<Outline>& holes, double height,
              PlateEdge edge) {
  const Vec3 x(1, 0, 0), y(0, 1, 0);
  std::vector<Vec2> steps;  // (inset, height)
  if (edge.size <= 0) {
    steps = {{0, 0}, {0, height}};
  } else if (!edge.round) {
    steps = {{edge.size, 0}, {0, edge.size}, {0, height - edge.size}, {edge.size, height}};
  } else {
    for (const Vec2 p : arc({0, edge.size}, edge.size, -kPi / 2, 0))
      steps.emplace_back(edge.size - p.x, p.y);
    for (const Vec2 p : arc({0, height - edge.size}, edge.size, 0, kPi / 2)) {
      steps.emplace_back(edge.size - p.x, p.y);
    }
  }
  Builder builder;
  std::vector<Loop> sides;
  for (const Vec2 s : steps) sides.push_back(place(inset(outline, s.x), {0, 0, s.y}, x, y));
  builder.loft(sides);
  std::vector<Loop> bottom, top;
  for (const Outline& hole : holes) {
    bottom.push_back(place(hole, {0, 0, 0}, x, y));
    top.push_back(place(hole, {0, 0, height}, x, y));
    builder.strip(bottom.back(), top.back());
  }
  builder.plane(sides.front(), bottom);
  builder.plane(sides.back(), top);
  return builder.finish();
}

TriMesh tube(const std::function<Vec3(double)>& curve, const std::function<double(double)>& radius,
             int along, int around, bool closed) {
  // Rotation-minimising frames; on a closed curve the twist that is left is spread over its length.
  const int rings = closed ? along : along + 1;
  const auto tangent = [&](double t) {
    const double h = 1e-5;
    return glm::normalize(curve(t + h) - curve(t - h));
  };
  std::vector<Vec3> normals{any_orthogonal(tangent(0))};
  for (int i = 1; i <= along; ++i) {
    const double a = static_cast<double>(i - 1) / along, b = static_cast<double>(i) / along;
    normals.push_back(transport(normals.back(), tangent(a), tangent(b)));
  }
  const Vec3 t0 = tangent(0), last = normals.back();
  const double twist =
      closed ? std::atan2(glm::dot(glm::cross(last, normals[0]), t0), glm::dot(last, normals[0]))
             : 0;
  std::vector<Loop> loops;
  for (int i = 0; i < rings; ++i) {
    const double t = static_cast<double>(i) / along, angle = twist * t;
    const Vec3 axis = tangent(t), n = normals[static_cast<std::size_t>(i)], m = glm::cross(axis, n);
    const Vec3 u = std::cos(angle) * n + std::sin(angle) * m, v = glm::cross(axis, u);
    loops.push_back(place(circle({0, 0}, radius(t), around), curve(t), u, v));
  }
  Builder builder;
  builder.loft(loops);
  if (closed) {
    builder.strip(loops.back(), loops.front());
  } else {
    builder.plane(loops.front());
    builder.plane(loops.back());
  }
  return builder.finish();
}

TriMesh transformed(TriMesh mesh, const std::function<Vec3(Vec3)>& f) {
  for (Vec3& p : mesh.positions) p = f(p);
  return mesh;
}

TriMesh moved(TriMesh mesh, Vec3 by) {
  return transformed(std::move(mesh), [&](Vec3 p) { return p + by; });
}

TriMesh turned(TriMesh mesh, Vec3 axis) {
  return transformed(std::move(mesh), [&](Vec3 p) { return transport(p, Vec3(0, 0, 1), axis); });
}

}  // namespace burin::samples
