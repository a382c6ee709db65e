#pragma once
/// What a STEP file says of sizes, tolerances, datums and notes, as it stands there.

#include <burin/surface/pmi.h>

#include "step_text.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace burin {

/// An item before its faces and its part are found.
struct StepPmiItem {
  /// Coordinates in mm.
  PmiItem item = {};
  /// What states it, 0: an annotation alone.
  std::int64_t entity = 0;
  /// Entities of faces, ascending.
  std::vector<std::int64_t> faces = {};
  /// The definition of a product; 0: it does not say.
  std::int64_t product = 0;
};

struct StepPmi {
  /// Dimensions, tolerances, datums, targets, notes and the rest, each as the file numbers them.
  std::vector<StepPmiItem> items;
  std::vector<PmiView> views = {};
  /// How often what was met that is not understood, by type.
  std::map<std::string, std::int64_t> unknown = {};

  bool empty() const { return items.empty() && views.empty(); }
};

/// Cost: linear in the text, plus a tenth of a millisecond an annotation.
StepPmi read_step_pmi(const StepText& text);

}  // namespace burin
