#include "colors.h"

#include <burin/base/ascii.h>

#include <Quantity_ColorRGBA.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <utility>

namespace burin {

CadColor label_color(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label) {
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
  CadColor color = label_color(tool, label);
  const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
  if (color.hex.empty() || shape.IsNull()) return;
  index_.Bind(shape, static_cast<int>(colors_.size()));
  colors_.push_back(std::move(color));
}

CadColor LabelColors::common(const std::vector<TopoDS_Shape>& faces) const {
  CadColor common;
  for (const TopoDS_Shape& face : faces) {
    if (!index_.IsBound(face)) return {};
    const CadColor& color = colors_[static_cast<std::size_t>(index_(face))];
    if (!common.hex.empty() && color != common) return {};
    common = color;
  }
  return common;
}

CadColor LabelColors::of(const CadBody& body) const {
  if (index_.IsBound(body.shape)) return colors_[static_cast<std::size_t>(index_(body.shape))];
  if (!whole_.hex.empty()) return whole_;
  std::vector<TopoDS_Shape> faces = body.sewn_from;
  if (faces.empty()) {
    for (TopExp_Explorer it(body.shape, TopAbs_FACE); it.More(); it.Next()) {
      faces.push_back(it.Current());
    }
  }
  return common(faces);
}

}  // namespace burin
