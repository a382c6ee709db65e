#pragma once
// Lines of equal light that are drawn; internal to the module.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/feature/isophotes.h>

#include "occluders.h"
#include "part_styles.h"

#include <vector>

namespace burin::detail {

/// Where the lines of equal light run that parts are drawn with: one a part; empty where none has
/// any.
std::vector<Isophotes> drawn_isophotes(const PartStyles& part_styles, const Camera& camera);

/// The lines themselves, by part, hidden ones too. On meshes they have the normals of flat tones
/// (`light_normals`), so that they follow the shape and not the noise of its triangles. `pen`:
/// paper mm. Throws Cancelled.
std::vector<Curve3> isophote_lines(const Occluders& occluders, const Camera& camera,
                                   const std::vector<Isophotes>& isophotes, double pen,
                                   const RunContext& context);

}  // namespace burin::detail
