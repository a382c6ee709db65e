#pragma once
/// Runs the real command, as a user does.

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

extern "C" char** environ;

namespace burin::test {

inline std::string slurp(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// An empty folder of its own that goes with the object.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "burin-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  /// How many files it holds, hidden ones too.
  std::size_t count() const {
    std::size_t n = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      n += entry.exists() ? 1 : 0;
    }
    return n;
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }

 private:
  std::filesystem::path path_;
};

/// A run of the command whose output goes to files of a folder.
class Command {
 public:
  Command(const Folder& folder, std::vector<std::string> arguments, const std::string& out = "")
      : out_(out.empty() ? folder / ".stdout" : out), err_(folder / ".stderr") {
    arguments.insert(arguments.begin(), BURIN_COMMAND);
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&files, 2, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (::posix_spawn(&pid_, argv[0], &files, nullptr, argv.data(), environ) != 0) pid_ = -1;
    posix_spawn_file_actions_destroy(&files);
  }
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  ~Command() { wait(); }

  void signal(int number) const { ::kill(pid_, number); }

  /// The exit status, or 1000 + the signal that ended it.
  int wait() {
    if (pid_ > 0) {
      int status = 0;
      ::waitpid(pid_, &status, 0);
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
    for (int i = 0; i < 3000; ++i) {
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

 private:
  std::string out_, err_;
  pid_t pid_ = 0;
  int status_ = -1;
};

}  // namespace burin::test
