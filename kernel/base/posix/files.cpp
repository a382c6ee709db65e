#include <burin/base/input_files.h>
#include <burin/base/platform.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace burin {
namespace {

std::int64_t nanoseconds(const timespec& time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return time.tv_sec * kSecond + time.tv_nsec;
}

}  // namespace

FileStamp stamp_of(const std::filesystem::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return {};
  return {.there = true,
          .device = info.st_dev,
          .node = info.st_ino,
          .size = static_cast<std::uint64_t>(info.st_size),
          .changed = nanoseconds(info.st_mtim),
          .renewed = nanoseconds(info.st_ctim)};
}

}  // namespace burin

namespace burin::platform {

bool may_read(const std::filesystem::path& path) { return ::access(path.c_str(), R_OK) == 0; }
bool may_write(const std::filesystem::path& path) { return ::access(path.c_str(), W_OK) == 0; }
bool may_run(const std::filesystem::path& path) { return ::access(path.c_str(), X_OK) == 0; }

int open_to_read(const std::filesystem::path& path) {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}
int open_to_write(const std::filesystem::path& path) {
  return ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
}
int create_file(const std::filesystem::path& path) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}
bool close_file(int file) { return ::close(file) == 0; }

bool state_of(int file, FileState& state) {
  struct stat info {};
  if (::fstat(file, &info) != 0) return false;
  state.kind = S_ISREG(info.st_mode)   ? FileKind::Regular
               : S_ISDIR(info.st_mode) ? FileKind::Folder
                                       : FileKind::Other;
  state.size = static_cast<std::uint64_t>(info.st_size);
  return true;
}

std::ptrdiff_t read_some(int file, char* to, std::size_t most) {
  for (;;) {
    const ssize_t got = ::read(file, to, most);
    if (got >= 0 || errno != EINTR) return got;
  }
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(file, bytes.data(), bytes.size());
    if (done < 0 && errno != EINTR) return false;
    if (done > 0) bytes.remove_prefix(static_cast<std::size_t>(done));
  }
  return true;
}

bool read_content(int file, std::string& content, std::size_t most) {
  FileState state;
  if (!state_of(file, state)) return false;
  content.resize(static_cast<std::size_t>(std::min<std::uint64_t>(state.size, most)));
  for (std::size_t at = 0; at < content.size();) {
    const ssize_t n =
        ::pread(file, content.data() + at, content.size() - at, static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) errno = EIO;  // it shrank meanwhile
    if (n <= 0) return false;
    at += static_cast<std::size_t>(n);
  }
  return true;
}

bool replace_content(int file, std::string_view content) {
  if (::ftruncate(file, 0) != 0) return false;
  for (std::size_t at = 0; at < content.size();) {
    const ssize_t n =
        ::pwrite(file, content.data() + at, content.size() - at, static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace burin::platform
