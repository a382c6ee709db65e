#pragma once
// How a stroke under way keeps to the level line that it is drawn for.

#include "level_lines.h"

namespace burin::detail {

struct StrokeSample;

/// Goes along a level line with a stroke, one way.
class Guide {
 public:
  /// From the point of that number; `way` is 1 or -1.
  Guide(const LevelLine& line, std::size_t start, int way) : line_(&line), at_(start), way_(way) {}

  struct Heading {
    double off = 0;         // paper mm that the stroke is to the left of the line
    Vec2 ahead{0};          // unit: towards a place of the line a little further on
    double gap = 0;         // paper mm to the next line
    bool past = false;      // beyond the line's end
    bool inside = false;    // ... which lies inside the surface: the stroke is to end there
    double beside_end = 0;  // as of the line
  };
  /// At a place of the stroke, not before the last one that was asked for.
  Heading at(Vec2 paper);

 private:
  std::size_t size() const { return line_->points.size(); }
  bool last(std::size_t i) const { return !line_->closed && (way_ > 0 ? i + 1 >= size() : i == 0); }
  std::size_t next(std::size_t i) const {
    return way_ > 0 ? (i + 1) % size() : (i + size() - 1) % size();
  }

  const LevelLine* line_;
  std::size_t at_;
  int way_;
};

/// The tangent (model space) with which a stroke goes on that is to keep to its level line, where
/// the field says `tangent`: that, turned a little, where the field is exact, the surface flat or
/// seen at a slant; else along the line.
Vec3 steer(const Picture& picture, std::int32_t part, const StrokeSample& at, Vec3 tangent,
           const Guide::Heading& heading);

/// The tangent of a stroke that is to be `left` paper mm further to the left soon, turned no
/// more than strokes turn off an exact field.
Vec3 turned_by(const Picture& picture, const StrokeSample& at, double left);

}  // namespace burin::detail
