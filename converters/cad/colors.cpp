#include "colors.h"

#include <burin/base/ascii.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <Standard_Failure.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

/// 0 where OCCT cannot tell.
double area_of(const TopoDS_Shape& face) {
  try {
    GProp_GProps sums;
    BRepGProp::SurfaceProperties(face, sums);
    return std::abs(sums.Mass());
  } catch (const Standard_Failure&) {
    return 0;
  }
}

}  // namespace

std::vector<double> face_areas(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<double> areas;
  for (int f = 1; f <= faces.Extent(); ++f) areas.push_back(area_of(faces(f)));
  return areas;
}

Appearance label_color(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label) {
  Quantity_ColorRGBA color;
  for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
    if (!tool->GetColor(label, type, color)) continue;
    return {lowered(Quantity_Color::ColorToHex(color.GetRGB()).ToCString()), color.Alpha()};
  }
  return {};
}

LabelColors::LabelColors(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label)
    : whole_(label_color(tool, label)) {
  TDF_LabelSequence parts;
  XCAFDoc_ShapeTool::GetSubShapes(label, parts);
  for (const TDF_Label& part : parts) add(tool, part);
}

LabelColors::LabelColors(const Handle(XCAFDoc_ColorTool) & tool,
                         const std::vector<TDF_Label>& labels) {
  for (const TDF_Label& label : labels) {
    add(tool, label);
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetSubShapes(label, parts);
    for (const TDF_Label& part : parts) add(tool, part);
  }
}

void LabelColors::add(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label) {
  Appearance color = label_color(tool, label);
  const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
  if (color.color.empty() || shape.IsNull()) return;
  index_.Bind(shape, static_cast<int>(colors_.size()));
  colors_.push_back(std::move(color));
}

const Appearance* LabelColors::find(const TopoDS_Shape& shape) const {
  const int* index = index_.Seek(shape);
  return index ? &colors_[static_cast<std::size_t>(*index)] : nullptr;
}

std::vector<const Appearance*> LabelColors::face_colors(const CadBody& body) const {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(body.shape, TopAbs_FACE, faces);
  const auto count = static_cast<std::size_t>(faces.Extent());
  std::vector<const Appearance*> out(count, nullptr);
  for (TopExp_Explorer shell(body.shape, TopAbs_SHELL); shell.More(); shell.Next()) {
    const Appearance* color = find(shell.Current());
    if (!color) continue;
    for (TopExp_Explorer it(shell.Current(), TopAbs_FACE); it.More(); it.Next()) {
      out[static_cast<std::size_t>(faces.FindIndex(it.Current())) - 1] = color;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool was_sewn = body.sewn_from.size() == count;
    const TopoDS_Shape& face =
        was_sewn ? body.sewn_from[i] : faces.FindKey(static_cast<int>(i) + 1);
    if (const Appearance* own = find(face)) out[i] = own;
  }
  return out;
}

Appearance LabelColors::of(const CadBody& body) const {
  const Appearance* own = find(body.shape);
  Appearance color = own ? *own : whole_;
  if (colors_.empty()) return color;
  const std::vector<const Appearance*> faces = face_colors(body);
  const auto as_first = [&](const Appearance* one) { return one && *one == *faces.front(); };
  return !faces.empty() && std::ranges::all_of(faces, as_first) ? *faces.front() : color;
}

std::shared_ptr<const std::vector<CadFaces>> LabelColors::faces_of(
    const std::vector<CadBody>& bodies, const std::vector<Appearance>& colors) const {
  std::vector<CadFaces> out(bodies.size());
  bool differ = std::ranges::any_of(colors, [&](const Appearance& c) { return c != colors[0]; });
  if (!differ && colors_.empty()) return nullptr;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (const Appearance* own : face_colors(bodies[i])) {
      const bool has_own = own && *own != colors[i];
      out[i].color.push_back(has_own ? *own : Appearance{});
      differ = differ || has_own;
    }
  }
  if (!differ) return nullptr;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    out[i].area = face_areas(bodies[i].shape);
  }
  return std::make_shared<const std::vector<CadFaces>>(std::move(out));
}

}  // namespace burin
