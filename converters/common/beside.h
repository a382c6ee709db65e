#pragma once
/// Shared libraries and programs of ours that are loaded or started when they are needed.

#include <string>

namespace burin {

/// What a library is for and what to do without it, for messages.
struct LibraryWords {
  std::string purpose, remedy;
};

/// The function `entry` of the library `file` that stands beside libburin, wherever that was found.
/// Never closed: what it made may live as long as the process. Throws Error, one sentence.
void* library_entry(const char* file, const char* entry, const LibraryWords& words);

/// Throws Error where `found`, the library's version, is not this program's.
void check_library_version(const char* file, const char* found, const LibraryWords& words);

/// The path of a program of ours: `file`, as "burin/NAME", from the folder that libburin is in.
std::string program_beside(const char* file);

}  // namespace burin
