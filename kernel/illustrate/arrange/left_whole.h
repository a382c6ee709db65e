#pragma once
// What drawings do not cut along, by custom; internal to the module.

#include <burin/surface/scene.h>

#include <optional>
#include <string>

namespace burin::detail {

/// What a part is by its name where sections leave it whole by custom (ISO 128-3): "bolt",
/// "shaft", "iso 4762"; nothing for all others. A part without a name of its own ("Solid1") goes by
/// that of what holds it.
std::optional<std::string> left_whole_by_custom(const Part& part);

}  // namespace burin::detail
