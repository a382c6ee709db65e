#pragma once
// The program that tries plug-ins.

#include <filesystem>

namespace burin::plugin {

std::filesystem::path probe_program();

}  // namespace burin::plugin
