#include "mesher.h"

#include <burin/base/parallel.h>

#include "contain.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Message_ProgressIndicator.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <thread>
#include <vector>

namespace burin {
namespace {

/// Radians between neighbouring segments of an edge's polygon: a circle has 12 at the least,
/// however small.
constexpr double kAngle = 0.5;

/// The mesher leaves the last two halvings to `refine`, which is faster; its time
/// grows faster than its triangles.
constexpr double kCoarser = 4;
/// Edges of triangles that the mesher may leave out, a share of the tolerance.
constexpr double kMinSize = 0.1;

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

void run_mesher(const TopoDS_Shape& shape, double deflection, double min_size,
                RunContext& context) {
  IMeshTools_Parameters p;  // and not Delabella's algorithm, which crashes on some faces
  p.Deflection = deflection;
  p.MinSize = min_size;
  p.Angle = kAngle;
  p.InParallel = true;
  p.ControlSurfaceDeflection = false;  // see refine.h
  contained([&] {
    const Handle(Indicator) indicator = new Indicator(context);
    BRepMesh_IncrementalMesh(shape, p, indicator->Start());
  });
  context.check();
}

/// Whether a face has its triangles. Any triangulation of n nodes inside one outline has at least
/// n - 2; fewer are a part of the face (some nodes may coincide).
bool meshed(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation)& t = BRep_Tool::Triangulation(face, location);
  return !t.IsNull() && t->NbTriangles() > 0 && t->NbTriangles() >= 0.9 * t->NbNodes() - 3;
}

std::vector<TopoDS_Face> without_triangles(const ModelParts& parts) {
  std::vector<TopoDS_Face> out;
  for (const ModelFace& f : parts.faces) {
    if (f.chart && !meshed(f.face)) out.push_back(f.face);
  }
  return out;
}

/// Whether one of the faces, on its own, can be meshed with these.
bool helps(const std::vector<TopoDS_Face>& faces, double deflection, double min_size,
           RunContext& context) {
  for (const TopoDS_Face& f : faces) {
    bool done = false;
    contained([&] {
      const TopoDS_Shape copy = BRepBuilderAPI_Copy(f, false, false).Shape();
      run_mesher(copy, deflection, min_size, context);
      done = meshed(TopoDS::Face(copy));
    });
    if (done) return true;
  }
  return false;
}

}  // namespace

void clear_mesh(ModelParts& parts) {
  contained([&] { BRepTools::Clean(parts.shape); });
}

void mesh_shape(ModelParts& parts, double tolerance, RunContext& context) {
  // Neighbours must have the same nodes on their edges: where a face fails, all is meshed again,
  // coarser or finer, not the face alone.
  struct Attempt {
    double deflection, min_size;
  };
  const auto attempt = [&](const Attempt& a) {
    clear_mesh(parts);
    run_mesher(parts.shape, a.deflection * tolerance, a.min_size * tolerance, context);
    return without_triangles(parts);
  };
  const Attempt first{kCoarser, kMinSize};
  const std::vector<TopoDS_Face> missing = attempt(first);
  if (missing.empty()) return;
  Attempt best = first;
  std::size_t fewest = missing.size();
  for (const Attempt& a : {Attempt{8, 8 * kMinSize}, Attempt{0.25, 0.25 * kMinSize}}) {
    if (!helps(missing, a.deflection * tolerance, a.min_size * tolerance, context)) continue;
    const std::size_t n = attempt(a).size();
    if (n == 0) return;
    if (n < fewest) {
      fewest = n;
      best = a;
    }
  }
  attempt(best);
}

}  // namespace burin
