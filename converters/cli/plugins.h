#pragma once
// burin plugins.

#include "arguments.h"

#include <string>

namespace burin::cli {

/// What it prints: a plug-in and what it offers, or why it was refused; where none was found, where
/// they are looked for.
std::string run_plugins(const PluginsArguments& arguments);

}  // namespace burin::cli
