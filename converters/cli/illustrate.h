#pragma once
/// `burin illustrate`.

#include <burin/base/run_context.h>

#include "arguments.h"
#include "console.h"

namespace burin::cli {

/// Writes a first illustration file; one that exists is left as it is. Models are read where an
/// exploded view is asked for: its steps are found and written; of an illustration file, into one
/// that extends it. With callouts or a parts list the numbers of the items are written, too. Throws
/// UsageError, InputError, OutputError, Cancelled.
void run_illustrate(const DrawArguments& arguments, RunContext& context, Console& console);

}  // namespace burin::cli
