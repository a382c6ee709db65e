#pragma once
/// The sample models, one function each. What each shows stands in samples/README.md.

#include "kit.h"

namespace burin::samples {

std::vector<Solid> spindle();
std::vector<Solid> vase();
std::vector<Solid> bracket();
std::vector<Solid> gear();
std::vector<Solid> bolt();
std::vector<Solid> spring();
std::vector<Solid> bearing_stand();
std::vector<Solid> blob(double cell);
std::vector<Solid> teapot();
std::vector<Solid> gyroid();
/// A carved head; `noise` is the standard deviation of the scanner in mm, 0 = none.
std::vector<Solid> moai(double cell, double noise);
/// A trefoil knot of about 2 * along * around triangles.
std::vector<Solid> knot(int along, int around);

/// The thread of a bolt as a surface from z = 0 to `length`, open at both ends; both end circles
/// have `segments` points on `core` radius. The thread fades over one pitch at either end.
std::vector<Loop> thread_rows(double major, double core, double pitch, double length, int segments);

}  // namespace burin::samples
