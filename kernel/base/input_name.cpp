#include <burin/base/ascii.h>
#include <burin/base/input_name.h>

#include <array>
#include <string_view>
#include <utility>

namespace burin {
namespace {

// The innermost; readers ask by path alone.
thread_local GivenFormat* t_given = nullptr;

/// Suffixes of packed models, and what they are unpacked.
constexpr std::array<std::array<std::string_view, 2>, 2> kPacked{
    {{".stpz", ".stp"}, {".igsz", ".igs"}}};

std::filesystem::path unpacked_name(std::filesystem::path path) {
  while (lowered(path.extension().string()) == ".gz") path = path.stem();
  return path.filename();
}

}  // namespace

bool is_standard_input(const std::filesystem::path& path) {
  const std::string name = path.string();
  return name == "-" || name == "/dev/stdin" || name == "/dev/fd/0" || name == "/proc/self/fd/0";
}

std::string model_suffix(const std::filesystem::path& path) {
  if (t_given && t_given->path_ == path) return t_given->suffix_;
  if (is_standard_input(path)) return {};
  std::string suffix = lowered(unpacked_name(path).extension().string());
  for (const auto& [packed, plain] : kPacked) {
    if (suffix == packed) return std::string(plain);
  }
  return suffix;
}

std::string model_stem(const std::filesystem::path& path) {
  const bool piped = is_standard_input(path) || path.string().starts_with("/dev/fd/");
  return piped ? "stdin" : unpacked_name(path).stem().string();
}

GivenFormat::GivenFormat(std::filesystem::path path, std::string suffix)
    : path_(std::move(path)), suffix_(std::move(suffix)), outer_(t_given) {
  if (!suffix_.empty()) t_given = this;
}

GivenFormat::~GivenFormat() { t_given = outer_; }

}  // namespace burin
