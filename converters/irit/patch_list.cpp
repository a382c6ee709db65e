// Plain lists of bicubic Bezier patches over shared points, in the two layouts that teapots are
// handed on in.
#include "patches.h"
#include "words.h"

#include <array>

namespace burin::irit {
namespace {

/// Two counts, of points and patches; the points, each after its number; the patches.
bool is_numbered(std::string_view text) {
  constexpr std::int64_t kLookedAt = 8;
  Words in(text);
  const auto points = whole(in.next()), patches = whole(in.next());
  if (!points || !patches || *points < 4 || *patches < 1) return false;
  for (std::int64_t i = 1; i <= std::min(*points, kLookedAt); ++i) {
    if (whole(in.next()) != i) return false;
    double unused = 0;
    for (int k = 0; k < 3; ++k) {
      if (!parse_double(in.next(), unused)) return false;
    }
  }
  return true;
}

/// The number of patches alone on its line, a line of 16 numbers of points a patch, the number of
/// points, the points; commas between numbers.
bool is_classic(std::string_view text) {
  Words in(text, true);
  const auto patches = whole(in.next());
  if (!patches || *patches < 1 || !in.at_line_end()) return false;
  for (int k = 0; k < 16; ++k) {
    const auto n = whole(in.next());
    if (!n || *n < 1 || in.at_line_end() != (k == 15)) return false;
  }
  return true;
}

class PatchListReader {
 public:
  explicit PatchListReader(const Source& source)
      : source_(source), in_(source.bytes(), is_classic(source.bytes())) {}
  std::vector<NurbsData> read();

 private:
  std::size_t count(const char* what, std::size_t bytes_each);
  void points(std::size_t n, bool numbered);
  void patches(std::size_t n);
  std::vector<NurbsData> make() const;

  const Source& source_;
  Words in_;
  std::vector<Vec3> points_;
  /// As they stand in the file, for errors.
  std::vector<std::array<std::string_view, 16>> patches_;
};

std::size_t PatchListReader::count(const char* what, std::size_t bytes_each) {
  const std::string_view word = in_.next();
  const auto n = whole(word);
  if (!n || *n < 1) expected(source_, word, what);
  if (static_cast<std::size_t>(*n) > in_.left() / bytes_each + 1) {
    fail_at(source_, word.data(),
            fmt::format("{}, {}, cannot fit into the {} bytes that follow; the file is truncated "
                        "or damaged",
                        what, *n, in_.left()));
  }
  return static_cast<std::size_t>(*n);
}

void PatchListReader::points(std::size_t n, bool numbered) {
  points_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    source_.context().check();
    if (numbered) {
      const std::string_view word = in_.next();
      if (whole(word) != static_cast<std::int64_t>(i + 1)) {
        expected(source_, word, fmt::format("the number of point {}", i + 1));
      }
    }
    for (int k = 0; k < 3; ++k) points_[i][k] = number(source_, in_, "a coordinate");
  }
}

void PatchListReader::patches(std::size_t n) {
  patches_.resize(n);
  for (auto& patch : patches_) {
    source_.context().check();
    for (std::string_view& word : patch) {
      word = in_.next();
      if (!whole(word)) expected(source_, word, "the number of a point");
    }
  }
}

std::vector<NurbsData> PatchListReader::make() const {
  std::vector<NurbsData> list;
  for (const auto& patch : patches_) {
    std::vector<Vec3> corners;
    for (const std::string_view word : patch) {
      const auto n = whole(word);
      if (!n || *n < 1 || *n > static_cast<std::int64_t>(points_.size())) {
        expected(source_, word, fmt::format("the number of a point, 1 to {}", points_.size()));
      }
      corners.push_back(points_[static_cast<std::size_t>(*n - 1)]);
    }
    list.push_back(bezier_patch(3, 3, std::move(corners)));
  }
  return list;
}

std::vector<NurbsData> PatchListReader::read() {
  constexpr std::size_t kNumberedBytes = 8, kPointBytes = 6, kPatchBytes = 32;  // "1 0 0 0 " ...
  if (is_classic(source_.bytes())) {
    patches(count("the number of patches", kPatchBytes));
    points(count("the number of points", kPointBytes), false);
  } else {
    const std::size_t n = count("the number of points", kNumberedBytes);
    const std::size_t patch_count = count("the number of patches", kPatchBytes);
    points(n, true);
    patches(patch_count);
  }
  const std::string_view rest = in_.next();
  if (!rest.empty()) {
    fail_at(source_, rest.data(),
            fmt::format("{} follows the end of the list; check its counts", in_quotes(rest)));
  }
  return make();
}

}  // namespace

bool is_patch_list(std::string_view text) { return is_numbered(text) || is_classic(text); }

std::vector<NurbsData> read_patch_list(const Source& source) {
  return PatchListReader(source).read();
}

}  // namespace burin::irit
