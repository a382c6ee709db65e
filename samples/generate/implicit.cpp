#include "implicit.h"

#include <burin/base/parallel.h>

#include <array>
#include <unordered_map>

namespace burin::samples {

namespace {

struct Grid {
  Vec3 low;
  double cell;
  std::array<std::size_t, 3> n;
  std::vector<double> values;

  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * n[1] + y) * n[0] + x;
  }
  Vec3 at(std::size_t x, std::size_t y, std::size_t z) const {
    return low +
           cell * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }
};

Grid sample(const Field& field, Vec3 low, Vec3 high, double cell) {
  Grid g{low, cell, {}, {}};
  for (int k = 0; k < 3; ++k)
    g.n[static_cast<std::size_t>(k)] =
        static_cast<std::size_t>(std::ceil((high[k] - low[k]) / cell)) + 1;
  g.values.resize(g.n[0] * g.n[1] * g.n[2]);
  parallel_for(g.n[2], 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z) {
      for (std::size_t y = 0; y < g.n[1]; ++y) {
        for (std::size_t x = 0; x < g.n[0]; ++x) g.values[g.index(x, y, z)] = field(g.at(x, y, z));
      }
    }
  });
  return g;
}

// One vertex a cell that the surface crosses: the mean of the crossings on the cell's edges.
std::unordered_map<std::size_t, std::uint32_t> place_vertices(const Grid& g, TriMesh& mesh) {
  std::unordered_map<std::size_t, std::uint32_t> ids;
  for (std::size_t z = 0; z + 1 < g.n[2]; ++z) {
    for (std::size_t y = 0; y + 1 < g.n[1]; ++y) {
      for (std::size_t x = 0; x + 1 < g.n[0]; ++x) {
        Vec3 sum(0);
        int count = 0;
        for (unsigned a = 0; a < 8; ++a) {
          for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned b = a | (1u << axis);
            if (b == a) continue;
            const auto corner = [&](unsigned c) {
              return std::array{x + (c & 1u), y + (c >> 1 & 1u), z + (c >> 2 & 1u)};
            };
            const auto p = corner(a), q = corner(b);
            const double fp = g.values[g.index(p[0], p[1], p[2])],
                         fq = g.values[g.index(q[0], q[1], q[2])];
            if ((fp < 0) == (fq < 0)) continue;
            sum += glm::mix(g.at(p[0], p[1], p[2]), g.at(q[0], q[1], q[2]), fp / (fp - fq));
            ++count;
          }
        }
        if (count == 0) continue;
        ids[g.index(x, y, z)] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(sum / static_cast<double>(count));
      }
    }
  }
  return ids;
}

// One quad a grid edge that the surface crosses, between the four cells about it.
void connect(const Grid& g, const std::unordered_map<std::size_t, std::uint32_t>& ids,
             TriMesh& mesh) {
  for (std::size_t z = 1; z + 1 < g.n[2]; ++z) {
    for (std::size_t y = 1; y + 1 < g.n[1]; ++y) {
      for (std::size_t x = 1; x + 1 < g.n[0]; ++x) {
        const bool inside = g.values[g.index(x, y, z)] < 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
          const bool other =
              g.values[g.index(x + (axis == 0), y + (axis == 1), z + (axis == 2))] < 0;
          if (inside == other) continue;
          const auto cell = [&](std::size_t u, std::size_t v) {
            const std::size_t d[3][3] = {{0, u, v}, {v, 0, u}, {u, v, 0}};
            return ids.at(g.index(x - d[axis][0], y - d[axis][1], z - d[axis][2]));
          };
          std::array<std::uint32_t, 4> q{cell(1, 1), cell(0, 1), cell(0, 0), cell(1, 0)};
          if (!inside) std::swap(q[1], q[3]);
          const auto length = [&](int a, int b) {
            return glm::distance(mesh.positions[q[static_cast<std::size_t>(a)]],
                                 mesh.positions[q[static_cast<std::size_t>(b)]]);
          };
          if (length(0, 2) < length(1, 3)) {
            mesh.triangles.push_back({q[0], q[1], q[2]});
            mesh.triangles.push_back({q[0], q[2], q[3]});
          } else {
            mesh.triangles.push_back({q[0], q[1], q[3]});
            mesh.triangles.push_back({q[1], q[2], q[3]});
          }
        }
      }
    }
  }
}

Vec3 gradient(const Field& field, Vec3 p, double h) {
  return Vec3(field(p + Vec3(h, 0, 0)) - field(p - Vec3(h, 0, 0)),
              field(p + Vec3(0, h, 0)) - field(p - Vec3(0, h, 0)),
              field(p + Vec3(0, 0, h)) - field(p - Vec3(0, 0, h))) /
         (2 * h);
}

void relax(const Field& field, double cell, TriMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> neighbours(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) neighbours[t[k]].push_back(t[(k + 1) % 3]);
  }
  const auto project = [&](Vec3 p, int steps) {
    for (int i = 0; i < steps; ++i) {
      const Vec3 g = gradient(field, p, 1e-3 * cell);
      const double square = glm::dot(g, g);
      if (square < 1e-12) break;
      Vec3 step = field(p) / square * g;
      // A step longer than a cell would leave the neighbourhood where the linear model holds.
      if (glm::length(step) > 0.5 * cell) step *= 0.5 * cell / glm::length(step);
      p -= step;
    }
    return p;
  };
  for (int round = 0; round < 6; ++round) {
    std::vector<Vec3> next(mesh.positions.size());
    parallel_for(next.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Vec3 mean(0);
        for (const std::uint32_t j : neighbours[i]) mean += mesh.positions[j];
        const Vec3 p = mesh.positions[i];
        if (neighbours[i].empty()) {
          next[i] = p;
          continue;
        }
        mean /= static_cast<double>(neighbours[i].size());
        const Vec3 normal = normalize_or(gradient(field, p, 1e-3 * cell), Vec3(0, 0, 1));
        next[i] = project(p + 0.7 * reject(mean - p, normal), 2);
      }
    });
    mesh.positions = std::move(next);
  }
}

}  // namespace

TriMesh mesh_implicit(const Field& field, Vec3 low, Vec3 high, double cell) {
  const Grid grid = sample(field, low, high, cell);
  TriMesh mesh;
  const auto ids = place_vertices(grid, mesh);
  connect(grid, ids, mesh);
  relax(field, cell, mesh);
  return mesh;
}

double sphere(Vec3 p, Vec3 center, double radius) { return glm::distance(p, center) - radius; }

double ellipsoid(Vec3 p, Vec3 center, Vec3 half) {
  // First-order distance: exact on the surface, fair near it.
  const Vec3 q = (p - center) / half;
  const double k0 = glm::length(q), k1 = glm::length(q / half);
  return k1 > 0 ? k0 * (k0 - 1) / k1 : -std::min({half.x, half.y, half.z});
}

double limb(Vec3 p, Vec3 a, Vec3 b, double ra, double rb) {
  const Vec3 d = b - a;
  const double t = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
  return glm::distance(p, a + t * d) - (ra + (rb - ra) * t);
}

double round_box(Vec3 p, Vec3 center, Vec3 half, double radius) {
  const Vec3 q = glm::abs(p - center) - half + radius;
  return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0) - radius;
}

double torus(Vec3 p, Vec3 center, double major, double minor) {
  const Vec3 q = p - center;
  return std::hypot(std::hypot(q.x, q.y) - major, q.z) - minor;
}

}  // namespace burin::samples
