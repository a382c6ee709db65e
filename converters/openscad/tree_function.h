#pragma once
// Trees as implicit functions; internal to the module.

#include <burin/base/run_context.h>
#include <burin/forms/implicit/expression.h>

#include "parts.h"
#include "tree.h"

namespace burin::detail {

/// The true solid that a part of a tree stands for, negative inside: circles are round, unless they
/// have eight corners or fewer. Throws InputError that names the first module that has no formula.
Expression function_of(const csg::Tree& tree, const TreePart& part, const RunContext& context);

}  // namespace burin::detail
