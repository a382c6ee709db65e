#pragma once
/// Which parts of a scene are one thing.

#include <burin/surface/scene.h>

#include <cstddef>
#include <vector>

namespace burin {

/// For each part the first one of the thing that it belongs to (`Part::joined`): itself, where it
/// is a thing of its own.
std::vector<std::size_t> things_of(const Scene& scene);

/// One behind the last part of the thing that begins with the part at `index`.
std::size_t end_of_thing(const Scene& scene, std::size_t index);

}  // namespace burin
