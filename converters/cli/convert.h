#pragma once
/// `burin convert`.

#include <burin/base/run_context.h>

#include "arguments.h"
#include "console.h"

namespace burin::cli {

/// Reads a drawing file and writes it in other formats. Throws what main tells the user; leaves
/// nothing behind then.
void run_convert(const ConvertArguments& arguments, RunContext& context, Console& console);

}  // namespace burin::cli
