#pragma once
/// `burin illustrate`.

#include "arguments.h"

namespace burin::cli {

/// Writes a first illustration file; one that exists is left as it is. Throws UsageError,
/// InputError, OutputError.
void run_illustrate(const DrawArguments& arguments);

}  // namespace burin::cli
