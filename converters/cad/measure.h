#pragma once

#include <burin/converters/file_info.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/forms/charted/chart.h>

#include <vector>

namespace burin {

/// Counts and measures of a model in its place, by integration over the exact surfaces; what OCCT
/// cannot integrate is 0.
PartInfo measure(const BrepModel& model, const Placement& placement);
/// Of the bodies of one part together.
PartInfo measure(const std::vector<BrepBody>& bodies, const Placement& placement);

}  // namespace burin
