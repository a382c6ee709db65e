#include "shape_in_memory.h"

#include <burin/base/error.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>

#include "collect.h"
#include "colors.h"
#include "measure.h"
#include "occt_session.h"
#include "trimmed_face.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>

#include <sstream>
#include <utility>

namespace burin {
namespace {

class ShapeInMemory final : public BrepShape {
 public:
  ShapeInMemory(std::shared_ptr<const BrepModel> model, const Placement& own)
      : model_(std::move(model)), own_(own) {}

  const Placement& own() const override { return own_; }
  std::shared_ptr<const Form> form(const Placement& placement) const override {
    return std::make_shared<BrepForm>(model_, placement);
  }
  PartInfo measure(const Placement& placement) const override {
    const OcctSession session(OcctSession::Of::Shapes);
    PartInfo info;
    session.guarded({}, [&] { info = burin::measure(*model_, placement); });
    return info;
  }
  std::vector<double> face_areas() const override {
    const OcctSession session(OcctSession::Of::Shapes);
    std::vector<double> areas;
    session.guarded({}, [&] { areas = burin::face_areas(model_->shape()); });
    return areas;
  }
  bool valid() const override {
    const OcctSession session(OcctSession::Of::Shapes);
    bool valid = false;
    try {
      session.guarded({}, [&] { valid = BRepCheck_Analyzer(model_->shape()).IsValid(); });
    } catch (const InputError&) {  // the check itself crashed
      return false;
    }
    return valid;
  }

 private:
  std::shared_ptr<const BrepModel> model_;
  Placement own_;
};

/// A set of shapes, then which of them it is, its location and its orientation.
TopoDS_Shape read_freecad_binary(std::istream& in) {
  BinTools_ShapeSet set;
  set.Read(in);
  Standard_Integer shape = 0, location = 0, orientation = 0;
  BinTools::GetInteger(in, shape);
  BinTools::GetInteger(in, location);
  BinTools::GetInteger(in, orientation);
  if (shape < 1 || shape > set.NbShapes() || location < 0 ||
      location > set.Locations().NbLocations() || orientation < TopAbs_FORWARD ||
      orientation > TopAbs_EXTERNAL) {
    return {};
  }
  TopoDS_Shape found = set.Shape(shape);
  if (found.IsNull()) return found;
  found.Location(set.Locations().Location(location));
  found.Orientation(static_cast<TopAbs_Orientation>(orientation));
  return found;
}

TopoDS_Shape parsed(std::istream& in, BrepBytes kind, const std::string& bytes) {
  TopoDS_Shape shape;
  // OCCT's own binary form begins with "\nOpen CASCADE Topology V".
  if (kind == BrepBytes::FreecadBinary) return read_freecad_binary(in);
  if (bytes.substr(0, 64).find("Open CASCADE Topology") != std::string::npos) {
    BinTools::Read(shape, in);
  } else {
    BRepTools::Read(shape, in, BRep_Builder());
  }
  return shape;
}

}  // namespace

std::shared_ptr<const BrepShape> read_shape_in_memory(const std::string& bytes, BrepBytes kind,
                                                      RunContext& context) {
  // As for files: OCCT tells the program's standard output of tables that are missing.
  const OcctSession session;
  std::shared_ptr<const BrepShape> read_shape;
  session.guarded({}, [&] {
    std::istringstream in(bytes);
    // OCCT's readers loop for ever where a number is missing; an exception ends them.
    in.exceptions(std::ios::failbit | std::ios::badbit);
    TopoDS_Shape shape;
    try {
      shape = parsed(in, kind, bytes);
    } catch (const std::ios_base::failure&) {
      throw InputError("the BREP data is broken or ends early");
    }
    context.check();
    if (shape.IsNull()) throw InputError("the BREP data is broken or holds no shape");
    read_shape = std::make_shared<ShapeInMemory>(make_brep_model(shape.Located(TopLoc_Location())),
                                                 placement_of(shape.Location()));
  });
  return read_shape;
}

std::shared_ptr<const BrepShape> read_text_in_memory(const std::string& brep, RunContext& context) {
  const OcctSession session(OcctSession::Of::Shapes);
  std::shared_ptr<const BrepShape> shape;
  session.guarded({}, [&] {
    shape = std::make_shared<ShapeInMemory>(brep_from_text(brep), Placement{});
    context.check();
  });
  return shape;
}

std::shared_ptr<const BrepShape> trimmed_faces_in_memory(
    const std::vector<TrimmedSurface>& surfaces, double weld, const std::string& file,
    const RunContext& context) {
  const OcctSession session(OcctSession::Of::Shapes);
  std::shared_ptr<const BrepShape> shape;
  session.guarded(file, [&] {
    const FaceMaker maker{file, context};
    std::vector<TopoDS_Shape> faces;
    for (const TrimmedSurface& surface : surfaces) {
      context.check();
      for (const TopoDS_Face& face : maker.faces_of(surface)) faces.push_back(face);
    }
    const TopoDS_Shape joined = sew(faces, weld)->SewedShape();
    context.check();
    shape = std::make_shared<ShapeInMemory>(make_brep_model(joined), Placement{});
  });
  return shape;
}

}  // namespace burin
