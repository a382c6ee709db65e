#pragma once
// A sheet that holds little; internal to the module.

#include <burin/arrange/illustration.h>
#include <burin/drawing/drawing.h>

namespace burin::detail {

/// Reports a drawing that takes a small part of its sheet, with what would fill it.
void report_mostly_empty(const Illustration& illustration, Drawing& drawing);

}  // namespace burin::detail
