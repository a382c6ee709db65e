#include <burin/base/library_folder.h>
#include <burin/base/version.h>

#include <dlfcn.h>

namespace burin {

std::filesystem::path library_folder() {
  Dl_info info{};
  // An address in libburin.
  if (::dladdr(version(), &info) == 0 || info.dli_fname == nullptr) return {};
  return std::filesystem::path(info.dli_fname).parent_path();
}

}  // namespace burin
