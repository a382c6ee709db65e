#include "loose_faces.h"

#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/compact.h>
#include <burin/mesh/curvature.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/repair/repair.h>

#include "chart_mesh_builder.h"

#include <map>
#include <utility>

namespace burin {
namespace {

/// The triangles of each face as a soup.
std::map<std::int32_t, PolygonSoup> by_face(const LooseTriangles& loose) {
  std::map<std::int32_t, PolygonSoup> soups;
  for (std::size_t t = 0; t < loose.triangles.size(); ++t) {
    PolygonSoup& soup = soups[loose.face[t]];
    for (const std::uint32_t v : loose.triangles[t]) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back(loose.positions[v]);
    }
    soup.offsets.push_back(soup.indices.size());
  }
  return soups;
}

/// Each face mended on its own, so that its triangles stay known.
LooseTriangles mended_triangles(const LooseTriangles& loose, const RunContext& context) {
  LooseTriangles out;
  for (auto& [face, soup] : by_face(loose)) {
    Diagnostics unheard;  // the face is named as loose already
    try {
      const TriMesh mesh = repair(std::move(soup), {}, unheard, context);
      out.append(
          {mesh.positions, mesh.triangles, std::vector<std::int32_t>(mesh.triangles.size(), face)});
    } catch (const GeometryError&) {  // no triangle of it has an area
      continue;
    }
  }
  return out;
}

/// The entries of half-edges, three a triangle.
template <class T>
void move_three(std::vector<T>& v, std::size_t from, std::size_t to) {
  if (v.empty()) return;
  for (std::size_t k = 0; k < 3; ++k) v[3 * to + k] = v[3 * from + k];
}
template <class T>
void cut_to(std::vector<T>& v, std::size_t size) {
  if (!v.empty()) v.resize(size);
}

}  // namespace

LooseTriangles take_loose(ChartMesh& mesh, std::span<const std::uint8_t> loose,
                          std::vector<std::uint8_t>* corners) {
  LooseTriangles out;
  std::vector<std::uint32_t> number(mesh.positions.size(), kNone);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!loose[static_cast<std::size_t>(mesh.face[t])]) {
      mesh.triangles[kept] = mesh.triangles[t];
      mesh.face[kept] = mesh.face[t];
      move_three(mesh.uv, t, kept);
      move_three(mesh.normal, t, kept);
      move_three(mesh.on_contour, t, kept);
      move_three(mesh.border, t, kept);
      if (corners) move_three(*corners, t, kept);
      ++kept;
      continue;
    }
    Triangle moved = mesh.triangles[t];
    for (std::uint32_t& v : moved) {
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(out.positions.size());
        out.positions.push_back(mesh.positions[v]);
      }
      v = number[v];
    }
    out.triangles.push_back(moved);
    out.face.push_back(mesh.face[t]);
  }
  if (kept == mesh.triangles.size()) return out;
  mesh.triangles.resize(kept);
  mesh.face.resize(kept);
  cut_to(mesh.uv, 3 * kept);
  cut_to(mesh.normal, 3 * kept);
  cut_to(mesh.on_contour, 3 * kept);
  cut_to(mesh.border, 3 * kept);
  if (corners) cut_to(*corners, 3 * kept);
  compact(mesh.positions, mesh.triangles);
  return out;
}

std::shared_ptr<const Surface> loose_surface(const LooseTriangles& triangles,
                                             const RealiseOptions& options,
                                             const RunContext& context) {
  LooseTriangles clean = mended_triangles(triangles, context);
  if (clean.empty()) return nullptr;
  ProxyMesh proxy = build_proxy({std::move(clean.positions), std::move(clean.triangles)},
                                {.crease_angle = options.crease_angle}, context);
  proxy.source_face = std::move(clean.face);
  std::vector<Curvature> curvature;
  if (options.curvature) curvature = estimate_curvature(proxy, {}, context);
  return make_mesh_surface(std::move(proxy), curvature);
}

}  // namespace burin
