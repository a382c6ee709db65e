#include <burin/base/error.h>
#include <burin/base/platform.h>
#include <burin/base/subprocess.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <string_view>

namespace burin::detail {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPollMs = 10;
constexpr double kShareOfMemory = 0.75;
// Seconds after which the bar of a run whose end nobody knows is half full.
constexpr double kHalfway = 10;
// Seconds after which the bar says what takes so long.
constexpr double kLong = 1;

class Pipe {
 public:
  Pipe() {
    if (::pipe2(end_.data(), O_CLOEXEC) != 0) throw Error(std::strerror(errno));
  }
  ~Pipe() {
    close(0);
    close(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int read_end() const { return end_[0]; }
  int write_end() const { return end_[1]; }
  void close(std::size_t i) {
    if (end_[i] >= 0) ::close(end_[i]);
    end_[i] = -1;
  }

 private:
  std::array<int, 2> end_{-1, -1};
};

/// What the child needs, made before the fork: after it only system calls are safe.
struct Prepared {
  std::vector<char*> argv, environment;
  const char* folder = nullptr;
  int input = -1, output = -1, failure = -1, file = -1;
  rlim_t memory = RLIM_INFINITY;
  pid_t parent = 0;
};

[[noreturn]] void fail_in_child(const Prepared& p) {
  const int error = errno;
  // Nobody to tell where this fails.
  if (::write(p.failure, &error, sizeof error) < 0) ::_exit(126);
  ::_exit(127);
}

[[noreturn]] void become(const Prepared& p) {
  ::setpgid(0, 0);
  // A parent that is killed takes the child along; it may be dead by now.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != p.parent) ::_exit(127);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGALRM}) ::signal(s, SIG_DFL);
  const rlimit memory{p.memory, p.memory}, no_core{0, 0};
  ::setrlimit(RLIMIT_AS, &memory);
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (::chdir(p.folder) != 0) fail_in_child(p);
  if (::dup2(p.input, 0) < 0 || ::dup2(p.output, 1) < 0 || ::dup2(p.output, 2) < 0)
    fail_in_child(p);
  if (p.file >= 0 && ::dup2(p.file, kSubprocessFile) < 0) fail_in_child(p);
  ::execvpe(p.argv[0], p.argv.data(), p.environment.data());
  fail_in_child(p);
}

/// The environment of this process with `added` in it, which has to stay; ends with nullptr.
std::vector<char*> environment_with(const std::vector<std::string>& added) {
  std::vector<char*> all;
  for (char** one = environ; one && *one; ++one) {
    const std::string_view known(*one);
    const std::string_view name = known.substr(0, known.find('=') + 1);
    const bool replaced = std::ranges::any_of(
        added, [&](const std::string& entry) { return entry.starts_with(name); });
    if (name.empty() || !replaced) all.push_back(*one);
  }
  for (const std::string& entry : added) all.push_back(const_cast<char*>(entry.c_str()));
  all.push_back(nullptr);
  return all;
}

/// A copy of a descriptor above those that the child rearranges.
int lifted(int descriptor) { return ::fcntl(descriptor, F_DUPFD_CLOEXEC, kSubprocessFile + 1); }

rlim_t memory_limit() {
  const auto bytes = static_cast<double>(platform::memory_bytes());
  return bytes > 0 ? static_cast<rlim_t>(kShareOfMemory * bytes) : RLIM_INFINITY;
}

/// The child, ended and waited for whatever happens.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() { end(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Whether it has ended by itself; the children that it leaves are ended.
  bool ended() {
    if (done_) return true;
    if (::waitpid(pid_, &status_, WNOHANG) != pid_) return false;
    ::kill(-pid_, SIGKILL);
    done_ = true;
    return true;
  }
  void end() {
    if (done_) return;
    ::kill(-pid_, SIGKILL);
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
    done_ = true;
  }
  int status() const { return status_; }

 private:
  pid_t pid_;
  int status_ = 0;
  bool done_ = false;
};

/// Cuts what is read into lines.
class Lines {
 public:
  explicit Lines(const std::function<void(const std::string&)>& take) : take_(take) {}
  void add(std::string_view bytes) {
    for (const char c : bytes) {
      if (c == '\n') {
        flush();
      } else if (line_.size() < kLongestLine) {
        line_ += c;
      }
    }
  }
  void flush() {
    if (!line_.empty() && take_) take_(line_);
    line_.clear();
  }

