#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/base/piped_input.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <mutex>
#include <system_error>

namespace burin {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;
constexpr int kOften = 20;  // ms between two looks at the context

class Pipe {
 public:
  explicit Pipe(const std::filesystem::path& path)
      : file_(path.string()),
        descriptor_(is_standard_input(path)
                        ? STDIN_FILENO
                        : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) fail(errno);
    if (::isatty(descriptor_) != 0) {
      throw InputError("is a terminal; pipe a model into the command, or name a file", file_);
    }
  }
  ~Pipe() {
    if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  std::string all(std::size_t most, const RunContext& context) const {
    std::string bytes;
    for (;;) {
      wait(context);
      const std::size_t had = bytes.size();
      bytes.resize(had + kPiece);
      const ssize_t got = ::read(descriptor_, bytes.data() + had, kPiece);
      const int error = errno;
      bytes.resize(had + static_cast<std::size_t>(got > 0 ? got : 0));
      if (got == 0) return bytes;
      if (got < 0 && error != EINTR && error != EAGAIN) fail(error);
      if (bytes.size() > most) {
        throw InputError(
            fmt::format("holds over {} bytes, more than half of this machine's memory", most),
            file_);
      }
    }
  }

 private:
  [[noreturn]] void fail(int error) const {
    throw InputError("cannot be read: " + std::generic_category().message(error), file_);
  }
  /// Until there is something to read, or the end.
  void wait(const RunContext& context) const {
    pollfd one{descriptor_, POLLIN, 0};
    do {
      context.check();
    } while (::poll(&one, 1, kOften) <= 0);
  }

  std::string file_;
  int descriptor_;
};

}  // namespace

bool is_piped(const std::filesystem::path& path) {
  if (is_standard_input(path)) return true;
  // One that a shell made. Others may have nobody who writes, and would be waited for without end.
  const std::string name = path.string();
  std::error_code error;
  return (name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/")) &&
         std::filesystem::status(path, error).type() == std::filesystem::file_type::fifo;
}

std::shared_ptr<const std::string> piped_input(const std::filesystem::path& path, std::size_t most,
                                               const RunContext& context) {
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const std::string>> kept;
  const std::lock_guard lock(mutex);
  auto& one = kept[is_standard_input(path) ? "-" : path.string()];
  if (!one) one = std::make_shared<const std::string>(Pipe(path).all(most, context));
  return one;
}

}  // namespace burin
