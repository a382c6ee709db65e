#pragma once
/// Where a curve that lies on a surface passes through another sheet.

#include "probe.h"
#include "track.h"

#include <vector>

namespace burin {

struct Passage {
  double at = 0;  // parameter of the curve
  /// Whether the sheet hides the curve right before, and right after: the one where the sheet lies
  /// between it and the viewer; neither where the sheet is seen edge-on.
  bool hidden_before = false, hidden_after = false;
};

/// The passages of a stroke, ascending. A sheet that the stroke's own surface meets along an edge
/// is passed by no more than the chord errors of both, a sheet that touches its own at less than
/// the angle of a contact, or is its own, is not passed: neither counts.
std::vector<Passage> find_passages(const Probe& probe, const Curve3& curve, const Track& track);

}  // namespace burin
