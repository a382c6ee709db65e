#include "mesher.h"

#include <burin/base/parallel.h>

#include "charts/spline_nodes.h"
#include "contain.h"
#include "occt_vec.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeFix_Face.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <array>
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
#ifdef BURIN_THREAD_SANITIZER
  p.InParallel = false;  // it does not see what orders OCCT's own tasks
#else
  p.InParallel = true;
#endif
  p.ControlSurfaceDeflection = false;  // see refine.h
  contained([&] {
    const Handle(Indicator) indicator = new Indicator(context);
    BRepMesh_IncrementalMesh mesher;
    mesher.SetShape(shape);
    mesher.ChangeParameters() = p;
    mesher.Perform(mesher_context(), indicator->Start());
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

std::vector<std::int32_t> without_triangles(const ModelParts& parts) {
  std::vector<std::int32_t> out;
  for (std::size_t f = 0; f < parts.faces.size(); ++f) {
    if (parts.faces[f].chart && !meshed(parts.faces[f].face))
      out.push_back(static_cast<std::int32_t>(f));
  }
  return out;
}

const TopoDS_Face& face_of(const ModelParts& parts, std::int32_t f) {
  return parts.faces[static_cast<std::size_t>(f)].face;
}

TopoDS_Shape meshable(const ModelParts& parts) {
  if (std::ranges::all_of(parts.faces, &ModelFace::meshable)) {
    return parts.shape;
  }
  TopoDS_Compound faces;
  const BRep_Builder builder;
  builder.MakeCompound(faces);
  for (const ModelFace& f : parts.faces) {
    if (f.meshable) builder.Add(faces, f.face);
  }
  return faces;
}

/// Whether one of the faces, on its own, can be meshed with these.
bool helps(const ModelParts& parts, const std::vector<std::int32_t>& faces, double deflection,
           double min_size, RunContext& context) {
  for (const std::int32_t f : faces) {
    if (!parts.faces[static_cast<std::size_t>(f)].chart) continue;
    bool done = false;
    contained([&] {
      const TopoDS_Shape copy = BRepBuilderAPI_Copy(face_of(parts, f), false, false).Shape();
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

std::vector<std::int32_t> mesh_shape(ModelParts& parts, double tolerance, RunContext& context) {
  // Neighbours must have the same nodes on their edges: where a face fails, all is meshed again,
  // coarser or finer, not the face alone.
  struct Attempt {
    double deflection, min_size;
  };
  const TopoDS_Shape shape = meshable(parts);
  const auto attempt = [&](const Attempt& a) {
    clear_mesh(parts);
    run_mesher(shape, a.deflection * tolerance, a.min_size * tolerance, context);
    return without_triangles(parts);
  };
  const Attempt first{kCoarser, kMinSize};
  const std::vector<std::int32_t> missing = attempt(first);
  if (missing.empty()) return {};
  Attempt best = first;
  std::size_t fewest = missing.size();
  for (const Attempt& a : {Attempt{8, 8 * kMinSize}, Attempt{0.25, 0.25 * kMinSize}}) {
    if (!helps(parts, missing, a.deflection * tolerance, a.min_size * tolerance, context)) continue;
    const std::size_t n = attempt(a).size();
    if (n == 0) return {};
    if (n < fewest) {
      fewest = n;
      best = a;
    }
  }
  return attempt(best);
}

LooseTriangles triangles_on(const TopoDS_Face& face, std::int32_t number) {
  LooseTriangles out;
  TopLoc_Location location;
  const Handle(Poly_Triangulation) t = BRep_Tool::Triangulation(face, location);
  if (t.IsNull()) return out;
  for (int i = 1; i <= t->NbNodes(); ++i) {
    out.positions.push_back(to_vec(t->Node(i).Transformed(location.Transformation())));
  }
  for (int i = 1; i <= t->NbTriangles(); ++i) {
    std::array<int, 3> n{};
    t->Triangle(i).Get(n[0], n[1], n[2]);
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(n[k] - 1);
    out.triangles.push_back(corners);
    out.face.push_back(number);
  }
  return out;
}

LooseTriangles mesh_alone(const ModelParts& parts, std::int32_t face, double tolerance,
                          RunContext& context) {
  if (!parts.faces[static_cast<std::size_t>(face)].meshable) return {};
  // The finest comes first. Mending may change the face, so it works on a copy of the geometry.
  for (const bool mend : {false, true}) {
    for (const double coarser : {1.0, 4.0, 16.0, 64.0}) {
      LooseTriangles found;
      contained([&] {
        TopoDS_Face copy =
            TopoDS::Face(BRepBuilderAPI_Copy(face_of(parts, face), mend, false).Shape());
        if (mend) {
          ShapeFix_Face fix(copy);
          fix.Perform();
          fix.FixOrientation();
          copy = fix.Face();
        }
        run_mesher(copy, coarser * tolerance, kMinSize * coarser * tolerance, context);
        if (meshed(copy)) found = triangles_on(copy, face);
      });
      if (!found.empty()) return found;
    }
  }
  return {};
}

}  // namespace burin
