#include "collect.h"
#include "numbered_names.h"

#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <fmt/format.h>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

// Share of the size of free faces within which their borders are taken for one edge: programs that
// write faces alone keep their borders together to about a hundredth of a mm in a metre.
constexpr double kSewing = 1e-5;

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

/// Bodies of one kind, counted.
void append(std::vector<CadBody>& bodies, const std::vector<TopoDS_Shape>& shapes,
            const char* kind) {
  int n = 0;
  for (const TopoDS_Shape& shape : shapes) {
    bodies.push_back({fmt::format("{} {}", kind, ++n), shape});
  }
}

/// What faces sew into: shells, and faces that fit to no other.
std::vector<CadBody> sewn(const std::vector<TopoDS_Shape>& faces) {
  const Handle(BRepBuilderAPI_Sewing) sewing = sew(faces, kSewing);
  TopTools_IndexedDataMapOfShapeShape before;
  for (const TopoDS_Shape& face : faces) {
    const TopoDS_Shape now = sewing->IsModified(face) ? sewing->Modified(face) : face;
    for (TopExp_Explorer it(now, TopAbs_FACE); it.More(); it.Next()) {
      before.Add(it.Current(), face);
    }
  }
  std::vector<CadBody> bodies;
  const auto take = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum outside) {
    for (const TopoDS_Shape& shape : all(sewing->SewedShape(), kind, outside)) {
      bodies.push_back({"", shape});
      for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Shape* face = before.Seek(it.Current());
        if (face != nullptr) bodies.back().sewn_from.push_back(*face);
      }
    }
  };
  take(TopAbs_SHELL, TopAbs_SOLID);
  take(TopAbs_FACE, TopAbs_SHELL);
  return bodies;
}

/// The faces outside shells, sewn where they meet.
std::vector<CadBody> free_faces(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces = all(shape, TopAbs_FACE, TopAbs_SHELL);
  std::vector<CadBody> bodies;
  if (TopoDS_Compound bare = take_bare(faces); !bare.IsNull()) bodies.push_back({"", bare});
  if (faces.size() == 1) bodies.push_back({"", faces.front()});
  if (faces.size() < 2) return bodies;
  for (CadBody& body : sewn(faces)) bodies.push_back(std::move(body));
  return bodies;
}

}  // namespace

Placement placement_of(const TopLoc_Location& location) {
  const gp_Trsf t = location.Transformation();
  Placement p;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) p.linear[column][row] = t.Value(row + 1, column + 1);
    p.offset[row] = t.Value(row + 1, 4);
  }
  return p;
}

Handle(BRepBuilderAPI_Sewing) sew(const std::vector<TopoDS_Shape>& faces, double share) {
  Bnd_Box box;
  for (const TopoDS_Shape& face : faces) BRepBndLib::Add(face, box);
  Handle(BRepBuilderAPI_Sewing) sewing =
      new BRepBuilderAPI_Sewing(share * (box.IsVoid() ? 1.0 : std::sqrt(box.SquareExtent())));
  for (const TopoDS_Shape& face : faces) sewing->Add(face);
  sewing->Perform();
  return sewing;
}

std::vector<CadBody> bodies_of(const TopoDS_Shape& shape) {
  std::vector<CadBody> bodies;
  append(bodies, all(shape, TopAbs_SOLID, TopAbs_SHAPE), "solid");
  append(bodies, all(shape, TopAbs_SHELL, TopAbs_SOLID), "shell");
  int n = 0;
  for (CadBody& body : free_faces(shape)) {
    body.name = fmt::format("surface {}", ++n);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

Loose count_loose(const TopoDS_Shape& shape) {
  const auto count = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum outside) {
    std::int64_t n = 0;
    for (TopExp_Explorer it(shape, kind, outside); it.More(); it.Next()) ++n;
    return n;
  };
  return {count(TopAbs_WIRE, TopAbs_FACE) + count(TopAbs_EDGE, TopAbs_WIRE),
          count(TopAbs_VERTEX, TopAbs_EDGE)};
}

void report_left_out(const std::vector<CadPart>& parts, const Loose& loose,
                     const std::string& first, Diagnostics& diagnostics) {
  if (loose.count() == 0 || parts.empty()) return;
  // Curves may be what somebody drew.
  const Severity severity = loose.curves > 0 ? Severity::Warning : Severity::Info;
  diagnostics.add(
      severity, "cad.no_faces", loose.count(),
      fmt::format("curves, points and notes, which have no faces, were left out; the first "
                  "of them are in '{}'",
                  first));
}

CadPart make_part(std::vector<CadBody> bodies, const std::string& name) {
  CadPart part;
  part.name = name;
  part.colors.resize(bodies.size());
  part.bodies = std::make_shared<const std::vector<CadBody>>(std::move(bodies));
  return part;
}

Appearance CadPart::color() const {
  const auto same = [&](const Appearance& color) { return color == colors.front(); };
  return std::ranges::all_of(colors, same) ? colors.front() : Appearance{};
}

namespace {

/// `whole`: the opacity of what has the faces.
CadPaint paint_of(const std::vector<std::string>& color, const std::vector<double>& area,
                  double whole) {
  PaintedFaces painted = painted_faces(color, area);
  CadPaint out{look_of(painted.color), std::move(painted.faces)};
  if (out.look.opacity >= 1) out.look.opacity = whole;
  return out;
}

}  // namespace

CadPaint CadPart::painted(const std::vector<std::size_t>& of) const {
  const Appearance whole = color();
  if (!faces) return {whole, {}};
  std::vector<std::string> texts;
  std::vector<double> area;
  for (const std::size_t i : of) {
    const CadFaces& one = (*faces)[i];
    for (const Appearance& own : one.color) {
      texts.push_back(color_text(own.color.empty() ? colors[i] : own, whole.opacity));
    }
    area.insert(area.end(), one.area.begin(), one.area.end());
  }
  return paint_of(texts, area, whole.opacity);
}

CadPaint CadPart::painted(const std::vector<std::size_t>& of, std::size_t only) const {
  const Appearance& whole = colors[of[only]];
  if (!faces) return {whole, {}};
  const CadFaces& own = (*faces)[of[only]];
  const auto as_first = [&](const Appearance& one) { return one == own.color.front(); };
  if (std::ranges::all_of(own.color, as_first)) {
    const bool none = own.color.empty() || own.color.front().color.empty();
    return {none ? whole : own.color.front(), {}};
  }
  std::size_t before = 0;
  for (std::size_t i = 0; i < only; ++i) before += (*faces)[of[i]].color.size();
  std::vector<std::string> texts(before);
  std::vector<double> area(before, 0);
  for (const Appearance& one : own.color) {
    texts.push_back(color_text(one.color.empty() ? whole : one, whole.opacity));
  }
  area.insert(area.end(), own.area.begin(), own.area.end());
  return paint_of(texts, area, whole.opacity);
}

void make_names_unique(std::vector<CadPart>& parts) {
  NumberedNames names;
  for (CadPart& part : parts) part.name = names.name(part.assembly, part.name);
}

}  // namespace burin
