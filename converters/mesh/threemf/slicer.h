#pragma once
/// What slicers keep beside the model: the names that people gave, and which volumes are solid.

#include "look.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace burin {

class Package;

/// A part of an object, as a slicer has it.
struct SlicerPart {
  /// The id of a component (Bambu Studio, OrcaSlicer), or triangles of the object's mesh, the first
  /// and the last (PrusaSlicer).
  std::string id;
  std::size_t first = 0, last = 0;
  std::string name;
  /// Whether it is printed: neither a modifier, nor taken away, nor a place for supports.
  bool solid = true;
  /// Of its filament.
  std::optional<Rgba> color;
};

struct SlicerObject {
  std::string name;
  std::vector<SlicerPart> parts;
  std::optional<Rgba> color;
};

/// By the ids of the objects in the main model. Empty where no slicer left anything; settings that
/// cannot be read count as none, as a model is not worth refusing for them.
std::map<std::string, SlicerObject> read_slicer_settings(const Package& package);

}  // namespace burin
