#pragma once
/// Bezier patches of Geomview and plain patch lists.

#include <burin/forms/charted/nurbs.h>

#include "source.h"

#include <vector>

namespace burin::irit {

/// Whether the text begins with BBP or BEZ and its digits.
bool is_geomview(std::string_view text);
/// Whether the text begins as one of the layouts of patch lists does; the first bytes are enough.
bool is_patch_list(std::string_view text);

/// Patches whose control points lie at infinity (weight 0) are split until all weights are
/// positive: the surface is the same.
std::vector<NurbsData> read_geomview(const Source& source);
std::vector<NurbsData> read_patch_list(const Source& source);

}  // namespace burin::irit
