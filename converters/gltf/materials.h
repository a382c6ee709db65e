#pragma once
// What materials of a glTF look like; internal to the module.

#include <burin/base/vec.h>

#include "look.h"

#include <tiny_gltf.h>

#include <optional>

namespace burin::gltf {

/// The colour of a material; nothing where it has none of its own but a picture, or does not exist.
std::optional<LinearColor> color_of(const tinygltf::Model& model, int material);
}  // namespace burin::gltf
