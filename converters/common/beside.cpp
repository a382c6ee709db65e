#include "beside.h"

#include <burin/base/error.h>
#include <burin/base/library_folder.h>
#include <burin/base/platform.h>
#include <burin/base/version.h>

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <new>
#include <string>

namespace burin {
namespace {

std::filesystem::path beside_libburin(const char* file) { return library_folder() / file; }

[[noreturn]] void fail_library(const LibraryWords& words, const std::string& why) {
  throw Error(fmt::format("the library that {} cannot be used: {}; install it beside libburin, {}",
                          words.purpose, why, words.remedy));
}

}  // namespace

void* library_entry(const char* file, const char* entry, const LibraryWords& words) {
  const std::filesystem::path path = beside_libburin(file);
  std::string why;
  void* library = platform::open_library(path, why);
  if (!library) {
    for (const char* sign : {"failed to map segment", "annot allocate memory"}) {
      if (why.find(sign) != std::string::npos) throw std::bad_alloc();
    }
    fail_library(words, why);
  }
  void* found = platform::symbol_in(library, entry);
  if (!found) fail_library(words, path.string() + " is no such library");
  return found;
}

std::string program_beside(const char* file) { return beside_libburin(file).string(); }

void check_library_version(const char* file, const char* found, const LibraryWords& words) {
  if (std::strcmp(found, version()) == 0) return;
  fail_library(words, fmt::format("{} is version {}, this program is version {}",
                                  beside_libburin(file).string(), found, version()));
}

}  // namespace burin
