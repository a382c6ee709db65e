#pragma once
/// `burin illustrate`.

#include <burin/base/run_context.h>

#include "arguments.h"

namespace burin::cli {

/// Writes a first illustration file; one that exists is left as it is. With callouts or a parts
/// list it reads the models and writes the numbers of their items. Throws UsageError, InputError,
/// OutputError, Cancelled.
void run_illustrate(const DrawArguments& arguments, RunContext& context);

}  // namespace burin::cli
