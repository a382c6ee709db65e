#include "long_lists.h"

#include <algorithm>
#include <cstddef>

namespace burin {
namespace {

// Characters of a list from which on it is shortened.
constexpr std::size_t kLong = 1000;

/// The place behind the string that begins at `at`.
std::size_t behind_string(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\'', at + 1);
  return end == std::string_view::npos ? text.size() : end + 1;
}

/// Walks over the parameters of one entity and blanks what its long lists hold beside their first
/// entries.
class Shortened {
 public:
  explicit Shortened(std::string& text) : text_(text) {}

  /// `at`: the parenthesis that opens the parameters. Returns the place behind the one that closes
  /// them.
  std::size_t parameters(std::size_t at) {
    int depth = 0;
    std::size_t comma = std::string::npos;  // the first one in a list of this depth
    for (; at < text_.size(); ++at) {
      const char c = text_[at];
      if (c == '\'') {
        at = behind_string(text_, at) - 1;
      } else if (c == ';') {
        return at;  // a parenthesis is missing; OCCT says so
      } else if (c == '(') {
        if (++depth == 2) comma = std::string::npos;
      } else if (c == ',' && depth == 2) {
        comma = std::min(comma, at);
      } else if (c == ')') {
        if (depth == 2 && comma != std::string::npos) blank(comma, at);
        if (--depth == 0) return at + 1;
      }
    }
    return at;
  }
  bool changed() const { return changed_; }

 private:
  void blank(std::size_t begin, std::size_t end) {
    if (end - begin < kLong) return;
    changed_ = true;
    for (std::size_t i = begin; i < end; ++i) {
      if (text_[i] != '\n' && text_[i] != '\r') text_[i] = ' ';
    }
  }

  std::string& text_;
  bool changed_ = false;
};

bool is_type(char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

std::string without_triangle_lists(std::string_view text) {
  constexpr std::string_view kCorners = "COORDINATES_LIST", kTriangles = "TRIANGULATED_";
  const auto has = [&](std::string_view type) { return text.find(type) != std::string_view::npos; };
  if (!has(kCorners) && !has(kTriangles)) return {};
  std::string out(text);
  Shortened shortened(out);
  std::size_t at = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '\'') {
      at = behind_string(text, at);
    } else if (!is_type(c)) {
      ++at;
    } else {
      std::size_t end = at;
      while (end < text.size() && is_type(text[end])) ++end;
      const std::string_view type = text.substr(at, end - at);
      at = std::min(text.find_first_not_of(" \t\r\n", end), text.size());
      const bool triangles = type == kCorners || type.find(kTriangles) != std::string_view::npos;
      if (triangles && at < text.size() && text[at] == '(') at = shortened.parameters(at);
    }
  }
  return shortened.changed() ? out : std::string();
}

}  // namespace burin
