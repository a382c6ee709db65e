#pragma once
/// Faces by their numbers in diagnostics.

#include <burin/base/diagnostics.h>
#include <burin/forms/charted/atlas.h>

#include <cstdint>
#include <string>
#include <vector>

namespace burin {

/// "face 3", "faces 1, 2, 3" or, of many, the first ten and how many more; by the numbers of the
/// drawing.
std::string face_list(std::vector<std::int32_t> faces, const Atlas& atlas);

/// "brep.face_loose" for the faces of `atlas` that are marked; `diagnostics` may be absent.
void name_loose_faces(const std::vector<std::uint8_t>& marked, const std::string& reason,
                      const Atlas& atlas, Diagnostics* diagnostics);

}  // namespace burin
