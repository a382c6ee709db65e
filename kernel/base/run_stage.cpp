#include <burin/base/run_stage.h>

namespace burin {

const std::vector<std::string>& run_stage_names() {
  static const std::vector<std::string> names = {"read",    "build",  "curvature", "field",
                                                 "cover",   "trace",  "features",  "visibility",
                                                 "compose", "verify", "write"};
  return names;
}

const std::string& to_string(RunStage stage) {
  return run_stage_names()[static_cast<std::size_t>(stage)];
}

}  // namespace burin
