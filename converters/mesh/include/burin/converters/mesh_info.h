#pragma once
/// What `burin info` prints about a mesh file.

#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <string>

namespace burin {

/// Reads, repairs and measures. Throws InputError as `read_mesh_file` does. Cost: about
/// 2 s of processor time per million triangles.
FileInfo inspect_mesh(const std::filesystem::path& path, RunContext& context,
                      const std::string& encoding = {});

/// The same of what another reader of meshes read.
FileInfo inspect_mesh_file(MeshFile file, const std::filesystem::path& path, RunContext& context);

/// Counts and measures of a part that `repair_parts` made.
PartInfo measure_mesh_part(const Part& part, RunContext& context);
/// The same of all parts, each shared form once.
void measure_mesh_parts(const Scene& scene, FileInfo& info, RunContext& context);
/// Adds the diagnostic of parts whose triangles cross each other.
void report_self_intersections(FileInfo& info);

}  // namespace burin
