#pragma once
/// What a run does, one after the other.

#include <string>
#include <vector>

namespace burin {

enum class RunStage {
  Read,
  Build,
  Curvature,
  Field,
  Cover,
  Trace,
  Features,
  Visibility,
  Compose,
  Verify,
  Write
};

/// "read", "build" ..., in the order of the enumeration: as progress and timings name them.
const std::vector<std::string>& run_stage_names();
const std::string& to_string(RunStage stage);

}  // namespace burin
