#include "collect.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <fmt/format.h>
#include <gp_Trsf.hxx>

#include <cmath>
#include <map>
#include <utility>

namespace burin {
namespace {

// Share of the size of free faces within which their borders are taken for one edge: programs that
// write faces alone keep their borders together to about a hundredth of a mm in a metre.
constexpr double kSewing = 1e-5;

Placement placement_of(const TopLoc_Location& location) {
  const gp_Trsf t = location.Transformation();
  Placement p;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) p.linear[column][row] = t.Value(row + 1, column + 1);
    p.offset[row] = t.Value(row + 1, 4);
  }
  return p;
}

std::vector<TopoDS_Shape> all(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
                              TopAbs_ShapeEnum outside) {
  std::vector<TopoDS_Shape> found;
  for (TopExp_Explorer it(shape, kind, outside); it.More(); it.Next()) {
    if (TopExp_Explorer(it.Current(), TopAbs_FACE).More()) found.push_back(it.Current());
  }
  return found;
}

/// Faces that are triangles alone, without a surface, as one shape: they have no edges to sew.
TopoDS_Compound take_bare(std::vector<TopoDS_Shape>& faces) {
  TopoDS_Compound bare;
  std::erase_if(faces, [&](const TopoDS_Shape& face) {
    if (!BRep_Tool::Surface(TopoDS::Face(face)).IsNull()) return false;
    if (bare.IsNull()) BRep_Builder().MakeCompound(bare);
    BRep_Builder().Add(bare, face);
    return true;
  });
  return bare;
}

}  // namespace

TopoDS_Shape sewn(const std::vector<TopoDS_Shape>& faces, double share) {
  Bnd_Box box;
  for (const TopoDS_Shape& face : faces) BRepBndLib::Add(face, box);
  BRepBuilderAPI_Sewing sewing(share * (box.IsVoid() ? 1.0 : std::sqrt(box.SquareExtent())));
  for (const TopoDS_Shape& face : faces) sewing.Add(face);
  sewing.Perform();
  return sewing.SewedShape();
}

std::vector<TopoDS_Shape> split_shape(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> pieces = all(shape, TopAbs_SOLID, TopAbs_SHAPE);
  for (TopoDS_Shape& shell : all(shape, TopAbs_SHELL, TopAbs_SOLID)) pieces.push_back(shell);
  std::vector<TopoDS_Shape> faces = all(shape, TopAbs_FACE, TopAbs_SHELL);
  if (TopoDS_Compound bare = take_bare(faces); !bare.IsNull()) pieces.push_back(bare);
  if (faces.size() == 1) pieces.push_back(faces.front());
  if (faces.size() < 2) return pieces;
  const TopoDS_Shape joined = sewn(faces, kSewing);
  for (TopoDS_Shape& shell : all(joined, TopAbs_SHELL, TopAbs_SOLID)) pieces.push_back(shell);
  for (TopoDS_Shape& face : all(joined, TopAbs_FACE, TopAbs_SHELL)) pieces.push_back(face);
  return pieces;
}

std::int64_t count_loose(const TopoDS_Shape& shape) {
  const auto count = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum outside) {
    std::int64_t n = 0;
    for (TopExp_Explorer it(shape, kind, outside); it.More(); it.Next()) ++n;
    return n;
  };
  return count(TopAbs_WIRE, TopAbs_FACE) + count(TopAbs_EDGE, TopAbs_WIRE) +
         count(TopAbs_VERTEX, TopAbs_EDGE);
}

void tell_left_out(const std::vector<CadPart>& parts, std::int64_t count,
                   Diagnostics& diagnostics) {
  if (count == 0 || parts.empty()) return;
  diagnostics.add(Severity::Info, "cad.no_faces", count,
                  "members without any face (wires, points, notes) were left out");
}

CadPart make_part(const TopoDS_Shape& shape, const TopLoc_Location& location,
                  const std::string& name) {
  CadPart part;
  part.name = name;
  part.shape = shape.Located(TopLoc_Location());
  part.placement = placement_of(location * shape.Location());
  return part;
}

void make_names_unique(std::vector<CadPart>& parts) {
  std::map<std::pair<std::vector<std::string>, std::string>, int> seen;
  for (CadPart& part : parts) {
    const int n = ++seen[{part.assembly, part.name}];
    if (n > 1) part.name += fmt::format(" #{}", n);
  }
}

}  // namespace burin
