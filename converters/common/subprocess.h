#pragma once
// Programs that converters start.

#include <burin/base/subprocess.h>

namespace burin::detail {

inline constexpr int kChildFile = kSubprocessFile;

}  // namespace burin::detail
