#pragma once

#include <burin/converters/file_info.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/forms/charted/chart.h>

namespace burin {

/// Counts and measures of a model in its place, by integration over the exact surfaces; what OCCT
/// cannot integrate is 0.
PartInfo measure(const BrepModel& model, const Placement& placement);

}  // namespace burin
