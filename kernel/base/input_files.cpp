#include <burin/base/input_files.h>

#include <algorithm>

namespace burin {
namespace {

thread_local InputFiles* g_listening = nullptr;

}  // namespace

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
