#pragma once
/// Trimming loops: closed, cut at corners and sorted by which lies in which.

#include <burin/base/run_context.h>
#include <burin/converters/trimmed_faces.h>

#include <Geom2d_BSplineCurve.hxx>

#include <string>
#include <vector>

namespace burin {

/// Curves head to tail, without corners within them.
using LoopCurves = std::vector<Handle(Geom2d_BSplineCurve)>;

/// One face: a loop that turns counter-clockwise and clockwise ones in it.
struct TrimRegion {
  LoopCurves outer;
  std::vector<LoopCurves> holes;
};

/// What lies within an odd number of the surface's loops, of which there is one at least.
std::vector<TrimRegion> trim_regions(const TrimmedSurface& trimmed, const std::string& file,
                                     const RunContext& context);

}  // namespace burin
