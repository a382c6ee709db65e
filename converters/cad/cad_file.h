#pragma once
/// A CAD file as it stands: shapes in their places, before they become forms.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/charted/chart.h>

#include "source.h"

#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <string>
#include <vector>

namespace burin {

class OcctSession;

struct CadPart {
  std::string name;
  std::vector<std::string> assembly;
  std::string color;
  /// The name of the product that it is an instance of; empty where that says nothing.
  std::string definition = {};
  /// Without location, so that instances are equal; `placement` has it.
  TopoDS_Shape shape;
  Placement placement;
};

struct CadFile {
  std::string format, schema;
  std::vector<CadPart> parts;
  Diagnostics diagnostics;
};

/// By content, else by suffix. Throws InputError; nothing of OCCT gets out.
CadFile read_cad_file(const std::filesystem::path& path, const OcctSession& session,
                      RunContext& context);

/// One reader a format, to be called inside `guarded`.
CadFile read_step(const Source& source, const OcctSession& session, RunContext& context);
CadFile read_iges(const Source& source, RunContext& context);
CadFile read_brep(const Source& source, bool binary, RunContext& context);

}  // namespace burin
