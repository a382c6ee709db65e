#pragma once
/// All inputs as one scene.

#include <burin/base/run_context.h>
#include <burin/surface/scene.h>

#include "readers.h"

#include <string>
#include <vector>

namespace burin::cli {

/// Throws InputError for the first path that is no file that can be opened.
void check_inputs(const std::vector<std::string>& paths);

/// Reads each file by the reader of its format; the parts of all of them, in order. Stage "read".
/// Throws InputError.
Scene read_inputs(const std::vector<std::string>& paths, const ReadOptions& options,
                  RunContext& context);

}  // namespace burin::cli
