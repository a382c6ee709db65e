#pragma once

#include <string>

namespace burin::cli {

/// The version of the command, and of the libraries that it was built with, a line each.
std::string version_text();

}  // namespace burin::cli
