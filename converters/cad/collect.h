#pragma once
/// From OCCT's documents and shapes to parts.

#include "cad_file.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <NCollection_DataMap.hxx>
#include <Standard_Handle.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_ShapeMapHasher.hxx>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class TDocStd_Document;

namespace burin {

/// What a part is made of, in order: each solid, each shell outside solids, and what the faces
/// outside shells sew into. None where there is no face.
std::vector<CadBody> bodies_of(const TopoDS_Shape& shape);

/// Faces with borders that fit, within a share of their size, made one edge.
Handle(BRepBuilderAPI_Sewing) sew(const std::vector<TopoDS_Shape>& faces, double share);

/// What belongs to no face.
struct Loose {
  /// Wires, and edges outside of them.
  std::int64_t curves = 0;
  /// Points outside of those; members with nothing at all.
  std::int64_t others = 0;

  std::int64_t count() const { return curves + others; }
};
Loose count_loose(const TopoDS_Shape& shape);
/// Says that so many were left out beside parts; `first` is the name of the first member that has
/// some.
void report_left_out(const std::vector<CadPart>& parts, const Loose& loose,
                     const std::string& first, Diagnostics& diagnostics);

/// Where OCCT has a shape.
Placement placement_of(const TopLoc_Location& location);

/// The part that consists of these, at least one, where they stand.
CadPart make_part(std::vector<CadBody> bodies, const std::string& name);

/// What stands at the top of a document: products of STEP; of IGES whatever refers to no other,
/// where faces without a name are one part together.
enum class Roots { Products, Entities };

/// Names of shapes inside what stands at the top.
using ShapeNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

struct CollectOptions {
  Roots roots = Roots::Products;
  /// Names what has no name of its own.
  std::string fallback = {};
  /// The numbers that products have beside their names, by these. An instance that is called by the
  /// number alone gets the name.
  std::multimap<std::string, std::string> numbers = {};
  /// Those of what groups of IGES hold. A group whose members have names is an assembly of them.
  ShapeNames members = {};
  /// Those of solids in products, which stand where the solid is defined.
  ShapeNames solids = {};
};

/// All parts of a document, in the order of its tree.
std::vector<CadPart> collect_parts(const Handle(TDocStd_Document) & document,
                                   const CollectOptions& options, Diagnostics& diagnostics,
                                   const RunContext& context);

/// Gives " #2", " #3" ... to parts that have name and assembly in common with one before.
void make_names_unique(std::vector<CadPart>& parts);

}  // namespace burin
