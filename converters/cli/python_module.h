#pragma once
/// Commands that are written in Python.

#include <string>
#include <vector>

namespace burin::cli {

/// Becomes `python3` that runs the folder `burin/NAME` of our Python package with these words; its
/// status is that of the command. The package is looked for in the build and in the prefix that
/// this program stands in, its folder comes first in PYTHONPATH, and BURIN_COMMAND is this program.
/// The interpreter is $BURIN_PYTHON, else that which the package was made for, else the first on
/// PATH. Cost: that of starting Python, 20 ms. Throws Error where something is missing: one line
/// that says what to install.
[[noreturn]] void become_python(const std::string& name, const std::vector<std::string>& words);

}  // namespace burin::cli
