#pragma once
/// `burin options`.

#include "arguments.h"

#include <string>

namespace burin::cli {

/// The text to print.
std::string run_options(const OptionsArguments& arguments);

}  // namespace burin::cli
