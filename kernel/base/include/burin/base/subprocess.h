#pragma once
/// A program that is run to its end, to a time limit or to a cancellation.

#include <burin/base/run_context.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace burin::detail {

/// A nameless file in memory.
class MemoryFile {
 public:
  /// Throws InputError where the system gives none.
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }
  std::size_t size() const;
  /// Takes its bytes away.
  void clear() const;
  /// Under which this process can open it.
  std::string path() const;

 private:
  int descriptor_ = -1;
};

/// The descriptor under which a child finds its MemoryFile.
inline constexpr int kSubprocessFile = 3;

struct SubprocessRun {
  /// argv[0] is the program: a path where it holds a slash, else looked up on PATH.
  std::vector<std::string> arguments;
  std::string folder;
  /// "NAME=value": beside what this process has in its environment, or in place of it.
  std::vector<std::string> environment = {};
  /// Handed to the child as kSubprocessFile; nullptr = none.
  const MemoryFile* file = nullptr;
  /// What it reads on its standard input; nullptr = nothing.
  const MemoryFile* input = nullptr;
  double timeout = 10;
  /// Whether it may have three quarters of the machine's memory at the most.
  bool bounded = true;
  /// Its lines tell how far it is: nothing else calls RunContext::progress.
  bool reports_progress = false;
  /// What it does, for the progress of a run that takes longer than a second.
  std::string doing = {};
  /// Each line of its output and of its errors, at most kLongestLine bytes of it.
  std::function<void(const std::string& line)> line;
};

inline constexpr std::size_t kLongestLine = 4000;

struct SubprocessEnd {
  /// errno where the program could not be started, else 0.
  int start_error = 0;
  bool timed_out = false;
  /// The signal that ended it, else 0, and its exit status.
  int signal = 0;
  int status = 0;
  bool ok() const { return start_error == 0 && !timed_out && signal == 0 && status == 0; }
};

/// Runs a program in a process group of its own. Group and child are gone
/// when this returns or throws. Polls `context` every 10 ms; throws Cancelled.
SubprocessEnd run_subprocess(const SubprocessRun& run, RunContext& context);

}  // namespace burin::detail
