#pragma once
/// What every tessellation must hold.

#include <burin/base/diagnostics.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/mesh/topology.h>

#include <burin_test/brep_shapes.h>

#include <memory>

namespace burin::test {

using ModelPtr = std::shared_ptr<const BrepModel>;

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
