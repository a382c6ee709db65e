// In the place of the reader of OpenSCAD models where Burin was built without (BURIN_OPENSCAD).

#include "absent.h"

#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/openscad_reader.h>

namespace burin {

bool is_openscad_suffix(const std::filesystem::path& path) {
  const std::string suffix = model_suffix(path);
  return suffix == ".scad" || suffix == ".csg";
}

OpenscadMesh openscad_mesh(const std::filesystem::path& path, const OpenscadOptions& /*options*/,
                           RunContext& /*context*/) {
  throw InputError(needs("OpenSCAD files", kWithOpenscad), path.string());
}

}  // namespace burin
