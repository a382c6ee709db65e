#pragma once
/// A step of an exploded view.

#include <burin/base/vec.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// Parts that move together.
struct ExplodeStep {
  /// Selectors that name them (burin/assembly/select.h), where a user asks for the step or is told
  /// of it.
  std::vector<std::string> move = {};
  /// The same in one scene: indices into Scene::parts, ascending.
  std::vector<std::size_t> parts = {};
  /// Unit vector.
  Vec3 along{0, 0, 1};
  /// Model mm.
  double by = 0;
  /// Whether a line shows the way.
  bool trail = true;
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

}  // namespace burin
