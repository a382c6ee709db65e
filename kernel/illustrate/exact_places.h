#pragma once
// What lines of equal light ask of surfaces; internal to the module.

#include <burin/feature/isophotes.h>
#include <burin/surface/surface.h>

namespace burin::detail {

/// The places of an exact surface, which must outlive the answer; nothing of others, whose proxies
/// know as much.
ExactAt exact_places(const Surface& surface);

}  // namespace burin::detail
