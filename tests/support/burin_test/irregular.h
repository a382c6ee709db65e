#pragma once
/// Irregular triangulations of smooth surfaces: vertices exactly on the surface, valences from 4 to
/// 9, as meshers and scanners make them. Averaged normals look exact on regular grids and are not
/// on these.

#include <burin/base/rng.h>
#include <burin/mesh/topology.h>

#include <burin_test/exact.h>
#include <burin_test/shapes.h>

#include <array>
#include <map>
#include <utility>

namespace burin::test {

using Projection = std::function<Vec3(Vec3)>;

/// Moves vertices and flips edges of a closed manifold mesh.
class Scrambler {
 public:
  explicit Scrambler(TriMesh mesh) : mesh_(std::move(mesh)) {
    const RunContext context;
    opposite_ = build_topology(mesh_, context).opposite;
  }

  /// Moves each vertex by up to `amount` of its mean edge (random) and `centering` of the way to
  /// the mean of its neighbours, onto the surface, unless that turned a triangle over.
  void move(const Projection& project, double amount, double centering, const Rng& rng) {
    find_corners();
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const Vec3 p = mesh_.positions[v];
      Vec3 mean(0);
      double edge = 0, count = 0;
      around(corner_[v], [&](HalfEdge h) {
        const Vec3 q = mesh_.positions[origin(mesh_, next_in_face(h))];
        mean += q;
        edge += glm::length(q - p);
        ++count;
      });
      const Vec3 random(rng.uniform(3 * v) - 0.5, rng.uniform(3 * v + 1) - 0.5,
                        rng.uniform(3 * v + 2) - 0.5);
      const Vec3 shift = 2 * amount * edge / count * random + centering * (mean / count - p);
      move_vertex(v, project(p + shift));
    }
  }

  /// Flips edges until every edge is locally Delaunay.
  void flip_to_delaunay() {
    for (int pass = 0; pass < 50; ++pass) {
      std::size_t flips = 0;
      for (std::size_t h = 0; h < opposite_.size(); ++h)
        flips += try_flip(static_cast<HalfEdge>(h));
      if (flips == 0) return;
    }
  }

  TriMesh take() { return std::move(mesh_); }

 private:
  HalfEdge opposite(HalfEdge h) const { return opposite_[static_cast<std::size_t>(h)]; }
  void join(HalfEdge a, HalfEdge b) {
    opposite_[static_cast<std::size_t>(a)] = b;
    opposite_[static_cast<std::size_t>(b)] = a;
  }
  Vec3 at(HalfEdge h) const { return mesh_.positions[origin(mesh_, h)]; }

  void find_corners() {
    corner_.assign(mesh_.positions.size(), kNoHalfEdge);
    for (std::size_t h = 0; h < opposite_.size(); ++h) {
      corner_[origin(mesh_, static_cast<HalfEdge>(h))] = static_cast<HalfEdge>(h);
    }
  }

  template <class Visit>
  void around(HalfEdge start, const Visit& visit) const {
    HalfEdge h = start;
    do {
      visit(h);
      h = opposite(prev_in_face(h));
    } while (h != start);
  }

  void move_vertex(std::size_t v, Vec3 to) {
    const Vec3 from = mesh_.positions[v];
    bool ok = true;
    around(corner_[v], [&](HalfEdge h) {
      const Vec3 a = at(next_in_face(h)), b = at(prev_in_face(h));
      const Vec3 before = glm::cross(a - from, b - from), after = glm::cross(a - to, b - to);
      // Not turned over, and no needle either: height over the far edge at least a fifth of it.
      ok = ok && glm::dot(before, after) > 0 && glm::length(after) > 0.2 * glm::dot(a - b, a - b);
    });
    if (ok) mesh_.positions[v] = to;
  }

  double corner_angle(HalfEdge h) const {
    const Vec3 a = at(next_in_face(h)) - at(h), b = at(prev_in_face(h)) - at(h);
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }

  bool try_flip(HalfEdge h) {
    const HalfEdge o = opposite(h);
    if (o < h) return false;
    const HalfEdge h1 = next_in_face(h), h2 = prev_in_face(h), o1 = next_in_face(o),
                   o2 = prev_in_face(o);
    if (corner_angle(h2) + corner_angle(o2) <= kPi + 1e-9) return false;  // radians
    const Vec3 a = at(h), b = at(h1), c = at(h2), d = at(o2);
    const Vec3 f = glm::cross(d - a, c - a), g = glm::cross(b - d, c - d);
    const Vec3 up = glm::cross(b - a, c - a) + glm::cross(d - a, b - a);
    if (glm::dot(f, up) <= 0 || glm::dot(g, up) <= 0) return false;
    const std::uint32_t vc = origin(mesh_, h2), vd = origin(mesh_, o2);
    bool joined_already = false;
    around(h2, [&](HalfEdge k) { joined_already |= origin(mesh_, next_in_face(k)) == vd; });
    if (joined_already) return false;
    const std::uint32_t va = origin(mesh_, h), vb = origin(mesh_, h1);
    const HalfEdge bc = opposite(h1), ca = opposite(h2), ad = opposite(o1), db = opposite(o2);
    const HalfEdge hf = static_cast<HalfEdge>(3 * face_of(h)),
                   gf = static_cast<HalfEdge>(3 * face_of(o));
    mesh_.triangles[face_of(h)] = {va, vd, vc};
    mesh_.triangles[face_of(o)] = {vd, vb, vc};
    join(hf, ad);
    join(hf + 1, gf + 2);
    join(hf + 2, ca);
    join(gf, db);
    join(gf + 1, bc);
    return true;
  }

