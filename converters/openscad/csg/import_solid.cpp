#include <burin/base/error.h>
#include <burin/converters/mesh_reader.h>
#include <burin/repair/repair.h>

#include "amf.h"
#include "import_file.h"

#include <algorithm>

namespace burin::csg {
namespace {

/// Objects beside each other in one solid; each closed and turned outwards.
void append(Solid& solid, const TriMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(solid.positions.size());
  solid.positions.insert(solid.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const Triangle& t : mesh.triangles) {
    solid.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  solid.surface.resize(solid.triangles.size(), -1);
}

Solid of_file(Evaluation& e, std::uint32_t node) {
  const std::filesystem::path path = file_of(e, node);
  const std::string suffix = suffix_of(path);
  if (suffix == ".nef3") {
    throw InputError("is a polyhedron that CGAL wrote for itself; export it as OFF or STL",
                     path.string());
  }
  if (suffix != ".amf" && suffix != ".stl" && suffix != ".off" && suffix != ".3mf") {
    tell(e, node, "openscad.unknown_format",
         path.string() + ": no format that import() reads; it is left out, as OpenSCAD does");
    return {};
  }
  const MeshFile file = suffix == ".amf" ? read_amf(path, e.run) : read_mesh_file(path, e.run);
  e.diagnostics.append(file.diagnostics);
  Solid solid;
  for (const PolygonSoup& object : file.objects) {
    try {
      append(solid, repair(object, {}, e.diagnostics, e.run));
    } catch (const GeometryError& error) {
      tell(e, node, "openscad.empty_import", path.string() + ": " + error.what());
    }
  }
  return solid;
}

}  // namespace

Solid file_solid(Evaluation& e, std::uint32_t node) {
  e.run.check();
  return at_node(e, node, [&] {
    if (e.tree.nodes[node].module == Module::Surface) return height_map(e, node);
    return if_there(e, node, [&]() -> Solid { return of_file(e, node); });
  });
}

}  // namespace burin::csg
