#include "patches.h"

#include "lexer.h"
#include "split.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace burin::irit {
namespace {

/// The words of a text in which # begins a comment to the end of the line.
class Words {
 public:
  explicit Words(std::string_view text) : p_(text.data()), end_(p_ + text.size()) {}

  /// Empty at the end.
  std::string_view next() {
    for (; p_ < end_ && (is_blank(*p_) || is_line_end(*p_) || *p_ == '#'); ++p_) {
      if (*p_ == '#') p_ = std::find_if(p_, end_, is_line_end);
      if (p_ == end_) break;
    }
    const char* begin = p_;
    while (p_ < end_ && !is_blank(*p_) && !is_line_end(*p_) && *p_ != '#') ++p_;
    return {begin, static_cast<std::size_t>(p_ - begin)};
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - p_); }

 private:
  const char* p_;
  const char* end_;
};

std::optional<std::int64_t> whole(std::string_view word) {
  std::int64_t value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (word.empty() || error != std::errc() || stop != end) return std::nullopt;
  return value;
}

[[noreturn]] void expected(const Source& source, std::string_view found, const std::string& what) {
  if (found.empty()) {
    fail_at(source, found.data(),
            fmt::format("the file ends where {} should be; it is truncated", what));
  }
  fail_at(source, found.data(), fmt::format("{} is not {}", in_quotes(found), what));
}

double number(const Source& source, Words& in, const char* what) {
  const std::string_view word = in.next();
  double value = 0;
  if (!parse_double(word, value) || !std::isfinite(value)) expected(source, word, what);
  return value;
}

/// What a header of Geomview says: [C]BEZ<degree u><degree v><dimension>[_ST] or [ST]BBP.
struct Header {
  int degree_u = 3, degree_v = 3;
  bool rational = false;
  int extras = 0;  // numbers after each patch: colours, texture coordinates of its corners
};

std::optional<Header> header_of(std::string_view word) {
  constexpr int kTexture = 8, kColors = 16;
  Header header;
  if (word == "BBP") return header;
  header.extras = kTexture;
  if (word == "STBBP") return header;
  header.extras = word.starts_with('C') ? kColors : 0;
  if (word.starts_with('C')) word.remove_prefix(1);
  if (word.ends_with("_ST")) {
    header.extras += kTexture;
    word.remove_suffix(3);
  }
  const auto digit = [&](std::size_t i) { return word[i] - '0'; };
  if (word.size() != 6 || !word.starts_with("BEZ")) return std::nullopt;
  if (digit(3) < 1 || digit(3) > 6 || digit(4) < 1 || digit(4) > 6) return std::nullopt;
  if (digit(5) != 3 && digit(5) != 4) return std::nullopt;
  header.degree_u = digit(3);
  header.degree_v = digit(4);
  header.rational = digit(5) == 4;
  return header;
}

/// The file has u fastest, patches v.
HomogeneousPatch read_patch(const Source& source, Words& in, const Header& header) {
  HomogeneousPatch patch{header.degree_u, header.degree_v, {}};
  const auto nu = static_cast<std::size_t>(header.degree_u + 1);
  const auto nv = static_cast<std::size_t>(header.degree_v + 1);
  patch.points.resize(nu * nv);
  for (std::size_t j = 0; j < nv; ++j) {
    for (std::size_t i = 0; i < nu; ++i) {
      glm::dvec4& p = patch.points[i * nv + j];
      for (int k = 0; k < 3; ++k) p[k] = number(source, in, "a coordinate");
      p.w = header.rational ? number(source, in, "a weight") : 1;
    }
  }
  for (int k = 0; k < header.extras; ++k) number(source, in, "a colour or texture coordinate");
  return patch;
}

}  // namespace

bool is_geomview(std::string_view text) { return header_of(Words(text).next()).has_value(); }

bool is_patch_list(std::string_view text) {
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

std::vector<NurbsData> read_geomview(const Source& source) {
  Words in(source.bytes());
  const std::string_view word = in.next();
  const std::optional<Header> header = header_of(word);
  if (!header) expected(source, word, "a header of Bezier patches, as BBP or BEZ334");
  std::vector<NurbsData> patches;
  for (;;) {
    source.context().check();
    Words ahead = in;
    const std::string_view first = ahead.next();
    if (first.empty()) break;
    const HomogeneousPatch patch = read_patch(source, in, *header);
    if (!append_positive(patch, patches)) {
      fail_at(source, first.data(),
              "this patch has points at infinity (weights that are not positive); export it again");
    }
  }
  return patches;
}

std::vector<NurbsData> read_patch_list(const Source& source) {
  constexpr std::size_t kPointBytes = 8, kPatchBytes = 32;  // "1 0 0 0 ", sixteen times "1 "
  Words in(source.bytes());
  const auto count = [&](const char* what, std::size_t bytes_each) {
    const std::string_view word = in.next();
    const auto n = whole(word);
    if (!n || *n < 1) expected(source, word, what);
    if (static_cast<std::size_t>(*n) > in.left() / bytes_each + 1) {
      fail_at(source, word.data(),
              fmt::format("{}, {}, cannot fit into the {} bytes that follow; the file is truncated "
                          "or damaged",
                          what, *n, in.left()));
    }
    return static_cast<std::size_t>(*n);
  };
  const std::size_t points = count("the number of points", kPointBytes);
  const std::size_t patches = count("the number of patches", kPatchBytes);
  std::vector<Vec3> position(points);
  for (std::size_t i = 0; i < points; ++i) {
    source.context().check();
    const std::string_view word = in.next();
    const std::string due = fmt::format("the number of point {}", i + 1);
    if (whole(word) != static_cast<std::int64_t>(i + 1)) expected(source, word, due);
    for (int k = 0; k < 3; ++k) position[i][k] = number(source, in, "a coordinate");
  }
  std::vector<NurbsData> list;
  for (std::size_t i = 0; i < patches; ++i) {
    source.context().check();
    std::vector<Vec3> corners;
    for (int k = 0; k < 16; ++k) {
      const std::string_view word = in.next();
      const auto n = whole(word);
      if (!n || *n < 1 || *n > static_cast<std::int64_t>(points)) {
        expected(source, word, fmt::format("the number of a point, 1 to {}", points));
      }
      corners.push_back(position[static_cast<std::size_t>(*n - 1)]);
    }
    list.push_back(bezier_patch(3, 3, std::move(corners)));
  }
  const std::string_view rest = in.next();
  if (!rest.empty()) {
    fail_at(source, rest.data(),
            fmt::format("{} stands after the last patch; is the number of patches right?",
                        in_quotes(rest)));
  }
  return list;
}

}  // namespace burin::irit
