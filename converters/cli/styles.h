#pragma once
/// `burin styles`.

#include "arguments.h"

#include <string>

namespace burin::cli {

/// The text to print. Throws UsageError for an unknown style.
std::string run_styles(const StylesArguments& arguments);

}  // namespace burin::cli
