#pragma once
/// Objects that stand at other places once more.

#include <burin/converters/irit_tree.h>

#include "source.h"

namespace burin::irit {

/// Puts, for each INSTANCE, what its original holds, moved by its matrix, into the object that it
/// stands in; one whose original the file does not hold stays. The colour of the original goes
/// before that of the object, a mark of the original that it is invisible does not count. Throws
/// InputError where objects are instances of themselves, where instances make more control points
/// than any file would hold, and where a matrix sends points to infinity.
void resolve_instances(IritObject& root, const Source& source);

}  // namespace burin::irit
