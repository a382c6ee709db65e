#include <burin/base/error.h>
#include <burin/converters/output.h>

#include "fd_stream.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <ostream>
#include <utility>

namespace burin {
namespace {

namespace fs = std::filesystem;

OutputGuard g_guard;

void guarded(const char* path) {
  if (g_guard.guard) g_guard.guard(path);
}
void released(const char* path) {
  if (g_guard.release) g_guard.release(path);
}

std::string advice(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "the disk is full; free some space";
    case EACCES:
    case EPERM:
      return "no permission to write here; choose another folder";
    case EROFS:
      return "the file system is read-only; choose another folder";
    case ENOENT:
      return "the folder does not exist; make it first";
    case ENOTDIR:
      return "a part of the path is no folder; choose another";
    case EISDIR:
      return "this is a folder; name a file";
    case ELOOP:
      return "the link leads to itself; remove it, or name a file";
    case EPIPE:
      return "the reader of the pipe is gone";
    default:
      return std::string("cannot be written: ") + std::strerror(error);
  }
}

[[noreturn]] void fail(const std::string& name, int error) {
  throw OutputError(advice(error), name == "-" ? "standard output" : name);
}

const Format& format_of(const std::string& output, const std::string& format) {
  const Format* asked = nullptr;
  if (!format.empty()) {
    asked = format_named(format);
    if (!asked)
      throw UsageError(fmt::format("option --format takes {}, not '{}'", format_list(), format));
  }
  if (output == "-") {
    if (asked) return *asked;
    throw UsageError("output to - (standard output) needs --format: " + format_list());
  }
  const std::string suffix = fs::path(output).extension().string();
  const Format* named = suffix.empty() ? nullptr : format_named(suffix.substr(1));
  if (named) return *named;
  if (asked) return *asked;
  throw UsageError(fmt::format("{}: {} does not name a format that burin writes; use {}", output,
                               suffix.empty() ? "a name without suffix" : suffix, format_list()));
}

/// Where a link points to, also where nothing stands there yet: the link stays, the file behind it
/// is made or replaced.
fs::path resolved(const std::string& name) {
  constexpr int kMostLinks = 40;  // as Linux has it; more are most likely a ring
  std::error_code error;
  fs::path path = name;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i) {
    const fs::path target = fs::read_symlink(path, error);
    if (error) fail(name, error.value());
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  if (fs::is_symlink(path, error)) fail(name, ELOOP);
  return path;
}

}  // namespace

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

void set_output_guard(const OutputGuard& guard) { g_guard = guard; }

Output::Output(std::string name, const Format& format)
    : name_(std::move(name)), format_(&format), target_(resolved(name_)) {
  static std::atomic<int> count{0};
  aside_ = (target_.parent_path() / fmt::format(".burin-{}-{}.part", ::getpid(), ++count)).string();
}

Output::Output(Output&& other) noexcept
    : name_(std::move(other.name_)),
      format_(other.format_),
      target_(std::move(other.target_)),
      aside_(std::move(other.aside_)),
      written_aside_(std::exchange(other.written_aside_, false)) {}

Output::~Output() { discard(); }

void Output::discard() {
  if (!written_aside_) return;
  ::unlink(aside_.c_str());
  released(aside_.c_str());
  written_aside_ = false;
}

bool Output::is_direct() const {
  struct stat info {};
  return is_stdout() || (::stat(target_.c_str(), &info) == 0 && !S_ISREG(info.st_mode));
}

int Output::open_aside() const {
  const int fd = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0) fail(name_, errno);
  return fd;
}

void Output::probe() const {
  if (is_stdout()) return;
  struct stat info {};
  if (::stat(target_.c_str(), &info) == 0) {
    if (S_ISDIR(info.st_mode)) fail(name_, EISDIR);
    if (::access(target_.c_str(), W_OK) != 0) fail(name_, errno);
  }
  if (is_direct()) return;
  guarded(aside_.c_str());
  const auto undo = [this] {
    ::unlink(aside_.c_str());
    released(aside_.c_str());
  };
  try {
    ::close(open_aside());
  } catch (...) {
    undo();
    throw;
  }
  undo();
}

void Output::write(const std::function<void(std::ostream&)>& body) {
  int fd = STDOUT_FILENO;
  const bool direct = is_direct();
  if (!direct) {
    written_aside_ = true;
    guarded(aside_.c_str());
    fd = open_aside();
    struct stat info {};
    // A file that is replaced keeps its permissions.
    if (::stat(target_.c_str(), &info) == 0) ::fchmod(fd, info.st_mode & 07777);
  } else if (!is_stdout()) {
    fd = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd < 0) fail(name_, errno);
  }
  FdBuffer buffer(fd);
  std::ostream out(&buffer);
  const auto close = [&] { return is_stdout() || ::close(fd) == 0; };
  try {
    body(out);
  } catch (...) {
    close();
    throw;
  }
  out.flush();
  const bool closed = close();
  if (buffer.error() != 0) fail(name_, buffer.error());
  if (!closed) fail(name_, errno);
}

void Output::commit() {
  if (!written_aside_) return;
  if (::rename(aside_.c_str(), target_.c_str()) != 0) fail(name_, errno);
  released(aside_.c_str());
  written_aside_ = false;
}

std::vector<Output> plan_outputs(const std::vector<std::string>& names, const std::string& format,
                                 const std::vector<std::string>& sources) {
  std::vector<Output> outputs;
  for (const std::string& name : names) {
    if (name.empty()) throw UsageError("option --output takes a file name, not ''");
    const Format& chosen = format_of(name, format);
    for (const std::string& source : sources) {
      if (name != "-" && same_file(name, source)) {
        throw UsageError(fmt::format("{}: is also an input; give the output another name", name));
      }
    }
    for (const Output& other : outputs) {
      const bool both =
          name == "-" || other.is_stdout() ? name == other.name() : same_file(name, other.name());
      if (both) throw UsageError(fmt::format("{}: is given twice as output; name it once", name));
    }
    outputs.emplace_back(name, chosen);
  }
  return outputs;
}

}  // namespace burin
