#include <burin/converters/gltf_reader.h>

#include "../readers.h"
#include "all.h"
#include "facets.h"

namespace burin::detail {

const Reader kGltf{"glTF (.gltf, .glb)",
                   is_gltf_content,
                   is_gltf_suffix,
                   [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                     return ReadResult{read_gltf(path, c, facets_of(o))};
                   },
                   [](const std::filesystem::path& path, const ReadOptions&, RunContext& c) {
                     return inspect_gltf(path, c);
                   },
                   Meshes,
                   {},
                   nullptr,
                   true};

}  // namespace burin::detail
