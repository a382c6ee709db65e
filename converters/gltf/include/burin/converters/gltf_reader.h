#pragma once
/// glTF 2.0: scenes of meshes, as text (.gltf) and binary (.glb).

#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <string_view>

namespace burin {

/// Whether the first bytes of a file can only be those of a glTF.
bool is_gltf_content(std::string_view head);
/// Whether the suffix (any case) is .gltf or .glb.
bool is_gltf_suffix(const std::filesystem::path& path);

/// The meshes of a file in mm, z up, each once, and where the nodes of its scene put them, with
/// names and colours. Animations stand still, as the nodes have it. Reads the files beside it that
/// it names. Throws InputError: what is damaged, and what needs an extension that is not read, such
/// as compressed meshes. Cost: 0.2 s a million triangles.
MeshFile read_gltf_file(const std::filesystem::path& path, const RunContext& context);

/// Reads and repairs, as `read_mesh`.
Scene read_gltf(const std::filesystem::path& path, const RunContext& context,
                Facets facets = Facets::Kept);

/// What `burin info` prints.
FileInfo inspect_gltf(const std::filesystem::path& path, RunContext& context);

}  // namespace burin
