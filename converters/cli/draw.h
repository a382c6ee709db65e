#pragma once
/// `burin draw`.

#include <burin/base/run_context.h>

#include "arguments.h"
#include "console.h"

namespace burin::cli {

/// Reads, draws and writes; prints the drawing's diagnostics. Throws the kernel's errors.
void run_draw(const DrawArguments& arguments, RunContext& context, Console& console);

}  // namespace burin::cli
