#pragma once
// From an evaluated solid to a form; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/recognised/turned_surface.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/scene.h>

#include "solid.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace burin::detail {

/// Repairs what was worked out. Rounded corners fall together and solids touch along edges: of a
/// program that is right nobody has to hear so. `name`: what the rest is said of; may be empty.
/// `surfaces`: becomes Solid::surface of the triangles of the mesh.
TriMesh repaired(const csg::Solid& solid, const std::string& name, Diagnostics& diagnostics,
                 const RunContext& context, std::vector<std::int32_t>* surfaces = nullptr);

PolygonSoup soup_of(const csg::Solid& solid);

/// How facets are drawn: as they are; as what they are known to stand for; and those of which
/// nothing is known, as what they seem to.
enum class Facets : std::uint8_t { Flat, Known, Judged };

/// A form of a solid that is not empty: one whose facets are drawn as the surfaces that they stand
/// for, which is told of `name`; a mesh where there are none. Throws
/// GeometryError where nothing of it is left once it is rounded to doubles.
std::shared_ptr<const Form> form_of(csg::Solid solid, Facets facets, const std::string& name,
                                    Diagnostics& diagnostics, const RunContext& context);

}  // namespace burin::detail