  TriMesh mesh_;
  std::vector<HalfEdge> opposite_;
  std::vector<HalfEdge> corner_;
};

/// A closed mesh near a surface, scrambled and relaxed on it. Deterministic in the seed.
inline TriMesh irregular(TriMesh mesh, const Projection& project, std::uint64_t seed = 1) {
  Scrambler s(mapped(std::move(mesh), project));
  for (std::uint64_t round = 0; round < 8; ++round) {
    s.move(project, 0.35, 0, Rng(seed, round));
    s.flip_to_delaunay();
  }
  for (std::uint64_t round = 0; round < 3; ++round) {
    s.move(project, 0, 0.5, Rng(seed));
    s.flip_to_delaunay();
  }
  return s.take();
}

/// Sphere of 20 n^2 triangles: an icosahedron, each face divided into n^2.
inline TriMesh icosphere(double radius, std::uint32_t n) {
  const double t = std::numbers::phi;
  const std::array<Vec3, 12> corner = {{{-1, t, 0},
                                        {1, t, 0},
                                        {-1, -t, 0},
                                        {1, -t, 0},
                                        {0, -1, t},
                                        {0, 1, t},
                                        {0, -1, -t},
                                        {0, 1, -t},
                                        {t, 0, -1},
                                        {t, 0, 1},
                                        {-t, 0, -1},
                                        {-t, 0, 1}}};
  const std::array<Triangle, 20> faces = {
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  TriMesh m;
  // A point is named by its three largest parts, corner and weight: equal on shared edges.
  std::map<std::array<std::pair<std::uint32_t, std::uint32_t>, 3>, std::uint32_t> names;
  const auto point = [&](const Triangle& f, std::uint32_t i, std::uint32_t j) {
    std::array<std::pair<std::uint32_t, std::uint32_t>, 3> name = {
        {{f[0], n - i - j}, {f[1], i}, {f[2], j}}};
    for (auto& part : name) {
      if (part.second == 0) part.first = 99;
    }
    std::sort(name.begin(), name.end());
    const auto [it, fresh] =
        names.try_emplace(name, static_cast<std::uint32_t>(m.positions.size()));
    if (fresh) {
      const Vec3 p =
          corner[f[0]] * double(n - i - j) + corner[f[1]] * double(i) + corner[f[2]] * double(j);
      m.positions.push_back(radius * glm::normalize(p));
    }
    return it->second;
  };
  for (const Triangle& f : faces) {
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; i + j < n; ++j) {
        m.triangles.push_back({point(f, i, j), point(f, i + 1, j), point(f, i, j + 1)});
        if (i + j + 1 < n) {
          m.triangles.push_back({point(f, i + 1, j), point(f, i + 1, j + 1), point(f, i, j + 1)});
        }
      }
    }
  }
  return m;
}

/// An irregular torus of about `triangles` triangles.
inline TriMesh irregular_torus(double major, double minor, double triangles,
                               std::uint64_t seed = 1) {
  const double across = std::sqrt(triangles / 2 * minor / major);
  const auto nv = static_cast<std::uint32_t>(std::lround(across));
  const auto nu = static_cast<std::uint32_t>(std::lround(triangles / 2 / nv));
  return irregular(torus(major, minor, nu, nv), onto_torus(major, minor), seed);
}

/// An irregular ellipsoid of about `triangles` triangles.
inline TriMesh irregular_ellipsoid(Vec3 half, double triangles, std::uint64_t seed = 1) {
  const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 20)));
  TriMesh m = mapped(icosphere(1, n), [&](Vec3 p) { return half * p; });
  return irregular(std::move(m), onto_ellipsoid(half), seed);
}

/// The mesh with each coordinate moved by a Gaussian of `share` of the mean edge length.
inline TriMesh noisy(TriMesh mesh, double share, std::uint64_t seed = 7) {
  double edge = 0;
  for (const Triangle& t : mesh.triangles) {
    edge += glm::length(mesh.positions[t[0]] - mesh.positions[t[1]]);
  }
  const double sigma = share * edge / static_cast<double>(mesh.triangles.size());
  const Rng rng(seed);
  std::uint64_t n = 0;
  const auto gauss = [&] {
    const double a = 1 - rng.uniform(n), b = rng.uniform(n + 1);
    n += 2;
    return sigma * std::sqrt(-2 * std::log(a)) * std::cos(2 * kPi * b);
  };
  for (Vec3& p : mesh.positions) {
    const double x = gauss(), y = gauss(), z = gauss();
    p += Vec3(x, y, z);
  }
  return mesh;
}

}  // namespace burin::test
