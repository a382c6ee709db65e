#pragma once
/// `burin diff`.

#include <burin/base/run_context.h>

#include "arguments.h"
#include "console.h"

namespace burin::cli {

/// Reads and compares two revisions, prints the report, draws and writes what is asked for. Returns
/// kDone where nothing has changed, else kDifferent. Throws the kernel's errors.
int run_diff(const DiffArguments& arguments, RunContext& context, Console& console);

}  // namespace burin::cli
