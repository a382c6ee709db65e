#pragma once
/// How many nodes OCCT's mesher puts inside faces of splines.

#include <IMeshTools_Context.hxx>

namespace burin {

/// What the mesher is to work with: its own algorithms, but for splines of very many spans, inside
/// which it would put a node at every crossing of knot lines. Its Delaunay triangulation takes
/// more than linear time and 20 kB per node; `refine` splits such faces where they bend instead.
Handle(IMeshTools_Context) mesher_context();

}  // namespace burin
