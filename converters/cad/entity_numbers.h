#pragma once
/// The numbers of the entities of a STEP file, looked at before OCCT reads them.

#include <burin/base/diagnostics.h>

#include "source.h"

#include <string>

namespace burin {

/// OCCT 7.6 goes round for ever, in memory that it never wrote, where two entities have one number:
/// the later ones get numbers that nothing refers to, and are told. Numbers beyond 32 bits, which
/// it would take for others, are replaced. Returns the text so changed, and an empty one where
/// there was nothing to change. Throws InputError where no numbers are left. O(n log n) in the
/// entities, linear in the text.
std::string unique_entity_numbers(const Source& source, Diagnostics& diagnostics);

}  // namespace burin
