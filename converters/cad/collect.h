#pragma once
/// From OCCT's documents and shapes to parts.

#include "cad_file.h"

#include <Standard_Handle.hxx>
#include <TopLoc_Location.hxx>

#include <cstdint>
#include <string>
#include <vector>

class TDocStd_Document;

namespace burin {

/// What becomes a part each, in order: each solid, each shell outside solids, and what the faces
/// outside shells sew into. None where there is no face.
std::vector<TopoDS_Shape> split_shape(const TopoDS_Shape& shape);

/// The faces with borders that fit, within a share of their size, made one edge.
TopoDS_Shape sewn(const std::vector<TopoDS_Shape>& faces, double share);

/// Wires, and edges and points outside of them, that belong to no face.
std::int64_t count_loose(const TopoDS_Shape& shape);
/// Says that so many of those, and members with nothing at all, were left out beside parts.
void tell_left_out(const std::vector<CadPart>& parts, std::int64_t count, Diagnostics& diagnostics);

/// The part that `shape` is at `location` (before which its own location is applied).
CadPart make_part(const TopoDS_Shape& shape, const TopLoc_Location& location,
                  const std::string& name);

/// All parts of a document, in the order of its tree; `fallback` names what has no name of its own.
std::vector<CadPart> collect_parts(const Handle(TDocStd_Document) & document,
                                   const std::string& fallback, Diagnostics& diagnostics,
                                   const RunContext& context);

/// Gives " #2", " #3" ... to parts that have name and assembly in common with one before.
void make_names_unique(std::vector<CadPart>& parts);

}  // namespace burin
