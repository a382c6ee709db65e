#pragma once
/// The colour of parts in OCCT's documents.

#include "cad_file.h"

#include <TDF_Label.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>

#include <memory>
#include <vector>

namespace burin {

/// Colours of the shapes below one label of a document: of the whole, of solids and of faces.
class LabelColors {
 public:
  LabelColors(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);
  /// Of the shapes at and below several labels, which have no colour together.
  LabelColors(const Handle(XCAFDoc_ColorTool) & tool, const std::vector<TDF_Label>& labels);

  /// The one that all faces of the body share, else that of the body itself, else of what contains
  /// it; without one, none.
  Appearance of(const CadBody& body) const;
  /// The colours of the faces of bodies, each where it is not that of its body; none where the
  /// bodies have one colour and no face has another. Areas by OCCT: 0.1 ms a face.
  std::shared_ptr<const std::vector<CadFaces>> faces_of(
      const std::vector<CadBody>& bodies, const std::vector<Appearance>& colors) const;

 private:
  void add(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);
  const Appearance* find(const TopoDS_Shape& shape) const;
  /// Of each face of a body, in the order of TopExp::MapShapes; null: it has none of its own.
  std::vector<const Appearance*> face_colors(const CadBody& body) const;

  Appearance whole_;
  TopTools_DataMapOfShapeInteger index_;
  std::vector<Appearance> colors_;
};

/// Of the faces of a shape, in the order of TopExp::MapShapes; 0 where OCCT cannot tell.
std::vector<double> face_areas(const TopoDS_Shape& shape);

/// The colour that the label itself has, or none.
Appearance label_color(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label);

}  // namespace burin
