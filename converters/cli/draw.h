#pragma once
/// `burin draw` and `burin illustrate`.

#include <burin/base/run_context.h>

#include "arguments.h"
#include "console.h"

#include <string>

namespace burin::cli {

/// Writes an illustration file, or returns it where standard output was named. Throws UsageError,
/// InputError, OutputError.
std::string run_illustrate(const DrawArguments& arguments);

/// Reads, draws and writes; prints the drawing's diagnostics. Throws the kernel's errors.
void run_draw(const DrawArguments& arguments, RunContext& context, Console& console);

}  // namespace burin::cli
