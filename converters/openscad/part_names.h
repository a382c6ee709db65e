#pragma once
// What parts of a tree are called beside each other; internal to the module.

#include "parts.h"

namespace burin::detail {

/// Lets parts of one thing follow each other, and gives all parts names of their own: " #2", " #3"
/// to those of one kind, their colours to those that are one thing, which stand in an assembly of
/// its name. Before, each is called as what makes it.
void name_parts(TreeParts& all);

}  // namespace burin::detail
