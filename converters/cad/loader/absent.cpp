// In the place of load.cpp where Burin was built without OCCT (BURIN_CAD): readers of FreeCAD's and
// IRIT's files that find exact shapes get an error.

#include "absent.h"

#include <burin/base/error.h>
#include <burin/converters/cad_reader.h>
#include <burin/converters/trimmed_faces.h>

namespace burin {

std::shared_ptr<const BrepShape> read_brep_text(const std::string& /*brep*/,
                                                RunContext& /*context*/) {
  throw InputError(needs("exact shapes", kWithOcct));
}

Part read_brep_text(const std::string& brep, const Placement& /*placement*/, RunContext& context) {
  Part part;
  part.form = read_brep_text(brep, context)->form({});
  return part;
}

std::shared_ptr<const BrepShape> read_brep_shape(const std::string& bytes, BrepBytes /*kind*/,
                                                 RunContext& context) {
  return read_brep_text(bytes, context);
}

std::shared_ptr<const BrepShape> make_trimmed_faces(const std::vector<TrimmedSurface>& /*surfaces*/,
                                                    double /*weld*/, const std::string& file,
                                                    const RunContext& /*context*/) {
  throw InputError(needs("trimmed surfaces", kWithOcct), file);
}

}  // namespace burin
