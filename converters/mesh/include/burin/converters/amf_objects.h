#pragma once
/// AMF files as programs read them that know no parts.

#include <burin/converters/mesh_reader.h>

#include <filesystem>

namespace burin {

/// The triangles of all objects, one soup an object, in the file's numbers whatever its unit and
/// wherever it places them: what OpenSCAD's import() takes. Throws InputError where it is no AMF.
MeshFile read_amf_objects(const std::filesystem::path& path, const RunContext& context);

}  // namespace burin
