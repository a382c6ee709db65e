#pragma once
/// Faces of OCCT from splines and trimming curves as data.

#include <burin/base/run_context.h>
#include <burin/converters/trimmed_faces.h>

#include <TopoDS_Face.hxx>

#include <string>
#include <vector>

namespace burin {

/// Makes the faces of one surface, as `make_trimmed_faces` says.
struct FaceMaker {
  const std::string& file;
  const RunContext& context;

  std::vector<TopoDS_Face> faces_of(const TrimmedSurface& trimmed) const;
};

}  // namespace burin
