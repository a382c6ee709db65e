#pragma once
// Matrices of a tree as those of the kernel; internal to the module.

#include <burin/base/vec.h>

#include "tree.h"

namespace burin::detail {

/// p -> linear * p + offset.
struct Affine {
  Mat3 linear{1};
  Vec3 offset{0};

  explicit Affine(const csg::Matrix& m) {
    for (int i = 0; i < 3; ++i) {
      const auto& row = m.row[static_cast<std::size_t>(i)];
      for (int j = 0; j < 3; ++j) linear[j][i] = row[static_cast<std::size_t>(j)];
      offset[i] = row[3];
    }
  }
};

}  // namespace burin::detail
