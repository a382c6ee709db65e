#pragma once
// Arrows as parts of the scene; internal to the module.

#include <burin/arrange/illustration.h>
#include <burin/explode/step.h>
#include <burin/surface/scene.h>

#include <vector>

namespace burin::detail {

/// Adds a part for each arrow that is asked for, of `arrows` and of `steps` read backwards, once
/// all parts are where they are drawn. Throws UsageError where a row names parts that are not
/// drawn.
void add_arrows(Scene& scene, Illustration& illustration, const std::vector<ExplodeStep>& steps);

}  // namespace burin::detail
