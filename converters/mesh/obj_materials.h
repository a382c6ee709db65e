#pragma once
/// The colours of the materials of OBJ files.

#include <burin/base/diagnostics.h>

#include "look.h"
#include "source.h"

#include <map>
#include <optional>
#include <span>
#include <string>

namespace burin {

/// By name; nothing where a material has no colour of its own, but a picture or a spectrum.
using ObjMaterials = std::map<std::string, std::optional<Rgba>>;

/// Reads the material libraries (MTL) that lines of `obj` name, from its folder: diffuse colour and
/// opacity. Those that are not there are told.
ObjMaterials read_obj_materials(std::span<const std::string> libraries, const Source& obj,
                                Diagnostics& diagnostics);

}  // namespace burin
