#pragma once
// What is done to the lines of one part once all of them are known.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>

#include <vector>

namespace burin {

/// Joins open contours of one smooth region and one source end to end where exactly two of them
/// meet and their open sides agree; turns them round where needed. The rest keeps its order.
void join_contours(std::vector<Curve3>& curves);

/// Leaves out creases of less than kSpeckLength with an end that no other line touches.
void drop_specks(std::vector<Curve3>& curves, const Camera& camera);

}  // namespace burin
