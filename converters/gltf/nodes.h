#pragma once
// The nodes of a glTF's scene as parts; internal to the module.

#include <burin/converters/mesh_reader.h>

#include "source.h"

#include <tiny_gltf.h>

namespace burin::gltf {

/// What the scene that is shown first holds. Throws InputError.
MeshFile parts_of(const tinygltf::Model& model, const Source& source);

}  // namespace burin::gltf
