#pragma once
/// The bytes of one input file, and errors that say where in it.

#include <burin/base/error.h>
#include <burin/base/run_context.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace burin {

/// A whole file in memory, read once. Reading (not mapping) keeps a file that shrinks meanwhile
/// from being a crash.
class Source {
 public:
  /// Throws InputError where the path is missing, a folder, unreadable, empty or too large for this
  /// machine.
  Source(const std::filesystem::path& path, const RunContext& context);
  /// Bytes that are already in memory (a member of an archive); errors name `file`.
  Source(std::string file, std::string_view bytes, const RunContext& context);

  const std::string& file() const { return file_; }
  /// The bytes; one NUL follows the last of them.
  std::string_view bytes() const { return {data_.get(), size_}; }
  const RunContext& context() const { return context_; }

  /// The number of the line, from 1, that `where` lies in. Linear; for errors.
  std::int64_t line_of(const char* where) const;
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at_line(const char* where, const std::string& what) const;
  [[noreturn]] void fail_at_byte(std::size_t offset, const std::string& what) const;

 private:
  std::string file_;
  std::unique_ptr<char[]> data_;
  std::size_t size_ = 0;
  const RunContext& context_;
};

}  // namespace burin
