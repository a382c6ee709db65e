#include <burin/base/error.h>
#include <burin/base/platform.h>
#include <burin/converters/output.h>

#include "fd_stream.h"
#include "own_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <ostream>
#include <system_error>
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

/// Throws UsageError where the format is one of ours that Burin was built without.
void refuse_absent(const std::string& what, const std::string& format) {
  const std::string needed = detail::needed_to_write(format);
  if (!needed.empty()) throw UsageError(what + ": " + needed);
}

const Format& format_of(const std::string& output, const std::string& format) {
  const Format* asked = nullptr;
  if (!format.empty()) {
    asked = format_named(format);
    refuse_absent("option --format", format);
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
  if (!suffix.empty()) refuse_absent(output, suffix.substr(1));
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
  // Of what is not there yet weakly_canonical leaves "a" relative, and "./a" not.
  const auto place = [&](const std::string& name) {
    return fs::weakly_canonical(fs::absolute(name, error), error);
  };
  return place(a) == place(b);
}

void set_output_guard(const OutputGuard& guard) { g_guard = guard; }

Output::Output(std::string name, const Format& format)
    : name_(std::move(name)), format_(&format), target_(resolved(name_)) {
  static std::atomic<int> count{0};
  aside_ = (target_.parent_path() /
            fmt::format(".burin-{}-{}.part", platform::process_number(), ++count))
               .string();
}

Output::Output(Output&& other) noexcept
    : name_(std::move(other.name_)),
      format_(other.format_),
      target_(std::move(other.target_)),
      aside_(std::move(other.aside_)),
      written_aside_(std::exchange(other.written_aside_, false)) {}

Output::~Output() { discard(); }

void Output::remove_aside() const {
  std::error_code error;
  fs::remove(aside_, error);
  released(aside_.c_str());
}

void Output::discard() {
  if (!written_aside_) return;
  remove_aside();
  written_aside_ = false;
}

bool Output::is_direct() const {
  std::error_code error;
  const fs::file_status target = fs::status(target_, error);
  return is_stdout() || (fs::exists(target) && !fs::is_regular_file(target));
}

int Output::open_aside() const {
  const int fd = platform::create_file(aside_);
  if (fd >= 0) return fd;
  const int error = errno;
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
  std::error_code unknown;
  // A folder of the system's own, such as /proc, is there and takes no file.
  if (error == ENOENT && fs::is_directory(folder, unknown)) {
    throw OutputError("this folder takes no files; choose another", name_);
  }
  fail(name_, error);
}

void Output::probe() const {
  if (is_stdout()) return;
  std::error_code error;
  const fs::file_status target = fs::status(target_, error);
  if (fs::is_directory(target)) fail(name_, EISDIR);
  if (fs::exists(target) && !platform::may_write(target_)) fail(name_, errno);
  if (is_direct()) return;
  guarded(aside_.c_str());
  try {
    platform::close_file(open_aside());
  } catch (...) {
    remove_aside();
    throw;
  }
  remove_aside();
}

void Output::write(const std::function<void(std::ostream&)>& body) {
  int fd = platform::kStandardOutput;
  const bool direct = is_direct();
  if (!direct) {
    written_aside_ = true;
    guarded(aside_.c_str());
    fd = open_aside();
    std::error_code error;
    const fs::file_status target = fs::status(target_, error);
    // A file that is replaced keeps its permissions.
    if (fs::exists(target)) fs::permissions(aside_, target.permissions(), error);
  } else if (!is_stdout()) {
    fd = platform::open_to_write(target_);
    if (fd < 0) fail(name_, errno);
  }
  FdBuffer buffer(fd);
  std::ostream out(&buffer);
  const auto close = [&] { return is_stdout() || platform::close_file(fd); };
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
  std::error_code error;
  fs::rename(aside_, target_, error);
  if (error) fail(name_, error.value());
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
