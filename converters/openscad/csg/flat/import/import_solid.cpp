#include <burin/base/error.h>
#include <burin/converters/amf_objects.h>
#include <burin/converters/mesh_reader.h>
#include <burin/repair/repair.h>

#include "import_file.h"

#include <utility>
#include <vector>

namespace burin::csg {
namespace {

Solid solid_of(TriMesh mesh) {
  Solid solid;
  solid.positions = std::move(mesh.positions);
  solid.triangles = std::move(mesh.triangles);
  solid.surface.assign(solid.triangles.size(), -1);
  return solid;
}

std::vector<Solid> of_file(Evaluation& e, std::uint32_t node) {
  const std::filesystem::path path = file_of(e, node);
  const std::string suffix = suffix_of(path);
  if (suffix == ".nef3") {
    throw InputError("is a polyhedron that CGAL wrote for itself; export it as OFF or STL",
                     path.string());
  }
  if (suffix != ".amf" && suffix != ".stl" && suffix != ".off" && suffix != ".3mf") {
    report(e, node, "openscad.unknown_format",
           path.string() + ": no format that import() reads; it is left out, as OpenSCAD does");
    return {};
  }
  MeshFile file = suffix == ".amf" ? read_amf_objects(path, e.run) : read_mesh_file(path, e.run);
  e.diagnostics.append(file.diagnostics);
  std::vector<Solid> solids;
  for (PolygonSoup& object : placed_objects(std::move(file))) {
    try {
      solids.push_back(solid_of(repair(std::move(object), {}, e.diagnostics, e.run)));
    } catch (const GeometryError& error) {
      report(e, node, "openscad.empty_import", path.string() + ": " + error.what());
    }
  }
  return solids;
}

void append(Solid& to, const Solid& more) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& [a, b, c] : more.triangles) {
    to.triangles.push_back({first + a, first + b, first + c});
  }
  to.surface.resize(to.triangles.size(), -1);
}

}  // namespace

std::vector<Solid> file_solids(Evaluation& e, std::uint32_t node) {
  e.run.check();
  return at_node(e, node, [&]() -> std::vector<Solid> {
    if (e.tree.nodes[node].module == Module::Surface) return {height_map(e, node)};
    return if_there(e, node, [&]() -> std::vector<Solid> { return of_file(e, node); });
  });
}

Solid file_solid(Evaluation& e, std::uint32_t node) {
  Solid all;
  for (Solid& solid : file_solids(e, node)) {
    if (all.empty())
      all = std::move(solid);
    else
      append(all, solid);
  }
  return all;
}

}  // namespace burin::csg
