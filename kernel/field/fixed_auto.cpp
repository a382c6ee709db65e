#include <burin/base/parallel.h>
#include <burin/field/field.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::field {
namespace {

// Cells of a side of the map of all normals, which is a square.
constexpr int kSide = 64;
// Directions that are tried, over half a sphere: some 4 degrees apart.
constexpr int kTried = 1500;
// Halvings of the step by which the best one is made better: to a hundredth of a degree.
constexpr int kHalvings = 9;

// A normal that stands for all of its cell, and the area that has it.
struct Weighed {
  Vec3 normal{0};
  double area = 0;
};

// Of a unit vector or its opposite: half of an octahedron, unfolded. @cite Cigolle2014
std::size_t cell_of(Vec3 n) {
  if (n.z < 0) n = -n;
  n /= std::abs(n.x) + std::abs(n.y) + n.z;
  const auto cell = [](double v) {  // v in [-1, 1]
    return std::clamp(static_cast<int>((0.5 * v + 0.5) * kSide), 0, kSide - 1);
  };
  return static_cast<std::size_t>(cell(n.x + n.y) * kSide + cell(n.x - n.y));
}

// The Gauss map of a part, by area: normals and their opposites are one.
std::vector<Weighed> gauss_map(const ProxyMesh& proxy) {
  std::vector<Weighed> cells(static_cast<std::size_t>(kSide) * kSide);
  double all = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    Vec3 n = proxy.mesh.normal(f);
    const double area = proxy.mesh.area(f);
    if (!(area > 0) || n == Vec3(0)) continue;
    Weighed& cell = cells[cell_of(n)];
    // Opposites fall into one cell; on the rim of the half sphere they add up, not cancel.
    if (glm::dot(cell.normal, n) < 0) n = -n;
    cell.normal += area * n;
    cell.area += area;
    all += area;
  }
  std::erase_if(cells, [](const Weighed& cell) { return !(cell.area > 0); });
  for (Weighed& cell : cells) {
    cell.normal = normalize_or(cell.normal, Vec3(0, 0, 1));
    cell.area /= all;
  }
  return cells;
}

// To the power of 24: how much worse a normal near to the direction is than one far from it.
double sharp(double cosine) {
  const double square = cosine * cosine, fourth = square * square, eighth = fourth * fourth;
  return eighth * eighth * eighth;
}

// How much of the surface, and how nearly, has the direction for its normal; of directions that are
// as good the usual one is the best.
double cost(const std::vector<Weighed>& map, Vec3 direction, Vec3 usual) {
  constexpr double kPreference = 1e-9;
  double sum = 0;
  for (const Weighed& w : map) {
    sum += w.area * sharp(glm::dot(w.normal, direction));
  }
  return sum + kPreference * (1 - std::abs(glm::dot(direction, usual)));
}

Vec3 outside(const std::vector<Weighed>& map, Vec3 usual) {
  Vec3 best = usual;
  double least = cost(map, usual, usual);
  const auto consider = [&](Vec3 d) {
    const double c = cost(map, d, usual);
    if (c >= least) return false;
    least = c;
    best = d;
    return true;
  };
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < kTried; ++i) {
    const double z = (i + 0.5) / kTried, r = std::sqrt(1 - z * z), a = golden * i;
    consider({r * std::cos(a), r * std::sin(a), z});
  }
  double step = glm::radians(4.0);
  for (int halving = 0; halving < kHalvings; step *= 0.5, ++halving) {
    constexpr int kMost = 8;  // steps of one size
    for (int k = 0; k < kMost; ++k) {
      const Vec3 x = any_orthogonal(best), y = glm::cross(best, x), from = best;
      bool better = false;
      for (int way = 0; way < 8; ++way) {
        const double a = std::numbers::pi / 4 * way;
        better |= consider(glm::normalize(from + step * (std::cos(a) * x + std::sin(a) * y)));
      }
      if (!better) break;
    }
  }
  return best;
}

}  // namespace

Field fixed_auto(const std::vector<const Surface*>& surfaces, Vec3 usual,
                 const RunContext& context) {
  const Vec3 unit = normalize_or(usual, Vec3(0, 0, 1));
  std::vector<Field> fields(surfaces.size());
  parallel_for(
      surfaces.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          fields[i] = fixed(outside(gauss_map(surfaces[i]->proxy()), unit));
        }
      },
      &context);
  return {"fixed-auto", [fields = std::move(fields)](const FieldQuery& q) {
            return fields[static_cast<std::size_t>(q.part)].cross(q);
          }};
}

}  // namespace burin::field
