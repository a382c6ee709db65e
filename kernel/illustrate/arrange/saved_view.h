#pragma once
// Views that files save; internal to the module.

#include <burin/arrange/illustration.h>
#include <burin/surface/scene.h>

namespace burin::detail {

/// Turns the view of an illustration to the saved one that it names. Throws UsageError where no
/// part has that, or several views are asked for.
void take_saved_view(const Scene& scene, Illustration& illustration);

}  // namespace burin::detail
