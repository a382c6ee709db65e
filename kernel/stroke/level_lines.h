#pragma once
// The lines on paper along which a phase is a whole number of turns.

#include "wave_phase.h"

#include <vector>

namespace burin::detail {

/// One of them, as far as it is seen: a guide for a stroke.
struct LevelLine {
  std::vector<Vec2> points;  // paper mm
  std::vector<float> gaps;   // paper mm to the next line, at each point
  bool closed = false;
  /// Whether it ends inside the surface, where one line less is needed, and not at its border.
  bool begin_inside = false, end_inside = false;
  /// 1 where it passes at a place where another one ends so, 0 eight gaps from there and farther.
  float beside_end = 0;
  std::uint32_t node = 0;   // one that it passes
  std::int64_t number = 0;  // whole turns; neighbours differ by one

  double length() const;
};

/// All of them, smoothed, those left out that are too short to be seen as lines.
std::vector<LevelLine> level_lines(const ViewRaster& raster, const WaveGraph& graph,
                                   const WavePhase& phase, const RunContext& context);

}  // namespace burin::detail
