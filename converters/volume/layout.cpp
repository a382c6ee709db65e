#include "layout.h"

#include <burin/base/platform.h>

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace volume {
namespace {

struct TypeRow {
  const char* name;
  std::size_t bytes;
};
// In the order of SampleType.
constexpr TypeRow kTypes[] = {{"i8", 1},  {"u8", 1},  {"i16", 2}, {"u16", 2}, {"i32", 4},
                              {"u32", 4}, {"i64", 8}, {"u64", 8}, {"f32", 4}, {"f64", 8}};

double memory_bytes() {
  const std::uint64_t memory = platform::memory_bytes();
  return memory == 0 ? 4e9 : static_cast<double>(memory);
}

std::string times(const std::array<std::int64_t, 3>& size) {
  return fmt::format("{} x {} x {}", size[0], size[1], size[2]);
}

void check_steps(const Layout& layout, const std::string& file) {
  // Of the product of the edges: flatter than this no direction of the three is left.
  constexpr double kFlat = 1e-6;
  // As for meshes: squares of squares of coordinates stay finite.
  constexpr double kLargest = 1e60;
  double edges = 1, far = 0;
  for (int k = 0; k < 3; ++k) {
    edges *= glm::length(layout.steps[k]);
    far = std::max({far, std::abs(layout.origin[k]),
                    glm::length(layout.steps[k]) * static_cast<double>(layout.size[k])});
  }
  if (!(far <= kLargest) || !(std::abs(glm::determinant(layout.steps)) > kFlat * edges)) {
    throw InputError(
        "the steps from sample to sample are no three directions of space; the header is damaged",
        file);
  }
}

}  // namespace

std::size_t bytes_of(SampleType type) { return kTypes[static_cast<std::size_t>(type)].bytes; }
const char* name_of(SampleType type) { return kTypes[static_cast<std::size_t>(type)].name; }

std::optional<SampleType> type_of(std::string_view word) {
  for (std::size_t i = 0; i < std::size(kTypes); ++i) {
    if (word == kTypes[i].name) return static_cast<SampleType>(i);
  }
  return std::nullopt;
}

double mm_of(std::string_view unit) {
  const std::string word = lowered(unit);
  if (word == "m" || word == "meter" || word == "meters") return 1e3;
  if (word == "cm" || word == "centimeter" || word == "centimeters") return 10;
  if (word == "um" || word == "micron" || word == "microns" || word == "\xc2\xb5m") return 1e-3;
  if (word == "nm") return 1e-6;
  return 1;
}

void check_layout(const Layout& layout, const std::string& file) {
  constexpr std::int64_t kLongest = 1 << 20;
  for (const std::int64_t n : layout.size) {
    if (n >= 2 && n <= kLongest) continue;
    const char* what = n < 1   ? "no size of a volume"
                       : n < 2 ? "a flat image; a volume has two samples or more along each axis"
                               : "more samples in a row than any volume has";
    throw InputError(fmt::format("{} samples are {}", times(layout.size), what), file,
                     layout.size_line);
  }
  const double most = memory_bytes() / 4 / sizeof(float);
  if (layout.samples() > most) {
    throw InputError(fmt::format("{} samples are more than the {:.0f} million that fit into a "
                                 "quarter of this machine's memory; reduce the volume",
                                 times(layout.size), most / 1e6),
                     file, layout.size_line);
  }
  check_steps(layout, file);
}

std::filesystem::path beside(const Head& head, const std::string& name, std::int64_t line) {
  std::filesystem::path path(name);
  if (path.is_relative()) path = head.path.parent_path() / path;
  std::error_code error;
  if (std::filesystem::equivalent(path, head.path, error)) {
    throw InputError(fmt::format("names itself, {}, as the file of its data", in_quotes(name)),
                     head.source.file(), line);
  }
  if (!std::filesystem::is_regular_file(path, error)) {
    throw InputError(fmt::format("the file of its data, {}, is not there; put it beside the header",
                                 in_quotes(name)),
                     head.source.file(), line);
  }
  return path;
}

}  // namespace volume
}  // namespace burin
