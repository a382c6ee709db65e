#pragma once
// The round surfaces that a mesh stands for; internal to the module.

#include "bands.h"

namespace burin::recognised {

struct Recognised {
  std::vector<Patch> patches;
  /// For each facet its patch, or -1.
  std::vector<std::int32_t> patch_of;
};

/// Joins bands that follow one another smoothly along their profile, with the flat rings and caps
/// between and at the end of them.
Recognised join_profiles(const TriMesh& mesh, const Facets& facets, Bands bands,
                         const RunContext& context);

}  // namespace burin::recognised
