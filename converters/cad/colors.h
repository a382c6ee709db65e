#pragma once
/// The colour of parts in OCCT's documents.

#include "cad_file.h"

#include <TDF_Label.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>

#include <vector>

namespace burin {

/// Colours of the shapes below one label of a document: of the whole, of solids and of faces.
class LabelColors {
 public:
  LabelColors(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);
  /// Of the shapes at and below several labels, which have no colour together.
  LabelColors(const Handle(XCAFDoc_ColorTool) & tool, const std::vector<TDF_Label>& labels);

  /// The colour of the body itself, else of what contains it, else the one that all its faces
  /// share; without one, none.
  CadColor of(const CadBody& body) const;

 private:
  void add(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);
  CadColor common(const std::vector<TopoDS_Shape>& faces) const;

  CadColor whole_;
  TopTools_DataMapOfShapeInteger index_;
  std::vector<CadColor> colors_;
};

/// The colour that the label itself has, or none.
CadColor label_color(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);

}  // namespace burin
