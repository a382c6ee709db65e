#pragma once
/// Runs the real command, as a user does.

#include <burin_test/folder.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

extern "C" char** environ;

namespace burin::test {

/// A run of the command whose output goes to files of a folder, with a file as standard input.
class Command {
 public:
  Command(const Folder& folder, std::vector<std::string> arguments, const std::string& out = "",
          const std::string& in = "/dev/null")
      : out_(out.empty() ? folder / ".stdout" : out), err_(folder / ".stderr") {
    arguments.insert(arguments.begin(), BURIN_COMMAND);
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, in.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&files, 2, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (::posix_spawn(&pid_, argv[0], &files, nullptr, argv.data(), environ) != 0) pid_ = -1;
    posix_spawn_file_actions_destroy(&files);
  }
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  ~Command() { wait(); }

  void signal(int number) const {
    if (pid_ > 0) ::kill(pid_, number);  // 0 would be this program and all beside it
  }

  /// The exit status, or 1000 + the signal that ended it.
  int wait() {
    if (pid_ > 0) {
      int status = 0;
      rusage used{};
      ::wait4(pid_, &status, 0, &used);
      peak_megabytes = static_cast<double>(used.ru_maxrss) / 1024;
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
      pid_ = 0;
      std::error_code error;
      if (std::filesystem::is_regular_file(out_)) {
        std_out = slurp(out_);
        std::filesystem::remove(out_, error);
      }
      std_err = slurp(err_);
      std::filesystem::remove(err_, error);
    }
    return status_;
  }

  /// Waits until the run has said `text` on standard error; false where it ended before.
  bool wait_for(const std::string& text) const {
    for (int i = 0; i < 30000; ++i) {  // a minute: another program may have the machine
      if (slurp(err_).find(text) != std::string::npos) return true;
      siginfo_t info{};
      if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
          info.si_pid == pid_) {
        return slurp(err_).find(text) != std::string::npos;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }

  std::string std_out, std_err;
  /// Of memory, at the most; 0 until it was waited for.
  double peak_megabytes = 0;

 private:
  std::string out_, err_;
  pid_t pid_ = 0;
  int status_ = -1;
};

}  // namespace burin::test
