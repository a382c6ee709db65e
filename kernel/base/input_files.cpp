#include <burin/base/input_files.h>

#include <sys/stat.h>

#include <algorithm>

namespace burin {
namespace {

thread_local InputFiles* g_listening = nullptr;

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

InputFiles::InputFiles() : outer_(g_listening) { g_listening = this; }

InputFiles::~InputFiles() { g_listening = outer_; }

void InputFiles::opens(const std::filesystem::path& path) {
  if (g_listening == nullptr) return;
  const FileStamp stamp = stamp_of(path);
  const std::string name = path.string();
  for (InputFiles* one = g_listening; one != nullptr; one = one->outer_) {
    one->stamps_.emplace(name, stamp);
  }
}

bool changed(const InputFiles::Stamps& stamps) {
  return std::ranges::any_of(stamps,
                             [](const auto& one) { return stamp_of(one.first) != one.second; });
}

}  // namespace burin
