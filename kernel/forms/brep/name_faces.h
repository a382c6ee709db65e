#pragma once
/// Faces by their numbers in diagnostics.

#include <burin/base/diagnostics.h>

#include <cstdint>
#include <string>
#include <vector>

namespace burin {

/// "face 3", "faces 1, 2, 3" or, of many, the first ten and how many more.
std::string face_list(const std::vector<std::int32_t>& faces);

/// "brep.face_loose" for the faces that are marked; `diagnostics` may be absent.
void name_loose_faces(const std::vector<std::uint8_t>& marked, const std::string& reason,
                      Diagnostics* diagnostics);

}  // namespace burin
