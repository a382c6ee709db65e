#include "specks.h"

#include <algorithm>

namespace burin {
namespace {

void drop_unused(ExactMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = 1;
  }
  std::vector<std::uint32_t> name(used.size());
  std::uint32_t n = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    name[v] = n;
    mesh.positions[n] = mesh.positions[v];
    mesh.normals[n] = mesh.normals[v];
    mesh.pieces[n] = mesh.pieces[v];
    mesh.crease[n] = mesh.crease[v];
    if (v < mesh.spacing.size()) mesh.spacing[n] = mesh.spacing[v];
    mesh.zero[n++] = mesh.zero[v];
  }
  if (!mesh.spacing.empty()) mesh.spacing.resize(n);
  mesh.positions.resize(n);
  mesh.normals.resize(n);
  mesh.pieces.resize(n);
  mesh.crease.resize(n);
  mesh.zero.resize(n);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = name[v];
  }
}

}  // namespace

MeshComponents::MeshComponents(const ExactMesh& mesh)
    : sets(mesh.positions.size()), boxes(mesh.positions.size()) {
  for (const Triangle& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) boxes[sets.find(v)].add(mesh.positions[v]);
  }
}

std::vector<std::uint8_t> one_sided_components(const ExactMesh& mesh, MeshComponents& parts,
                                               double limit) {
  constexpr double kMostBehind = 0.25;  // of a component's area
  std::vector<double> area(parts.boxes.size(), 0), behind(parts.boxes.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& tri = mesh.triangles[t];
    const std::uint32_t set = parts.sets.find(tri[0]);
    if (parts.boxes[set].diagonal() >= limit) continue;
    const Vec3 a = mesh.positions[tri[0]];
    const Vec3 n = glm::cross(mesh.positions[tri[1]] - a, mesh.positions[tri[2]] - a);
    Vec3 outward(0);
    for (std::size_t k = 0; k < 3; ++k) outward += mesh.corner_normal(t, k);
    const double twice = glm::length(n);
    area[set] += twice;
    if (glm::dot(n, outward) < 0) behind[set] += twice;
  }
  std::vector<std::uint8_t> found(area.size(), 0);
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = behind[i] > kMostBehind * area[i];
  return found;
}

double largest_component(const ExactMesh& mesh) {
  double most = 0;
  for (const Box3& b : MeshComponents(mesh).boxes)
    most = std::max(most, b.empty() ? 0 : b.diagonal());
  return most;
}

void drop_components(ExactMesh& mesh, MeshComponents& parts,
                     const std::vector<std::uint8_t>& dropped) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (dropped[parts.sets.find(mesh.triangles[t][0])]) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    mesh.side[kept++] = mesh.side[t];
  }
  mesh.triangles.resize(kept);
  mesh.side.resize(kept);
  drop_unused(mesh);
}

std::size_t drop_specks(ExactMesh& mesh, double smallest) {
  MeshComponents parts(mesh);
  std::vector<std::uint8_t> speck(parts.boxes.size(), 0);
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < speck.size(); ++i) {
    speck[i] = !parts.boxes[i].empty() && parts.boxes[i].diagonal() < smallest;
    dropped += speck[i];
  }
  if (dropped > 0) drop_components(mesh, parts, speck);
  return dropped;
}

}  // namespace burin
