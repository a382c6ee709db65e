#pragma once
/// Wires that go round a periodic surface more often than their face does.

#include <TopoDS_Shape.hxx>

namespace burin {

/// OCCT's reader takes the circles at both ends of a fillet round a pin for lines of different
/// turns of the surface where the file says no curves in it, and joins the turns by edges that it
/// calls points though they lead once round, or by none: the face is then covered twice, or not at
/// all. Those edges are taken out, and curves are moved by whole turns so that each begins where
/// the one before ends. A face whose wires do not close then stays as it is. `shape` is one's own:
/// its edges are changed; the faces keep their order. Cost: that of looking at both ends of the
/// edges of faces that come again.
TopoDS_Shape unroll_wires(const TopoDS_Shape& shape);

}  // namespace burin
