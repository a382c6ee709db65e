#include "exact_mesh.h"

#include <burin/work_mesh/division.h>

#include <array>
#include <cmath>

namespace burin {

std::uint32_t ExactMesh::add_vertex(Vec3 position, Vec3 normal, std::uint64_t piece) {
  positions.push_back(position);
  normals.push_back(normal);
  pieces.push_back(piece);
  crease.push_back(-1);
  zero.push_back(0);
  return static_cast<std::uint32_t>(positions.size() - 1);
}

std::uint32_t ExactMesh::add_crease_vertex(Vec3 position, CreaseVertex sides) {
  const std::uint32_t v = add_vertex(position, sides.sides.front().normal, 0);
  crease[v] = static_cast<std::int32_t>(creases.size());
  creases.push_back(std::move(sides));
  return v;
}

const CreaseVertex::Side& ExactMesh::side_at(std::size_t t, std::uint32_t v) const {
  const std::vector<CreaseVertex::Side>& sides = creases[static_cast<std::size_t>(crease[v])].sides;
  for (const auto& s : sides) {
    if (s.piece == side[t]) return s;
  }
  // The triangle's piece ends smoothly before it gets here: the side it runs on into.
  Vec3 n(0);
  if (side[t]) n = normalize_or(side[t]->gradient(positions[v]).gradient, Vec3(0));
  return *std::ranges::max_element(
      sides, {}, [&](const CreaseVertex::Side& s) { return glm::dot(s.normal, n); });
}

Vec3 ExactMesh::corner_normal(std::size_t t, std::size_t k) const {
  const std::uint32_t v = triangles[t][k];
  return on_crease(v) ? side_at(t, v).normal : normals[v];
}

bool ExactMesh::corner_zero(std::size_t t, std::size_t k) const {
  const std::uint32_t v = triangles[t][k];
  return on_crease(v) ? side_at(t, v).zero : zero[v] != 0;
}

void EdgePoints::sort() { std::ranges::sort(points_); }

std::uint32_t EdgePoints::find(std::uint32_t u, std::uint32_t v) const {
  const std::uint64_t wanted = key(u, v);
  const auto it =
      std::ranges::lower_bound(points_, wanted, {}, [](const auto& p) { return p.first; });
  return it != points_.end() && it->first == wanted ? it->second : kNone;
}

void cut_at_points(ExactMesh& mesh, const EdgePoints& points,
                   const std::function<std::uint32_t(std::size_t)>& center) {
  constexpr std::uint32_t kNone = EdgePoints::kNone;
  const std::size_t count = mesh.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const Triangle old = mesh.triangles[t];
    std::array<std::uint32_t, 6> corner{old[0], old[1], old[2]};
    std::array<Vec3, 6> place{};
    std::uint8_t marks = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[3 + k] = points.find(old[k], old[(k + 1) % 3]);
      if (corner[3 + k] != kNone) marks |= static_cast<std::uint8_t>(1U << k);
    }
    if (marks == 0) continue;
    for (std::size_t k = 0; k < 6; ++k) {
      if (corner[k] != kNone) place[k] = mesh.positions[corner[k]];
    }
    const ImplicitFunction* side = mesh.side[t];
    bool first = true;
    const auto emit = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (first) {
        mesh.triangles[t] = {a, b, c};
        first = false;
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.side.push_back(side);
      }
    };
    const std::uint32_t inside = marks == 7 && center ? center(t) : kNone;
    if (inside != kNone) {
      for (std::size_t k = 0; k < 3; ++k) {
        emit(corner[k], corner[3 + k], inside);
        emit(corner[k], inside, corner[3 + (k + 2) % 3]);
      }
      continue;
    }
    for (const Division::Piece& p : divide(marks, place))
      emit(corner[p[0]], corner[p[1]], corner[p[2]]);
  }
}

}  // namespace burin
