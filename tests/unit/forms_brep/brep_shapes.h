#pragma once
/// OCCT's own shapes, and what every tessellation must hold.

#include <burin/base/diagnostics.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/mesh/topology.h>

#include <TopoDS_Shape.hxx>

#include <memory>

namespace burin::test {

using ModelPtr = std::shared_ptr<const BrepModel>;

TopoDS_Shape box_shape(double dx, double dy, double dz);
TopoDS_Shape cylinder_shape(double radius, double height);
/// A box of 4 x 3 x 2 with all its edges rounded: 26 faces.
TopoDS_Shape filleted_box_shape(double radius);
/// A plate of 10 x 8 x 1 with a round hole of radius 2 through its middle.
TopoDS_Shape plate_with_hole_shape();
/// A box of 10 x 10 x 5 with the one edge at x = 10, z = 5 rounded.
TopoDS_Shape one_fillet_shape(double radius);

/// What is wrong with the triangles of a model, empty where nothing is: positions against charts
/// (within `slack` of the size), borders against coedges and both sides against each other, turned
/// triangles, topology.
std::string defects(const BrepModel& model, const ChartMesh& mesh, double slack = 1e-9);

double area(const ChartMesh& mesh);
double volume(const ChartMesh& mesh);
/// Vertices - edges + triangles.
int euler_characteristic(const ChartMesh& mesh);
/// Half-edges without a neighbour.
int open_half_edges(const ChartMesh& mesh);
int count_edges(const ChartMesh& mesh, ModelEdgeClass which);

}  // namespace burin::test
