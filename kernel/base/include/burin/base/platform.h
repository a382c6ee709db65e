#pragma once
/// What Burin asks of the operating system beside the standard library, subprocess.h, piped_input.h
/// and input_files.h. The sources behind these four are in kernel/base/posix: all that another
/// platform replaces.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace burin::platform {

/// Bytes of memory of this machine; 0 where the system does not tell.
std::uint64_t memory_bytes();

/// A number that no other running process has.
std::int64_t process_number();

/// What the environment says; empty where it says nothing, and for programs that run with the
/// rights of somebody else.
std::string trusted_variable(const char* name);

/// "Segmentation fault": the signal that ended a program.
std::string signal_name(int signal);

/// What this process may do with a file; else errno tells why not.
bool may_read(const std::filesystem::path& path);
bool may_write(const std::filesystem::path& path);
bool may_run(const std::filesystem::path& path);

/// Open files have numbers. Where a function fails it returns -1 or false, and errno tells why.
int open_to_read(const std::filesystem::path& path);  // without waiting for the writer of a pipe
int open_to_write(const std::filesystem::path& path);
int create_file(const std::filesystem::path& path);  // fails where it exists
bool close_file(int file);
inline constexpr int kStandardOutput = 1;

enum class FileKind : std::uint8_t { Regular, Folder, Other };
struct FileState {
  FileKind kind = FileKind::Other;
  std::uint64_t size = 0;
};
bool state_of(int file, FileState& state);

/// Bytes from where the file stands; 0 at its end. May be fewer than `most`.
std::ptrdiff_t read_some(int file, char* to, std::size_t most);
/// All of it.
bool write_all(int file, std::string_view bytes);

/// The whole content, wherever the file stands; at most `most` bytes of it.
bool read_content(int file, std::string& content, std::size_t most = SIZE_MAX);
bool replace_content(int file, std::string_view content);

/// A shared library, never closed; nullptr, and `fault` tells why.
void* open_library(const std::filesystem::path& path, std::string& fault);
/// The address of what the library calls by that name; nullptr where there is nothing.
void* symbol_in(void* library, const char* name);

}  // namespace burin::platform
