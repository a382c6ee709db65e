#pragma once
/// `burin watch`.

#include <burin/base/run_context.h>

#include "arguments.h"
#include "console.h"

namespace burin::cli {

/// Draws as `run_draw`, and again whenever a file that was read is another than it was; ends by
/// Cancelled. Errors are reported, and watching goes on; but what is wrong with the words of
/// the command, and files that were never there, end it as they end `run_draw`.
/// `context`: of the time between drawings.
void run_watch(const DrawArguments& arguments, RunContext& context, Console& console);

}  // namespace burin::cli
