#include <burin/base/error.h>
#include <burin/base/version.h>
#include <burin/converters/cad_reader.h>

#include "../cad_format.h"
#include "../cad_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstring>
#include <string>

namespace burin {
namespace {

/// The library stands beside libburin, wherever that was found; `version` gives an address in it.
std::filesystem::path library_path() {
  Dl_info info{};
  if (::dladdr(version(), &info) == 0 || info.dli_fname == nullptr) return BURIN_CAD_LIBRARY;
  return std::filesystem::path(info.dli_fname).parent_path() / BURIN_CAD_LIBRARY;
}

[[noreturn]] void fail(const std::string& why) {
  throw Error(
      fmt::format("the library that reads CAD files cannot be used: {}; install it beside "
                  "libburin, or export the model as STL",
                  why));
}

const CadLibrary& load() {
  const std::filesystem::path path = library_path();
  // Never closed: forms that it made may live as long as the process.
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!library) fail(::dlerror());
  const auto door = reinterpret_cast<CadLibraryDoor>(::dlsym(library, kCadLibraryDoor));
  if (!door) fail(path.string() + " is no such library");
  const CadLibrary& cad = *door();
  if (std::strcmp(cad.version, version()) != 0) {
    fail(fmt::format("{} is of version {}, this program of {}", path.string(), cad.version,
                     version()));
  }
  return cad;
}

const CadLibrary& library() {
  static const CadLibrary& cad = load();
  return cad;
}

}  // namespace

bool is_cad_suffix(const std::filesystem::path& path) {
  return cad_format_of_suffix(path).has_value();
}

bool is_cad_content(std::string_view head) { return cad_format_of(head).has_value(); }

Scene read_cad(const std::filesystem::path& path, RunContext& context) {
  return library().read(path, context);
}

FileInfo inspect_cad(const std::filesystem::path& path, RunContext& context) {
  return library().inspect(path, context);
}

Part read_brep_text(const std::string& brep, const Placement& placement, RunContext& context) {
  return library().read_text(brep, placement, context);
}

}  // namespace burin
