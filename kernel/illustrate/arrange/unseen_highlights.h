#pragma once
// Parts that were to stand out and are not seen; internal to the module.

#include <burin/arrange/illustration.h>
#include <burin/drawing/drawing.h>
#include <burin/surface/scene.h>

namespace burin::detail {

/// Reports each highlight of whose parts nothing is drawn in any view, not even dashed.
void report_unseen_highlights(const Scene& scene, const Illustration& illustration,
                              Drawing& drawing);

}  // namespace burin::detail
