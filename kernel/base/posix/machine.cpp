#include <burin/base/library_folder.h>
#include <burin/base/platform.h>
#include <burin/base/version.h>

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace burin {

std::filesystem::path library_folder() {
  Dl_info info{};
  // An address in libburin.
  if (::dladdr(version(), &info) == 0 || info.dli_fname == nullptr) return {};
  return std::filesystem::path(info.dli_fname).parent_path();
}

}  // namespace burin

namespace burin::platform {

std::uint64_t memory_bytes() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return 0;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
}

std::int64_t process_number() { return ::getpid(); }

std::string trusted_variable(const char* name) {
  const char* const value = ::secure_getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

std::string signal_name(int signal) { return ::strsignal(signal); }

void* open_library(const std::filesystem::path& path, std::string& fault) {
  void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) fault = ::dlerror();
  return library;
}

void* symbol_in(void* library, const char* name) { return ::dlsym(library, name); }

}  // namespace burin::platform
