#include "colors.h"

#include <burin/base/ascii.h>

#include <Quantity_Color.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace burin {

std::string label_color(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label) {
  Quantity_Color color;
  for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
    if (!tool->GetColor(label, type, color)) continue;
    return lowered(Quantity_Color::ColorToHex(color).ToCString());
  }
  return {};
}

LabelColors::LabelColors(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label)
    : whole_(label_color(tool, label)) {
  TDF_LabelSequence parts;
  XCAFDoc_ShapeTool::GetSubShapes(label, parts);
  for (const TDF_Label& part : parts) {
    const std::string color = label_color(tool, part);
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
    if (color.empty() || shape.IsNull()) continue;
    index_.Bind(shape, static_cast<int>(colors_.size()));
    colors_.push_back(color);
  }
}

std::string LabelColors::of(const TopoDS_Shape& shape) const {
  if (index_.IsBound(shape)) return colors_[static_cast<std::size_t>(index_(shape))];
  if (!whole_.empty()) return whole_;
  std::string common;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    if (!index_.IsBound(it.Current())) return {};
    const std::string& color = colors_[static_cast<std::size_t>(index_(it.Current()))];
    if (!common.empty() && color != common) return {};
    common = color;
  }
  return common;
}

}  // namespace burin
