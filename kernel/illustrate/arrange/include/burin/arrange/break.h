#pragma once
/// Broken views: stretches of long parts that are left out.

#include <burin/base/vec.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// A stretch of the model that is left out of the views along which it runs.
struct Break {
  /// Unit; absent: the axis along which what is drawn is longest.
  std::optional<Vec3> axis = {};
  /// Model mm along it, the first the smaller; absent: all long stretches over which nothing
  /// changes are found.
  std::optional<std::pair<double, double>> stretch = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

/// What is left out of a model: stretches along one axis, model mm, ascending, apart.
struct ModelBreaks {
  Vec3 axis{1, 0, 0};
  std::vector<std::pair<double, double>> stretches = {};

  bool empty() const { return stretches.empty(); }
};

}  // namespace burin
