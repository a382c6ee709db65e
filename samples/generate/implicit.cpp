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

// The 24 slots of a cell's edges: the edge from corner `a` along `axis` (where bit `axis` of `a` is
// clear).
constexpr unsigned kEdgeSlots = 24;
unsigned edge_slot(unsigned a, unsigned axis) { return 3 * a + axis; }

// For each crossed edge of a cell the sheet it belongs to, numbered by one of its edges. Two
// crossings on a face of the cell belong together; of four, those about the same inside corner: so
// sheets that pass close by stay apart.
std::array<unsigned, kEdgeSlots> sheets_of(const std::array<double, 8>& corner) {
  std::array<unsigned, kEdgeSlots> root{};
  for (unsigned i = 0; i < kEdgeSlots; ++i) root[i] = i;
  const auto join = [&](unsigned a, unsigned b) {
    const unsigned from = root[b], to = root[a];
    for (unsigned& r : root) r = r == from ? to : r;
  };
  for (unsigned face = 0; face < 6; ++face) {
    const unsigned n = face / 2, u = (n + 1) % 3, v = (n + 2) % 3, base = (face & 1u) << n;
    const unsigned ring[4] = {base, base | 1u << u, base | 1u << u | 1u << v, base | 1u << v};
    const unsigned edges[4] = {edge_slot(ring[0], u), edge_slot(ring[1], v), edge_slot(ring[3], u),
                               edge_slot(ring[0], v)};
    std::vector<unsigned> crossed;
    for (unsigned k = 0; k < 4; ++k) {
      if ((corner[ring[k]] < 0) != (corner[ring[(k + 1) % 4]] < 0)) crossed.push_back(k);
    }
    if (crossed.size() == 2) join(edges[crossed[0]], edges[crossed[1]]);
    if (crossed.size() < 4) continue;
    for (unsigned k = 0; k < 4; ++k) {
      if (corner[ring[k]] < 0) join(edges[k], edges[(k + 3) % 4]);
    }
  }
  return root;
}

using VertexIds = std::unordered_map<std::size_t, std::uint32_t>;

// One vertex a cell and sheet: the mean of the sheet's crossings on the cell's edges. Keys are cell
// * 24 + edge.
VertexIds place_vertices(const Grid& g, TriMesh& mesh) {
  VertexIds ids;
  for (std::size_t z = 0; z + 1 < g.n[2]; ++z) {
    for (std::size_t y = 0; y + 1 < g.n[1]; ++y) {
      for (std::size_t x = 0; x + 1 < g.n[0]; ++x) {
        std::array<double, 8> value{};
        std::array<Vec3, 8> place{};
        for (unsigned c = 0; c < 8; ++c) {
          value[c] = g.values[g.index(x + (c & 1u), y + (c >> 1 & 1u), z + (c >> 2 & 1u))];
          place[c] = g.at(x + (c & 1u), y + (c >> 1 & 1u), z + (c >> 2 & 1u));
        }
        const auto sheet = sheets_of(value);
        std::array<Vec3, kEdgeSlots> sum{};
        std::array<int, kEdgeSlots> count{};
        for (unsigned e = 0; e < kEdgeSlots; ++e) {
          const unsigned a = e / 3, b = a | (1u << e % 3);
          if (a == b || (value[a] < 0) == (value[b] < 0)) continue;
          sum[sheet[e]] += glm::mix(place[a], place[b], value[a] / (value[a] - value[b]));
          ++count[sheet[e]];
        }
        std::array<std::uint32_t, kEdgeSlots> vertex{};
        for (unsigned e = 0; e < kEdgeSlots; ++e) {
          if (count[e] == 0) continue;
          vertex[e] = static_cast<std::uint32_t>(mesh.positions.size());
          mesh.positions.push_back(sum[e] / static_cast<double>(count[e]));
        }
        for (unsigned e = 0; e < kEdgeSlots; ++e) {
          if (count[sheet[e]] > 0) ids[g.index(x, y, z) * kEdgeSlots + e] = vertex[sheet[e]];
        }
      }
    }
  }
  return ids;
}

// Two triangles over the shorter diagonal.
void append_quad(TriMesh& mesh, const std::array<std::uint32_t, 4>& q) {
  const auto length = [&](std::size_t a, std::size_t b) {
    return glm::distance(mesh.positions[q[a]], mesh.positions[q[b]]);
  };
  if (length(0, 2) < length(1, 3)) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  } else {
    mesh.triangles.push_back({q[0], q[1], q[3]});
    mesh.triangles.push_back({q[1], q[2], q[3]});
  }
}

// One quad a grid edge that the surface crosses, between the four cells about it.
void connect(const Grid& g, const VertexIds& ids, TriMesh& mesh) {
  for (std::size_t z = 1; z + 1 < g.n[2]; ++z) {
    for (std::size_t y = 1; y + 1 < g.n[1]; ++y) {
      for (std::size_t x = 1; x + 1 < g.n[0]; ++x) {
        const bool inside = g.values[g.index(x, y, z)] < 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
          const bool other =
              g.values[g.index(x + (axis == 0), y + (axis == 1), z + (axis == 2))] < 0;
          if (inside == other) continue;
          // The cell that lies `u` and `v` cells back along the other two axes has the edge at that
          // corner of its own.
          const auto vertex = [&](unsigned u, unsigned v) {
            std::array<unsigned, 3> back{};
            back[(axis + 1) % 3] = u;
            back[(axis + 2) % 3] = v;
            const unsigned corner = back[0] | back[1] << 1 | back[2] << 2;
            return ids.at(g.index(x - back[0], y - back[1], z - back[2]) * kEdgeSlots +
                          edge_slot(corner, axis));
          };
          std::array<std::uint32_t, 4> quad{vertex(1, 1), vertex(0, 1), vertex(0, 0), vertex(1, 0)};
          if (!inside) std::swap(quad[1], quad[3]);
          append_quad(mesh, quad);
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
  Builder builder;  // which finds what surface nets get wrong in too coarse a grid
  builder.add(mesh);
  return builder.finish();
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
