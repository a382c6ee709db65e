#include <burin/base/parallel_filter.h>
#include <burin/mesh/tips.h>

#include "build_steps.h"
#include "tip_finder.h"

#include <algorithm>
#include <map>
#include <utility>

namespace burin {

namespace {

/// Whether other wedges stand at the vertex of this one.
bool has_company(const ProxyMesh& proxy, std::uint32_t w) {
  const std::vector<std::uint32_t>& vertex = proxy.wedge_vertex;
  return (w > 0 && vertex[w - 1] == vertex[w]) ||
         (w + 1 < vertex.size() && vertex[w + 1] == vertex[w]);
}

/// Gives the third corners of triangles between two tips the normals of these.
void flatten_between_tips(ProxyMesh& proxy, const std::vector<Vec3>& normals) {
  const std::vector<std::uint8_t> tips = wedges_at_tips(proxy);
  if (tips.empty()) return;
  std::map<std::uint32_t, Vec3> flat;  // by wedge
  for (std::uint32_t f = 0; f < proxy.wedges.size(); ++f) {
    if (const auto k = corner_beside_tips(tips, proxy.wedges[f])) {
      flat[proxy.wedges[f][*k]] += proxy.mesh.area(f) * normals[f];
    }
  }
  for (const auto& [w, sum] : flat) {
    proxy.wedge_normal[w] = normalize_or(sum, proxy.wedge_normal[w]);
  }
}

}  // namespace

void find_tips(ProxyMesh& proxy, const std::vector<Vec3>& normals, double crease_angle,
               const RunContext& context) {
  const TipFinder finder(proxy, normals, crease_angle);
  std::vector<HalfEdge> corner(proxy.wedge_vertex.size(), kNoHalfEdge);
  for (std::size_t h = proxy.edge_kind.size(); h-- > 0;) {
    corner[wedge_of(proxy, static_cast<HalfEdge>(h))] = static_cast<HalfEdge>(h);
  }
  const std::vector<std::uint32_t> tips = parallel_filter<std::uint32_t>(
      corner.size(), kFaceGrain,
      [&](std::uint32_t w) { return finder.is_tip(finder.first_of(corner[w])); }, context);
  if (tips.empty()) return;
  std::vector<std::uint32_t> labels(proxy.edge_kind.size(), 0);
  for (const std::uint32_t w : tips) finder.label(finder.first_of(corner[w]), labels);
  part_wedges(proxy, labels,
              [&](HalfEdge h) { return proxy.mesh.area(face_of(h)) * normals[face_of(h)]; });
  flatten_between_tips(proxy, normals);
}

std::vector<std::uint8_t> wedges_at_tips(const ProxyMesh& proxy) {
  std::vector<std::uint8_t> out;
  if (proxy.wedge_vertex.size() == proxy.mesh.positions.size()) return out;
  for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    if (proxy.edge_kind[i] != EdgeKind::Smooth || !has_company(proxy, wedge_of(proxy, h))) continue;
    if (one_wedge_at(proxy, h)) continue;
    out.resize(proxy.wedge_vertex.size(), 0);
    out[wedge_of(proxy, h)] = 1;
    out[wedge_of(proxy, next_in_face(proxy.topology.opposite[i]))] = 1;
  }
  return out;
}

std::optional<std::size_t> corner_beside_tips(std::span<const std::uint8_t> tips,
                                              const Triangle& wedges) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < 3; ++k) {
    if (tips[wedges[k]]) continue;
    if (found) return {};
    found = k;
  }
  return found;
}

void part_wedges(ProxyMesh& proxy, std::span<const std::uint32_t> label,
                 const std::function<Vec3(HalfEdge)>& corner_normal) {
  const Corners corners = corners_at(proxy.wedges, proxy.wedge_vertex.size());
  const auto label_of = [&](HalfEdge h) { return label[static_cast<std::size_t>(h)]; };
  ProxyMesh parted;
  std::vector<HalfEdge> sorted;
  for (std::uint32_t old = 0; old < proxy.wedge_vertex.size(); ++old) {
    sorted.assign(corners[old].begin(), corners[old].end());
    std::ranges::stable_sort(sorted, {}, label_of);
    const bool whole = sorted.empty() || label_of(sorted.front()) == label_of(sorted.back());
    Vec3 sum(0);
    for (std::size_t i = 0; i < sorted.size() || i == 0; ++i) {
      if (i == 0 || label_of(sorted[i]) != label_of(sorted[i - 1])) {
        parted.wedge_vertex.push_back(proxy.wedge_vertex[old]);
        parted.wedge_normal.push_back(proxy.wedge_normal[old]);
        if (!proxy.wedge_sagitta.empty()) parted.wedge_sagitta.push_back(proxy.wedge_sagitta[old]);
        sum = Vec3(0);
      }
      if (sorted.empty()) break;
      const HalfEdge h = sorted[i];
      proxy.wedges[face_of(h)][static_cast<std::size_t>(h % 3)] =
          static_cast<std::uint32_t>(parted.wedge_vertex.size() - 1);
      if (whole) continue;
      sum += corner_normal(h);
      parted.wedge_normal.back() = normalize_or(sum, proxy.wedge_normal[old]);
    }
  }
  proxy.wedge_vertex = std::move(parted.wedge_vertex);
  proxy.wedge_normal = std::move(parted.wedge_normal);
  proxy.wedge_sagitta = std::move(parted.wedge_sagitta);
}

}  // namespace burin
