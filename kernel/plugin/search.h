#pragma once
// Where plug-ins are looked for.

#include <filesystem>
#include <vector>

namespace burin::plugin {

/// The files that may be plug-ins, by folder, then by name; at most 256. Entries of
/// BURIN_PLUGIN_PATH that are no absolute path go to `relative`: what they mean would depend on
/// where one stands.
std::vector<std::filesystem::path> candidates(std::vector<std::filesystem::path>& relative);

/// The user's folder for what may be thrown away (with "burin" at its end); empty where there is
/// none.
std::filesystem::path cache_folder();

}  // namespace burin::plugin
