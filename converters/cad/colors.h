#pragma once
/// The colour of parts in OCCT's documents.

#include <TDF_Label.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>

#include <string>
#include <vector>

namespace burin {

/// Colours of the shapes below one label of a document: of the whole, of solids and of faces.
class LabelColors {
 public:
  LabelColors(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);

  /// "#rrggbb": the colour of the shape itself, else of what contains it, else the one that all its
  /// faces share; empty where there is none.
  std::string of(const TopoDS_Shape& shape) const;

 private:
  std::string whole_;
  TopTools_DataMapOfShapeInteger index_;
  std::vector<std::string> colors_;
};

/// The colour that the label itself has, or empty.
std::string label_color(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);

}  // namespace burin
