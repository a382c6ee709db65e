#pragma once
// What a piece of a symbol may be; internal to the module, and needs nothing of the library.

#include <burin/plugin.h>

#include <cmath>
#include <cstddef>
#include <cstring>

namespace burin::plugin {

inline constexpr std::size_t kMostSymbolPieces = 10'000;

/// Paper mm within which everything of a symbol lies.
inline bool is_paper_place(double value) { return std::abs(value) <= 2000; }
inline bool is_paper_length(double value) { return value >= 0 && value <= 2000; }

/// What is wrong with points; null: nothing.
inline const char* points_fault(std::size_t least, std::size_t count, const double* points) {
  constexpr std::size_t kMost = 10'000;
  if (points == nullptr || count < least || count > kMost) {
    return "has a piece of too few or more than 10,000 points";
  }
  for (std::size_t i = 0; i < 2 * count; ++i) {
    if (!is_paper_place(points[i])) return "has a point that is no number or over 2000 mm away";
  }
  return nullptr;
}

inline const char* line_fault(std::size_t count, const double* points, double width) {
  if (!is_paper_length(width)) return "has a line without a width in mm";
  return points_fault(2, count, points);
}

inline const char* fill_fault(std::size_t rings, const std::size_t* counts, const double* points,
                              const char* color) {
  if (counts == nullptr || rings == 0 || rings > kMostSymbolPieces) {
    return "has a fill without rings";
  }
  std::size_t all = 0;
  for (std::size_t k = 0; k < rings; ++k) {
    if (counts[k] < 3 || counts[k] > kMostSymbolPieces) return "has a ring without an inside";
    all += counts[k];
  }
  if (const char* fault = points_fault(3, all, points)) return fault;
  if (color == nullptr) return "has a fill whose colour is not #rrggbb";
  if (color[0] == '\0') return nullptr;
  const std::size_t length = ::strnlen(color, 8);
  const bool hex =
      length == 7 && color[0] == '#' && std::strspn(color + 1, "0123456789abcdef") == length - 1;
  return hex ? nullptr : "has a fill whose colour is not #rrggbb";
}

inline const char* text_fault(double x, double y, double height, std::int32_t anchor,
                              const char* text) {
  constexpr std::size_t kLongest = 4096;
  const bool sized = is_paper_length(height) && height > 0;
  if (!is_paper_place(x) || !is_paper_place(y) || !sized || anchor < 0 || anchor > 2) {
    return "has a text whose place, height or anchor is none";
  }
  if (text == nullptr || ::strnlen(text, kLongest + 1) > kLongest ||
      std::strpbrk(text, "\n\r\t") != nullptr) {
    return "has a text that is not one line of up to 4096 bytes";
  }
  return nullptr;
}

inline const char* box_fault(const burin_symbol_box& box) {
  const bool sized =
      is_paper_length(box.width) && is_paper_length(box.height) && box.width > 0 && box.height > 0;
  if (!sized) return "has no width and height in mm";
  if (!(box.shoulder >= 0 && box.shoulder <= box.height)) return "has a shoulder off its side";
  return nullptr;
}

}  // namespace burin::plugin
