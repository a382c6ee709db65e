#pragma once
/// From what a STEP file says to what its parts have.

#include <burin/base/diagnostics.h>

#include "cad_file.h"
#include "step_pmi.h"

#include <string_view>
#include <vector>

class STEPCAFControl_Reader;

namespace burin {

/// Whether a text may hold any of it, without reading its entities.
bool may_have_pmi(std::string_view text);

/// Gives each item to the part whose faces it is about, else to that of its product; all instances
/// of a part share what it has. A warning names what belongs to no part, and what was not
/// understood.
void give_pmi(StepPmi pmi, STEPCAFControl_Reader& reader, std::vector<CadPart>& parts,
              Diagnostics& diagnostics);

}  // namespace burin
