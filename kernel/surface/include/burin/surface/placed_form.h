#pragma once
/// A form that stands elsewhere than it was read.

#include <burin/base/placement.h>
#include <burin/surface/scene.h>

#include <memory>

namespace burin {

/// `form` turned, scaled and moved: points, normals, curvatures (divided by the scale), parameters
/// and triangles are its own, placed. The same form where the placement moves nothing. Forms may be
/// placed many times; each surface that they make holds a copy of its triangles. Throws UsageError
/// where the placement is no rotation times a scale over 0, within 1e-9.
std::shared_ptr<const Form> placed(std::shared_ptr<const Form> form, const Placement& placement);

}  // namespace burin
