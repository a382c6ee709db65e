#pragma once
// What the numbers of thread types and sizes of FreeCAD stand for; internal to the module.

#include <cstdint>
#include <optional>
#include <string>

namespace burin::detail {

/// Model mm.
struct ThreadSize {
  std::string designation;
  double diameter = 0, pitch = 0;
};

/// Of a type (1 ISO metric coarse, 2 fine, 3 UNC, 4 UNF, 5 UNEF) and the number of a size in its
/// list; nothing where FreeCAD 0.20 has none.
std::optional<ThreadSize> thread_size(std::int64_t type, std::int64_t number);

}  // namespace burin::detail
