#pragma once
// FreeCAD's binary mesh; internal to the module.

#include <burin/mesh/tri_mesh.h>

#include "source.h"

namespace burin::detail {

/// Throws InputError, also for corners that do not exist.
PolygonSoup read_bms(const Source& source);

}  // namespace burin::detail
