#include <burin/converters/irit_reader.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/patches/parametric_form.h>

#include "reader.h"
#include "triangles_info.h"

#include <algorithm>
#include <set>

namespace burin {
namespace {

const char* format_name(irit::Kind kind) {
  switch (kind) {
    case irit::Kind::Data:
      return "IRIT data";
    case irit::Kind::Geomview:
      return "Geomview Bezier patches";
    case irit::Kind::List:
      break;
  }
  return "patch list";
}

PartInfo inspect_part(const Part& part, const BrepShape* shape, Diagnostics& diagnostics,
                      RunContext& context) {
  PartInfo info{part.name, part.assembly, part.color};
  if (shape != nullptr) {
    info = shape->measure({});
    info.name = part.name;
    info.assembly = part.assembly;
    info.color = part.color;
    return info;
  }
  constexpr double kChord = 1e-4;  // of the size
  RealiseOptions options;
  options.tolerance = kChord * part.form->bounds(Mat3(1)).diagonal();
  options.curvature = false;
  options.diagnostics = &diagnostics;
  const auto surface = part.form->realise(options, context);
  const ProxyMesh& proxy = surface->proxy();
  const auto* patches = dynamic_cast<const ParametricForm*>(part.form.get());
  info.components = static_cast<std::int64_t>(proxy.topology.component_closed.size());
  if (dynamic_cast<const ImplicitForm*>(part.form.get()) != nullptr) {
    info.faces = proxy.region_count;
  } else if (patches == nullptr) {
    info.triangles = static_cast<std::int64_t>(proxy.mesh.triangles.size());
    info.faces = proxy.region_count;
    info.boundary_edges = std::ranges::count(proxy.topology.opposite, kNoHalfEdge);
  } else {
    info.faces = static_cast<std::int64_t>(patches->patches().size());
    std::set<std::int32_t> edges, open;
    for (std::size_t h = 0; h < proxy.source_edge.size(); ++h) {
      if (proxy.source_edge[h] < 0) continue;
      edges.insert(proxy.source_edge[h]);
      if (proxy.topology.opposite[h] == kNoHalfEdge) open.insert(proxy.source_edge[h]);
    }
    info.edges = static_cast<std::int64_t>(edges.size());
    info.boundary_edges = static_cast<std::int64_t>(open.size());
  }
  info.bounds = proxy.mesh.bounds();
  measure_triangles(proxy.mesh, info);
  return info;
}

}  // namespace

FileInfo inspect_irit(const std::filesystem::path& path, RunContext& context,
                      const IritReadOptions& options) {
  FileInfo info;
  info.file = path.string();
  info.format = format_name(irit::kind_of(Source(path, context), path));
  const irit::Parts read = irit::read_parts(path, context, options);
  info.diagnostics = read.scene.diagnostics;
  for (std::size_t i = 0; i < read.scene.parts.size(); ++i) {
    info.parts.push_back(
        inspect_part(read.scene.parts[i], read.shapes[i].get(), info.diagnostics, context));
  }
  return info;
}

}  // namespace burin
