#include <burin/base/parallel.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/proxy_mesh.h>

#include "self_intersections.h"
#include "triangles_info.h"

#include <algorithm>

namespace burin {
PartInfo measure_mesh_part(const Part& part, const RunContext& context) {
  PartInfo info;
  info.name = part.name;
  const TriMesh& mesh = dynamic_cast<const MeshForm&>(*part.form).mesh();
  info.vertices = static_cast<std::int64_t>(mesh.positions.size());
  info.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  const ProxyMesh proxy = build_proxy(mesh, {}, context);
  info.faces = proxy.region_count;
  info.components = static_cast<std::int64_t>(proxy.topology.component_closed.size());
  info.boundary_edges = std::ranges::count(proxy.topology.opposite, kNoHalfEdge);
  info.self_intersections = count_self_intersections(mesh, context);
  info.bounds = mesh.bounds();
  measure_triangles(mesh, info);
  return info;
}

FileInfo inspect_mesh(const std::filesystem::path& path, const RunContext& context,
                      const std::string& encoding) {
  FileInfo info;
  info.file = path.string();
  MeshFile file = read_mesh_file(path, context, encoding);
  info.format = file.format;
  const Scene scene = repair_parts(std::move(file), path, context);
  info.diagnostics = scene.diagnostics;
  for (const Part& part : scene.parts) info.parts.push_back(measure_mesh_part(part, context));
  tell_self_intersections(info);
  return info;
}

void tell_self_intersections(FileInfo& info) {
  const std::int64_t crossings = info.total().self_intersections.value_or(0);
  if (crossings == 0) return;
  info.diagnostics.add(Severity::Warning, "mesh.self_intersections", crossings,
                       "pairs of triangles cross each other; they are drawn as they are");
}

}  // namespace burin
