#pragma once
// Internal to the module.

#include <burin/forms/brep/occt/brep_model.h>
#include <burin/surface/shape_measure.h>

#include <vector>

namespace burin {

/// Integrals over the faces of a model. Throws GeometryError where OCCT cannot integrate.
ShapeMeasure brep_measure(const BrepModel& model);
/// Over the splines that the faces become where they are stretched or sheared.
ShapeMeasure brep_measure(const BrepModel& model, const Placement& placement);
/// Over those of bodies where they stand.
ShapeMeasure brep_measure(const std::vector<BrepBody>& bodies);

}  // namespace burin
