#pragma once
// What commands that draw read.

#include <burin/base/input_files.h>
#include <burin/converters/plan.h>

#include <string>
#include <vector>

namespace burin::cli {

/// All files that a run reads. `read`: what was opened for the plan, such as style files and
/// pictures.
std::vector<std::string> sources_of(const DrawInputs& inputs, const InputFiles& read);

}  // namespace burin::cli