 private:
  const std::function<void(const std::string&)>& take_;
  std::string line_;
};

/// Reads what is there. Returns false at the end of the output.
bool drain(int descriptor, Lines& lines) {
  std::array<char, 1 << 14> buffer;
  // A program that floods its output must not keep the limits from being looked at.
  for (int round = 0; round < 16; ++round) {
    const ssize_t n = ::read(descriptor, buffer.data(), buffer.size());
    if (n > 0) {
      lines.add({buffer.data(), static_cast<std::size_t>(n)});
    } else {
      return n < 0 && (errno == EAGAIN || errno == EINTR);
    }
  }
  return true;
}

}  // namespace

MemoryFile::MemoryFile() : descriptor_(::memfd_create("burin", MFD_CLOEXEC)) {
  if (descriptor_ < 0) throw Error(std::string("no memory for a file: ") + std::strerror(errno));
}
MemoryFile::~MemoryFile() { ::close(descriptor_); }
std::size_t MemoryFile::size() const {
  struct stat info {};
  return ::fstat(descriptor_, &info) == 0 ? static_cast<std::size_t>(info.st_size) : 0;
}
void MemoryFile::clear() const {
  if (::ftruncate(descriptor_, 0) != 0) throw InputError("a file in memory cannot be emptied");
}
std::string MemoryFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

SubprocessEnd run_subprocess(const SubprocessRun& run, RunContext& context) {
  context.check();
  Prepared prepared;
  std::vector<std::string> words = run.arguments;
  for (std::string& word : words) prepared.argv.push_back(word.data());
  prepared.argv.push_back(nullptr);
  prepared.environment = environment_with(run.environment);
  prepared.folder = run.folder.empty() ? "." : run.folder.c_str();
  if (run.bounded) prepared.memory = memory_limit();
  prepared.parent = ::getpid();
  Pipe output, failure;
  // Opened anew, so that it is read from its beginning.
  const std::string from = run.input ? run.input->path() : "/dev/null";
  const int input = ::open(from.c_str(), O_RDONLY | O_CLOEXEC);
  prepared.input = lifted(input);
  prepared.output = lifted(output.write_end());
  prepared.failure = lifted(failure.write_end());
  if (run.file) prepared.file = lifted(run.file->descriptor());
  const pid_t pid = ::fork();
  if (pid == 0) become(prepared);
  const int fork_error = errno;
  for (const int d : {input, prepared.input, prepared.output, prepared.failure, prepared.file}) {
    if (d >= 0) ::close(d);
  }
  output.close(1);
  failure.close(1);
  SubprocessEnd end;
  if (pid < 0) {
    end.start_error = fork_error;
    return end;
  }
  ::setpgid(pid, pid);  // whichever of the two comes first
  Child child(pid);
  if (::read(failure.read_end(), &end.start_error, sizeof end.start_error) > 0) return end;
  end.start_error = 0;

  ::fcntl(output.read_end(), F_SETFL, O_NONBLOCK);
  Lines lines(run.line);
  const auto start = Clock::now();
  for (bool open = true; !child.ended();) {
    context.check();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds > run.timeout) {
      end.timed_out = true;
      break;
    }
    if (!run.reports_progress) {
      context.progress(seconds / (seconds + kHalfway), seconds > kLong ? run.doing : std::string());
    }
    pollfd event{open ? output.read_end() : -1, POLLIN, 0};
    if (::poll(&event, 1, kPollMs) > 0) open = drain(output.read_end(), lines);
  }
  child.end();
  for (int i = 0; i < 64 && drain(output.read_end(), lines); ++i) {
    pollfd event{output.read_end(), POLLIN, 0};
    if (::poll(&event, 1, 0) <= 0) break;
  }
  lines.flush();
  if (WIFSIGNALED(child.status())) end.signal = WTERMSIG(child.status());
  if (WIFEXITED(child.status())) end.status = WEXITSTATUS(child.status());
  return end;
}

}  // namespace burin::detail
