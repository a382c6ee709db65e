#pragma once
// From the bytes of a glTF file to its data as they stand; internal to the module.

#include "source.h"

#include <tiny_gltf.h>

namespace burin::gltf {

/// Parses the file and loads the buffers that it names. Throws InputError: damage, versions other
/// than 2, and extensions that are needed and not read.
tinygltf::Model load(const Source& source);

}  // namespace burin::gltf
