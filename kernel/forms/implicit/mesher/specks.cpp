#include "specks.h"

#include <burin/base/disjoint_sets.h>

#include <algorithm>

namespace burin {
namespace {

struct Components {
  DisjointSets sets;
  std::vector<Box3> boxes;  // by the name of their set

  explicit Components(const ExactMesh& mesh)
      : sets(mesh.positions.size()), boxes(mesh.positions.size()) {
    for (const Triangle& t : mesh.triangles) {
      sets.join(t[0], t[1]);
      sets.join(t[0], t[2]);
    }
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t v : t) boxes[sets.find(v)].add(mesh.positions[v]);
    }
  }
};

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
    mesh.zero[n++] = mesh.zero[v];
  }
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

double largest_component(const ExactMesh& mesh) {
  double most = 0;
  for (const Box3& b : Components(mesh).boxes) most = std::max(most, b.empty() ? 0 : b.diagonal());
  return most;
}

std::size_t drop_specks(ExactMesh& mesh, double smallest) {
  Components parts(mesh);
  std::vector<std::uint8_t> speck(parts.boxes.size(), 0);
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < speck.size(); ++i) {
    speck[i] = !parts.boxes[i].empty() && parts.boxes[i].diagonal() < smallest;
    dropped += speck[i];
  }
  if (dropped == 0) return 0;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (speck[parts.sets.find(mesh.triangles[t][0])]) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    mesh.side[kept++] = mesh.side[t];
  }
  mesh.triangles.resize(kept);
  mesh.side.resize(kept);
  drop_unused(mesh);
  return dropped;
}

}  // namespace burin
