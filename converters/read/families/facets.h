#pragma once
// What the readers of meshes do with facets; internal to the module.

#include <burin/converters/mesh_reader.h>
#include <burin/converters/read.h>

namespace burin::detail {

/// Those of files are kept unless `heal` is asked for.
inline Facets facets_of(const ReadOptions& o) {
  return o.heal.value_or(false) ? Facets::Recognised : Facets::Kept;
}

}  // namespace burin::detail
