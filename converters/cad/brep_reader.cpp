#include <burin/base/error.h>
#include <burin/base/input_name.h>

#include "cad_file.h"
#include "collect.h"
#include "occt_session.h"
#include "text.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>

#include <sstream>
#include <string>

namespace burin {

CadFile read_brep(const Source& source, bool binary, RunContext& context) {
  std::istringstream in{std::string(source.bytes())};
  // OCCT's readers loop for ever where a number is missing; an exception ends them.
  in.exceptions(std::ios::failbit | std::ios::badbit);
  const Handle(OcctProgress) progress = new OcctProgress(context, 0, 1);
  TopoDS_Shape shape;
  try {
    if (binary) {
      BinTools::Read(shape, in, progress->Start());
    } else {
      BRepTools::Read(shape, in, BRep_Builder(), progress->Start());
    }
  } catch (const std::ios_base::failure&) {
    source.fail("is broken or ends early; export the model again");
  }
  context.check();
  if (shape.IsNull()) source.fail("is broken or no BREP file; export the model again");
  CadFile file;
  file.format = binary ? "BREP (binary)" : "BREP (text)";
  const std::string stem = clean_name(model_stem(source.file()));
  if (std::vector<CadBody> bodies = bodies_of(shape); !bodies.empty()) {
    file.parts.push_back(make_part(std::move(bodies), stem));
  }
  report_left_out(file.parts, count_loose(shape), stem, file.diagnostics);
  return file;
}

}  // namespace burin
