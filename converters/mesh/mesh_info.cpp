#include <burin/base/affine.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/proxy_mesh.h>

#include "self_intersections.h"
#include "triangles_info.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace burin {
namespace {

/// The triangles of a part, those of the file itself: no facet is rounded.
ProxyMesh triangles_of(const Part& part, RunContext& context) {
  if (const auto* form = dynamic_cast<const MeshForm*>(part.form.get())) {
    return build_proxy(form->mesh(), {}, context);
  }
  RealiseOptions as_they_are;
  as_they_are.tolerance = std::numeric_limits<double>::infinity();
  as_they_are.curvature = false;
  return part.form->realise(as_they_are, context)->proxy();
}

void copy_words(const Part& part, PartInfo& info) {
  info.name = part.name;
  info.assembly = part.assembly;
  info.color = part.color;
  info.colors = count_colors(part.color, part.face_colors.get());
  info.opacity = part.opacity;
}

/// Parts that share a form are measured once; those that are stretched are other shapes.
class Measures {
 public:
  explicit Measures(FileInfo& info) : info_(info) {}

  void add(const Part& part, RunContext& context) {
    const Definition shape = part.form->definition();
    const Placement by{shape.linear, Vec3(0)};
    if (!is_similar(by)) return info_.parts.push_back(measure_mesh_part(part, context));
    const auto [known, is_new] = first_.try_emplace(shape.shape, info_.parts.size(), by.scale());
    if (is_new) return info_.parts.push_back(measure_mesh_part(part, context));
    const auto [first, scale] = known->second;
    PartInfo one = info_.parts[first];
    copy_words(part, one);
    const double larger = by.scale() / scale;
    one.area *= larger * larger;
    one.volume *= larger * larger * larger;
    one.bounds = part.form->bounds(Mat3(1));
    one.same_shape_as = static_cast<std::int32_t>(first);
    info_.parts.push_back(std::move(one));
  }

 private:
  FileInfo& info_;
  std::map<const void*, std::pair<std::size_t, double>> first_;
};

}  // namespace

PartInfo measure_mesh_part(const Part& part, RunContext& context) {
  PartInfo info;
  copy_words(part, info);
  const ProxyMesh proxy = triangles_of(part, context);
  const TriMesh& mesh = proxy.mesh;
  info.vertices = static_cast<std::int64_t>(mesh.positions.size());
  info.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  info.faces = proxy.region_count;
  info.components = static_cast<std::int64_t>(proxy.topology.component_closed.size());
  info.boundary_edges = std::ranges::count(proxy.topology.opposite, kNoHalfEdge);
  info.self_intersections = count_self_intersections(mesh, context);
  info.bounds = mesh.bounds();
  measure_triangles(mesh, info);
  return info;
}

void measure_mesh_parts(const Scene& scene, FileInfo& info, RunContext& context) {
  Measures measures(info);
  for (const Part& part : scene.parts) measures.add(part, context);
}

FileInfo inspect_mesh(const std::filesystem::path& path, RunContext& context,
                      const std::string& encoding) {
  return inspect_mesh_file(read_mesh_file(path, context, encoding), path, context);
}

FileInfo inspect_mesh_file(MeshFile file, const std::filesystem::path& path, RunContext& context) {
  FileInfo info;
  info.file = path.string();
  info.format = file.format;
  const Scene scene = repair_parts(std::move(file), path, context);
  info.diagnostics = scene.diagnostics;
  measure_mesh_parts(scene, info, context);
  report_self_intersections(info);
  return info;
}

void report_self_intersections(FileInfo& info) {
  const std::int64_t crossings = info.total().self_intersections.value_or(0);
  if (crossings == 0) return;
  info.diagnostics.add(Severity::Warning, "mesh.self_intersections", crossings,
                       "pairs of triangles cross each other; they are drawn as they are");
}

}  // namespace burin
