#pragma once
/// `burin steps`.

#include <burin/base/run_context.h>

#include "arguments.h"
#include "console.h"

namespace burin::cli {

/// Draws how an assembly is put together and writes the step book. Throws the kernel's errors.
void run_steps(const StepsArguments& arguments, RunContext& context, Console& console);

}  // namespace burin::cli
