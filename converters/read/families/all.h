#pragma once
// The rows of the table of readers, one a source. CMake compiles those of BURIN_READERS and lists
// them in own_readers.cpp.

#include "../readers.h"

namespace burin::detail {

extern const Reader kCad, kGltf, kIrit, kImplicit, kOpenscad, kFcstd, kVolume, kMesh;

}  // namespace burin::detail
