#pragma once
// AMF files, plain or zipped; for converters/openscad alone.

#include <burin/base/run_context.h>
#include <burin/converters/mesh_reader.h>

#include <filesystem>

namespace burin::csg {

/// The meshes of all objects, in the file's numbers whatever its unit, as OpenSCAD reads them.
/// Throws InputError where it is no AMF.
MeshFile read_amf(const std::filesystem::path& path, const RunContext& context);

}  // namespace burin::csg
