#include "python_module.h"

#include <burin/base/error.h>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace burin::cli {
namespace {

namespace fs = std::filesystem;

/// Those of a build, of an installation, of packages of Debian, and of wheels (burin/bin).
std::vector<fs::path> package_folders(const fs::path& program) {
  const fs::path prefix = program.parent_path().parent_path();
  return {prefix / "python", prefix / BURIN_PYTHON_FOLDER, prefix / "lib/python3/dist-packages",
          prefix.parent_path()};
}

fs::path package_folder(const fs::path& program, const std::string& name) {
  std::string looked;
  for (const fs::path& folder : package_folders(program)) {
    std::error_code error;
    const fs::path module = folder / "burin" / name;
    if (fs::exists(module / "__main__.py", error)) return folder;
    looked += (looked.empty() ? "" : " and ") + module.string();
  }
  throw Error(
      fmt::format("the Python part of burin {} is missing (looked for {}); install the package "
                  "python3-burin, or build the target burin_python_package",
                  name, looked));
}

void put_first(const char* variable, const std::string& folder) {
  const char* before = std::getenv(variable);
  const bool others = before != nullptr && *before != '\0';
  ::setenv(variable, (others ? folder + ":" + before : folder).c_str(), 1);
}

/// Returns where the program cannot be started.
void become(const std::string& program, const std::vector<std::string>& words) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  ::execvp(program.c_str(), argv.data());
}

}  // namespace

void become_python(const std::string& name, const std::vector<std::string>& words) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path folder = package_folder(program, name);
  put_first("PYTHONPATH", folder.string());
  ::setenv("BURIN_COMMAND", program.c_str(), 1);
  std::vector<std::string> all = {(folder / "burin" / name).string()};
  all.insert(all.end(), words.begin(), words.end());
  if (const char* chosen = std::getenv("BURIN_PYTHON"); chosen != nullptr && *chosen != '\0') {
    become(chosen, all);
    throw Error(
        fmt::format("{} cannot be started ({}); set BURIN_PYTHON to a Python of 3.11 or later",
                    chosen, std::strerror(errno)));
  }
  become(BURIN_PYTHON_EXECUTABLE, all);
  become("python3", all);
  throw Error(fmt::format("burin {} needs python3 ({}); install the package python3", name,
                          std::strerror(errno)));
}

}  // namespace burin::cli
