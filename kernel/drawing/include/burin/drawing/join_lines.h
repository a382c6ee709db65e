#pragma once
/// Lines that go on in others.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include <vector>

namespace burin {

/// Joins open lines of one part, layer and width whose ends meet two by two, on paper and in the
/// model: straight ones that go on straight, and dashed ones that go on without a corner, so that
/// dashes run on. What is joined has the kind and source of its longest piece and names the others
/// as `Path::also`; it stands where the first of its pieces stood. Strokes are left alone. Throws
/// Cancelled. Cost: 2 us a line.
void join_lines(std::vector<Layer>& layers, const RunContext& context);

}  // namespace burin
