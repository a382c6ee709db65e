#include "sizing.h"

#include <burin/base/parallel.h>

#include "../../function/shape_operator.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace burin {
namespace {

// Share of the surface's size, and of the radius of curvature, that the ball's radius is at most:
// 11 degrees of turning.
constexpr double kLargest = 1.0 / 32, kMostTurned = 0.2;
// Share of a step of the coarse mesh that it is at least.
constexpr double kSmallest = 0.02;
// What it may grow by a unit of distance.
constexpr double kGrowth = 0.25;
// Share of a wall's thickness, so that both of its faces are told apart.
constexpr double kOfThickness = 0.5;
// What is thinner than this share of the distance to the next crease is a wall, else the wedge
// beside the crease, whose faces the crease's own vertices keep apart.
constexpr double kThin = 0.3;
constexpr std::size_t kSizingGrain = 512;
// Vertices in the area of a squared radius, as measured on what refinement gives.
constexpr double kDensity = 0.62;

}  // namespace

Sizing::Sizing(const ExactMesh& mesh, const ImplicitFunction& f, const CreaseChains& chains,
               double tolerance, const RunContext& context)
    : mesh_(mesh), tolerance_(tolerance) {
  Box3 box;
  for (const Vec3& p : mesh.positions) box.add(p);
  origin_ = box.min;
  const Vec3 size = box.size();
  largest_ = kLargest * std::max({size.x, size.y, size.z});
  next_.resize(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) next_[t[k]].push_back(t[(k + 1) % 3]);
  }
  by_curvature(f, chains, context);
  by_thickness(f, context);
  for (std::uint32_t v = 0; v < radius_.size(); ++v) {
    if (next_[v].empty()) radius_[v] = largest_;  // no longer used
  }
  spread(radius_, kGrowth);
  least_ = *std::ranges::min_element(radius_);
  // Bends of less than four steps of the coarse mesh.
  doubtful_ = std::min(std::sqrt(2 * 4 * mesh.step * tolerance), kMostTurned * 4 * mesh.step);
  fill_cells();
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    const double area =
        0.5 * glm::length(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    const double r = (radius_[t[0]] + radius_[t[1]] + radius_[t[2]]) / 3;
    expected_ += kDensity * area / (r * r);
  }
}

void Sizing::by_curvature(const ImplicitFunction& f, const CreaseChains& chains,
                          const RunContext& context) {
  std::vector<double> curvature(mesh_.positions.size(), 0);
  const auto raise = [&](std::uint32_t v, double k) {
    if (std::isfinite(k)) curvature[v] = std::max(curvature[v], k);
  };
  parallel_for(
      curvature.size(), kSizingGrain,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Gradient2> g(end - begin);
        f.hessians(std::span(mesh_.positions).subspan(begin, end - begin), g);
        for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
          if (!mesh_.on_crease(v)) {
            raise(v, largest_curvature(g[v - begin]));
            continue;
          }
          for (const auto& s : mesh_.creases[static_cast<std::size_t>(mesh_.crease[v])].sides) {
            raise(v, largest_curvature(s.piece->hessian(mesh_.positions[v])));
          }
        }
      },
      &context);
  // Bends between two vertices that neither of them shows: fillets smaller than a step.
  for (const Triangle& t : mesh_.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t u = t[k], v = t[(k + 1) % 3];
      if (mesh_.on_crease(u) || mesh_.on_crease(v)) continue;
      if (mesh_.normals[u] == Vec3(0) || mesh_.normals[v] == Vec3(0)) continue;  // tips
      const double turn = glm::distance(mesh_.normals[u], mesh_.normals[v]),
                   length = glm::distance(mesh_.positions[u], mesh_.positions[v]);
      if (!(length > 0.1 * mesh_.step)) continue;  // slivers
      for (const std::uint32_t w : {u, v}) raise(w, turn / length);
    }
  }
  for (const auto& chain : chains) {
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const Vec3 a = mesh_.positions[chain[i]] - mesh_.positions[chain[i - 1]],
                 b = mesh_.positions[chain[i + 1]] - mesh_.positions[chain[i]];
      const double length = 0.5 * (glm::length(a) + glm::length(b));
      if (!(length > 0.3 * mesh_.step)) continue;
      raise(chain[i], glm::distance(normalize_or(a, Vec3(0)), normalize_or(b, Vec3(0))) / length);
    }
  }
  // Tips have no end of curvature.
  const double smallest = kSmallest * mesh_.step;
  radius_.resize(curvature.size());
  for (std::size_t v = 0; v < radius_.size(); ++v) {
    const double r = 1 / std::max(curvature[v], 1e-300);
    radius_[v] =
        std::clamp(std::min(std::sqrt(2 * r * tolerance_), kMostTurned * r), smallest, largest_);
  }
}

