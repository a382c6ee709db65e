#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>

#include "../readers.h"
#include "all.h"
#include "facets.h"

namespace burin::detail {

const Reader kMesh{"STL, OBJ, OFF, PLY, 3MF, AMF",
                   nullptr,
                   is_mesh_suffix,
                   [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                     return ReadResult{read_mesh(path, c, facets_of(o), o.encoding)};
                   },
                   [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                     return inspect_mesh(path, c, o.encoding);
                   },
                   Meshes};

}  // namespace burin::detail
