#pragma once
/// What a BrepModel is made of.

#include <burin/base/box.h>
#include <burin/forms/brep/occt/brep_model.h>

#include "charts/pcurve.h"

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace burin {

struct ModelFace {
  TopoDS_Face face;
  std::shared_ptr<const Chart> chart;
  /// Its coedges, from `first_coedge` to that of the next face.
  std::int32_t first_coedge = 0;
  bool reversed = false;
  /// Without a surface OCCT's mesher follows a null pointer; of poles that are no numbers, and of
  /// edges far beyond the surface, it makes nodes without end.
  bool meshable = true;
  /// The triangles that the shape came with where it has no surface, or no chart that works; turned
  /// like the forward face.
  LooseTriangles given;
};

struct ModelEdge {
  TopoDS_Edge edge;  // forward
  /// At the start and at the end; -1 where it has none.
  std::array<std::int32_t, 2> vertex{-1, -1};
  double first = 0, last = 0;
  /// Null where the edge is a point (`degenerate`) or known in faces alone.
  Handle(Geom_Curve) curve;
  bool degenerate = false;
  std::vector<std::int32_t> coedges;
};

struct ModelCoedge {
  std::int32_t edge = -1, face = -1;
  TopoDS_Edge use;  // as the forward face uses it
  bool reversed = false;
  /// Both its sides are this face.
  bool internal = false;
  Pcurve curve;
};

struct ModelParts {
  TopoDS_Shape shape;
  std::vector<ModelFace> faces;
  std::vector<ModelEdge> edges;
  std::vector<ModelCoedge> coedges;
  std::vector<Vec3> vertices;
  /// Faces of each solid, and of each shell outside solids.
  std::vector<std::vector<std::int32_t>> bodies;
  std::vector<ModelEdgeClass> edge_class;
  /// Roughly, from vertices and edges: what is near and far before there are triangles.
  double size = 0;
};

/// Faces, edges and their curves of a shape; mends what costs little: missing curves of edges in
/// space or in faces, parameters that differ. Faces get a chart where theirs can be evaluated, else
/// the triangles that `original`, of the same structure, has on them.
void collect_parts(ModelParts& parts, const TopoDS_Shape& original, const ChartMaker& make_chart);

/// Turns faces so that neighbours agree, where the file has them otherwise.
void orient_faces(ModelParts& parts);

/// Sharp, smooth, seam or boundary, from the exact normals along each edge.
std::vector<ModelEdgeClass> classify_edges(const ModelParts& parts);

}  // namespace burin
