#include "source.h"

#include <burin/base/input_files.h>
#include <burin/base/missing_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace burin {
namespace {

class Descriptor {
 public:
  explicit Descriptor(const char* path) : fd_(::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

std::string reason(int error) {
  if (error == ENOENT || error == ENOTDIR) return "no such file; check the path";
  if (error == EACCES || error == EPERM) return "may not be read; check its permissions";
  return fmt::format("cannot be read: {}", std::generic_category().message(error));
}

std::size_t half_of_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return std::size_t{1} << 32;
  return static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(page);
}

}  // namespace

Source::Source(const std::filesystem::path& path, const RunContext& context)
    : file_(path.string()), context_(context) {
  InputFiles::opens(path);
  const Descriptor in(path.c_str());
  if (in.get() < 0) {
    const int error = errno;
    if (error == ENOENT || error == ENOTDIR) throw MissingFile(reason(error), file_);
    fail(reason(error));
  }
  struct stat info {};
  if (::fstat(in.get(), &info) != 0) fail(reason(errno));
  if (S_ISDIR(info.st_mode)) fail("is a folder; name a file in it");
  if (!S_ISREG(info.st_mode)) fail("is not a regular file; save the data to one first");
  const auto size = static_cast<std::size_t>(info.st_size);
  if (size == 0) fail("is empty; export the model again");
  if (size > half_of_memory()) {
    fail(fmt::format("holds {} bytes, more than half of this machine's memory", size));
  }
  data_ = std::make_unique_for_overwrite<char[]>(size + 1);
  constexpr std::size_t kPiece = std::size_t{8} << 20;  // a poll for cancellation every few ms
  while (size_ < size) {
    context.check();
    const ssize_t got = ::read(in.get(), data_.get() + size_, std::min(kPiece, size - size_));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(reason(errno));
    if (got == 0) break;  // the file shrank meanwhile
    size_ += static_cast<std::size_t>(got);
  }
  data_[size_] = '\0';
}

Source::Source(std::string file, std::string bytes, const RunContext& context)
    : file_(std::move(file)), size_(bytes.size()), context_(context) {
  data_ = std::make_unique_for_overwrite<char[]>(size_ + 1);
  std::memcpy(data_.get(), bytes.data(), size_);
  data_[size_] = '\0';
}

std::int64_t Source::line_of(const char* where) const {
  std::int64_t line = 1;
  for (const char* p = data_.get(); p < where; ++p) {
    line += *p == '\n' || (*p == '\r' && p[1] != '\n');
  }
  return line;
}

void Source::fail(const std::string& what) const { throw InputError(what, file_); }

void Source::fail_at_line(const char* where, const std::string& what) const {
  throw InputError(what, file_, line_of(where));
}

void Source::fail_at_byte(std::size_t offset, const std::string& what) const {
  throw InputError(fmt::format("at byte {}: {}", offset, what), file_);
}

}  // namespace burin
