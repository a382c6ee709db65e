#pragma once
// What materials of a glTF look like; internal to the room.

#include <burin/base/vec.h>

#include "look.h"

#include <tiny_gltf.h>

#include <array>
#include <optional>

namespace burin::gltf {

/// Red, green, blue as shares of light (linear), and opacity.
using Linear = std::array<double, 4>;

/// The colour of a material; nothing where it has none of its own but a picture, or does not exist.
std::optional<Linear> color_of(const tinygltf::Model& model, int material);
/// The same as it is written in drawings (sRGB).
Rgba displayed(const Linear& color);

}  // namespace burin::gltf
