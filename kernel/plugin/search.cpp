#include "search.h"

#include <burin/base/library_folder.h>
#include <burin/base/platform.h>
#include <burin/plugin/plugins.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace burin::plugin {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 256;

/// The folder that a variable names, else one below the home folder; empty where there is neither.
fs::path user_folder(const char* name, const char* below_home) {
  fs::path named = platform::trusted_variable(name);
  const fs::path home = platform::trusted_variable("HOME");
  if (named.is_absolute()) return named;
  return home.is_absolute() ? home / below_home : fs::path();
}

std::vector<fs::path> named_folders() {
  std::vector<fs::path> folders;
  const std::string all = platform::trusted_variable("BURIN_PLUGIN_PATH");
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find(':', at), all.size());
    if (end > at) folders.emplace_back(all.substr(at, end - at));
    at = end + 1;
  }
  return folders;
}

void add_files(const fs::path& folder, std::vector<fs::path>& files) {
  std::error_code error;
  std::vector<fs::path> here;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code of_file;
    if (entry->path().extension() == ".so" && entry->is_regular_file(of_file)) {
      here.push_back(entry->path());
    }
  }
  std::ranges::sort(here);
  files.insert(files.end(), here.begin(), here.end());
}

}  // namespace

std::vector<fs::path> search_path() {
  std::vector<fs::path> folders = named_folders();
  if (const fs::path user = user_folder("XDG_DATA_HOME", ".local/share"); !user.empty()) {
    folders.push_back(user / "burin" / "plugins");
  }
  if (const fs::path system = library_folder(); !system.empty()) {
    folders.push_back(system / "burin" / "plugins");
  }
  return folders;
}

std::vector<fs::path> candidates(std::vector<fs::path>& relative) {
  std::vector<fs::path> files;
  for (const fs::path& folder : search_path()) {
    if (folder.is_absolute()) {
      add_files(folder, files);
    } else {
      relative.push_back(folder);
    }
  }
  // A folder that is named twice.
  std::vector<fs::path> once;
  for (const fs::path& file : files) {
    if (once.size() < kMostFiles && std::ranges::find(once, file) == once.end())
      once.push_back(file);
  }
  return once;
}

fs::path cache_folder() {
  const fs::path folder = user_folder("XDG_CACHE_HOME", ".cache");
  return folder.empty() ? folder : folder / "burin";
}

}  // namespace burin::plugin
