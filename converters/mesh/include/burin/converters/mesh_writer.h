#pragma once
/// Triangle meshes as files.

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A kind of mesh file: one row of the catalogue.
struct MeshWriter {
  /// The suffix without its dot.
  std::string_view name;
  std::string_view meaning;
  void (*write)(const TriMesh&, std::ostream&, const RunContext&) = nullptr;
};

/// The format of a suffix or name in any case; null where there is none. STL (binary, single
/// precision), OFF (text, digits that read back as the same doubles), 3MF (millimetres, one
/// object).
const MeshWriter* mesh_writer_named(std::string_view name);

}  // namespace burin
