#pragma once
/// Where libburin stands: what belongs to it is found from there, wherever that is.

#include <filesystem>

namespace burin {

/// The folder of libburin; empty where the system does not tell.
std::filesystem::path library_folder();

}  // namespace burin