void Sizing::by_thickness(const ImplicitFunction& f, const RunContext& context) {
  constexpr std::size_t kSteps = 8;
  constexpr double kFar = 2;  // times the radius: farther walls do not matter
  const std::vector<double> to_crease = crease_distances();
  parallel_for(
      radius_.size(), kSizingGrain,
      [&](std::size_t begin, std::size_t end) {
        // All at once: a single call costs as much as a hundred points.
        std::vector<std::uint32_t> asked;
        std::vector<Vec3> points;
        for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
          if (next_[v].empty() || mesh_.on_crease(v) || mesh_.normals[v] == Vec3(0)) continue;
          asked.push_back(v);
          for (std::size_t i = 1; i <= kSteps; ++i) {
            const double far = kFar * radius_[v] * static_cast<double>(i) / kSteps;
            const Vec3 off = far * mesh_.normals[v];
            points.push_back(mesh_.positions[v] - off);
            points.push_back(mesh_.positions[v] + off);
          }
        }
        std::vector<double> values(points.size());
        f.values(points, values);
        for (std::size_t n = 0; n < asked.size(); ++n) {
          const std::uint32_t v = asked[n];
          for (std::size_t i = 2 * kSteps * n; i < 2 * kSteps * (n + 1); i += 2) {
            if (values[i] < 0 && !(values[i + 1] < 0)) continue;
            const double thickness = glm::distance(points[i], mesh_.positions[v]);
            if (thickness < kThin * to_crease[v]) {
              radius_[v] = std::min(radius_[v], kOfThickness * thickness);
            }
            break;
          }
        }
      },
      &context);
}

std::vector<double> Sizing::crease_distances() const {
  std::vector<double> d(radius_.size(), std::numeric_limits<double>::infinity());
  for (std::uint32_t v = 0; v < d.size(); ++v) {
    if (mesh_.on_crease(v)) d[v] = 0;
  }
  spread(d, 1);
  return d;
}

void Sizing::spread(std::vector<double>& values, double growth) const {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < values.size(); ++v) {
    for (const std::uint32_t w : next_[v]) {
      const double most =
          values[v] + growth * glm::distance(mesh_.positions[v], mesh_.positions[w]);
      if (!(values[w] > most)) continue;
      values[w] = most;
      queue.emplace(most, w);
    }
  }
  while (!queue.empty()) {
    const auto [least, v] = queue.top();
    queue.pop();
    if (least > values[v]) continue;
    for (const std::uint32_t w : next_[v]) {
      const double most = least + growth * glm::distance(mesh_.positions[v], mesh_.positions[w]);
      if (!(values[w] > most)) continue;
      values[w] = most;
      queue.emplace(most, w);
    }
  }
}

void Sizing::fill_cells() {
  std::unordered_map<std::uint64_t, std::pair<glm::ivec3, double>> own;
  for (const Triangle& t : mesh_.triangles) {
    for (const std::uint32_t v : t) {
      const glm::ivec3 c((mesh_.positions[v] - origin_) / mesh_.step);
      auto& entry = own.try_emplace(cell_key(c), c, radius_[v]).first->second;
      entry.second = std::min(entry.second, radius_[v]);
    }
  }
  cells_.reserve(4 * own.size());
  for (const auto& [key, entry] : own) {
    for (int i = 0; i < 27; ++i) {
      const glm::ivec3 c = entry.first + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
      double& r = cells_.try_emplace(cell_key(c), entry.second).first->second;
      r = std::min(r, entry.second);
    }
  }
}

double Sizing::at(Vec3 p) const {
  const auto it = cells_.find(cell_key(glm::ivec3(glm::floor((p - origin_) / mesh_.step))));
  return it == cells_.end() ? largest_ : it->second;
}

void Sizing::enlarge(double times) {
  for (double& r : radius_) r *= times;
  for (auto& cell : cells_) cell.second *= times;
  largest_ *= times;
  least_ *= times;
  doubtful_ *= times;
  expected_ /= times * times;
  tolerance_ *= times * times;
}

}  // namespace burin
