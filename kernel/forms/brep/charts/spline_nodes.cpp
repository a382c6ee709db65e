#include "spline_nodes.h"

#include <BRepMesh_Context.hxx>
#include <BRepMesh_DelaunayBaseMeshAlgo.hxx>
#include <BRepMesh_DelaunayDeflectionControlMeshAlgo.hxx>
#include <BRepMesh_FaceDiscret.hxx>
#include <BRepMesh_MeshAlgoFactory.hxx>
#include <BRepMesh_NURBSRangeSplitter.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {
namespace {

/// Nodes inside a face: some 60 lines each way.
constexpr double kMostNodes = 4'000;

/// Where a parameter comes in the order of all.
std::size_t rank(const std::vector<double>& sorted, double x) {
  return static_cast<std::size_t>(std::ranges::lower_bound(sorted, x) - sorted.begin());
}

std::vector<double> parameters(const IMeshData::ListOfPnt2d& nodes, int coordinate) {
  std::vector<double> out;
  for (const gp_Pnt2d& p : nodes) out.push_back(p.Coord(coordinate));
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Every so many-th line of the nodes' grid alone, where they are too many.
class ThinnedSplitter final : public BRepMesh_NURBSRangeSplitter {
 public:
  Handle(IMeshData::ListOfPnt2d)
      GenerateSurfaceNodes(const IMeshTools_Parameters& parameters_of_mesh) const override {
    Handle(IMeshData::ListOfPnt2d) nodes =
        BRepMesh_NURBSRangeSplitter::GenerateSurfaceNodes(parameters_of_mesh);
    if (nodes.IsNull() || nodes->Size() <= kMostNodes) return nodes;
    const std::vector<double> u = parameters(*nodes, 1), v = parameters(*nodes, 2);
    const auto stride = static_cast<std::size_t>(std::ceil(std::sqrt(nodes->Size() / kMostNodes)));
    Handle(IMeshData::ListOfPnt2d) kept = new IMeshData::ListOfPnt2d;
    for (const gp_Pnt2d& p : *nodes) {
      const bool line_u = rank(u, p.X()) % stride == stride / 2;
      if (line_u && rank(v, p.Y()) % stride == stride / 2) kept->Append(p);
    }
    return kept;
  }
};

class Algorithms final : public BRepMesh_MeshAlgoFactory {
 public:
  Handle(IMeshTools_MeshAlgo)
      GetAlgo(const GeomAbs_SurfaceType type, const IMeshTools_Parameters& options) const override {
    using Spline =
        BRepMesh_DelaunayDeflectionControlMeshAlgo<ThinnedSplitter, BRepMesh_DelaunayBaseMeshAlgo>;
    if (type == GeomAbs_BSplineSurface) return new Spline;
    return BRepMesh_MeshAlgoFactory::GetAlgo(type, options);
  }
};

}  // namespace

Handle(IMeshTools_Context) mesher_context() {
  Handle(BRepMesh_Context) context = new BRepMesh_Context;
  context->SetFaceDiscret(new BRepMesh_FaceDiscret(new Algorithms));
  return context;
}

}  // namespace burin
