#pragma once
/// CAD files: STEP (AP203, AP214, AP242), IGES, BREP.

#include <burin/base/run_context.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <string>

namespace burin {

/// Whether the suffix (any case) is one of this reader's: .step .stp .p21 .iges .igs .brep .brp.
bool is_cad_suffix(const std::filesystem::path& path);

/// One part for each solid (or free shell or face) of each leaf of the assembly, in the order of
/// the file, with name, path in the assembly, colour and placement; instances share one shape.
/// Lengths in mm whatever the file's unit. Everything from outside (exceptions and signals of OCCT)
/// ends in an InputError that names the file and what to do. Progress and cancel as far as OCCT
/// allows: kernel/docs/cad.md says where it does not. Lives in a library of its own (libburin_cad),
/// which is loaded when the first CAD file is read: OCCT's exchange libraries take 65 ms to load.
Scene read_cad(const std::filesystem::path& path, RunContext& context);

}  // namespace burin
