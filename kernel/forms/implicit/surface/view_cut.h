#pragma once
// Triangles of an implicit surface cut along the contours of a view.

#include <burin/camera/camera.h>

#include "../mesher/exact_mesh.h"

namespace burin {

/// Puts vertices on the exact contour (f = 0 and g = 0, g as in FacingFunction) wherever g changes
/// its sign along an edge, and cuts the triangles there: afterwards none has corners of both signs.
/// Chords of the contour are halved until they are within `chord` paper mm of it. On creases each
/// side has a contour of its own. @cite Benard2019
void cut_for_view(ExactMesh& mesh, const ImplicitFunction& f, const Camera& camera, double chord,
                  const RunContext& context);

}  // namespace burin
