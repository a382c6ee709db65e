#include "mesher.h"

#include <burin/base/parallel.h>

#include "contain.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Message_ProgressIndicator.hxx>
#include <ShapeFix_Face.hxx>
#include <TopLoc_Location.hxx>

#include <thread>

namespace burin {
namespace {

/// Radians between neighbouring segments of an edge's polygon: a circle has 12 at the least,
/// however small.
constexpr double kAngle = 0.5;

/// The mesher leaves the last two halvings to `refine`, which makes them 10 times as fast; its time
/// grows faster than its triangles.
constexpr double kCoarser = 4;

/// OCCT asks whether to go on and says how far it is; shown from the caller's thread alone.
class Indicator final : public Message_ProgressIndicator {
 public:
  explicit Indicator(RunContext& context) : context_(context) {}
  Standard_Boolean UserBreak() override { return context_.cancelled(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    if (std::this_thread::get_id() == caller_) context_.progress(GetPosition());
  }

 private:
  RunContext& context_;
  std::thread::id caller_ = std::this_thread::get_id();
};

IMeshTools_Parameters parameters(double tolerance, IMeshTools_MeshAlgoType algorithm) {
  IMeshTools_Parameters p;
  p.Deflection = kCoarser * tolerance;
  p.MinSize = IMeshTools_Parameters::RelMinSize() * tolerance;
  p.Angle = kAngle;
  p.InParallel = true;
  p.ControlSurfaceDeflection = false;  // see refine.h
  p.MeshAlgo = algorithm;
  return p;
}

void run_mesher(const TopoDS_Shape& shape, const IMeshTools_Parameters& p, RunContext& context) {
  contained([&] {
    const Handle(Indicator) indicator = new Indicator(context);
    BRepMesh_IncrementalMesh(shape, p, indicator->Start());
  });
  context.check();
}

bool meshed(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation)& t = BRep_Tool::Triangulation(face, location);
  return !t.IsNull() && t->NbTriangles() > 0;
}

/// Neighbours keep their polygons, which the face takes over where they are fine enough.
void try_again(const ModelFace& f, double tolerance, RunContext& context) {
  for (const double factor : {1.0, 4.0, 0.25}) {
    for (const auto algorithm :
         {IMeshTools_MeshAlgoType_Watson, IMeshTools_MeshAlgoType_Delabella}) {
      run_mesher(f.face, parameters(factor * tolerance, algorithm), context);
      if (meshed(f.face)) return;
    }
  }
}

}  // namespace

void clear_mesh(ModelParts& parts) {
  contained([&] { BRepTools::Clean(parts.shape); });
}

void mesh_shape(ModelParts& parts, double tolerance, RunContext& context) {
  clear_mesh(parts);
  run_mesher(parts.shape, parameters(tolerance, IMeshTools_MeshAlgoType_Watson), context);
  for (const ModelFace& f : parts.faces) {
    if (f.chart && !meshed(f.face)) try_again(f, tolerance, context);
  }
}

}  // namespace burin
