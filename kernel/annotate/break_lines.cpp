#include <burin/annotate/break_lines.h>
#include <burin/drawing/clip.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace burin {
namespace {

// Paper mm: how far zigzags stand out and how long they are, and how far their lines go on beyond
// the part; a zigzag each so many mm. Of short lines they are smaller in proportion.
constexpr double kZigzagOut = 1.75, kZigzagHalf = 1.5, kZigzagBeyond = 2.5, kZigzagApart = 60,
                 kShortLine = 10;
// Paper mm: the highest wave, about how long one is, and how far points of it are apart.
constexpr double kWaveHeight = 1, kWaveLength = 14, kWaveStep = 0.4;
constexpr double kMostWavePoints = 2000;

void add_zigzags(double from, double to, std::vector<Vec2>& edge) {
  const double length = to - from, size = std::min(1.0, length / kShortLine);
  const double count = std::max(1.0, std::round(length / kZigzagApart));
  for (double i = 0; i < count; ++i) {
    const double middle = from + length * (i + 0.5) / count, half = size * kZigzagHalf;
    edge.emplace_back(middle - half, 0);
    edge.emplace_back(middle - 0.5 * half, size * kZigzagOut);
    edge.emplace_back(middle + 0.5 * half, -size * kZigzagOut);
    edge.emplace_back(middle + half, 0);
  }
}

/// Two waves of lengths that do not fit each other, as of a hand.
void add_wave(double from, double to, std::vector<Vec2>& edge) {
  const double length = to - from, size = std::min(1.0, length / kShortLine) * kWaveHeight;
  const double steps = std::clamp(std::ceil(length / kWaveStep), 8.0, kMostWavePoints);
  const double waves = std::max(1.0, std::round(length / kWaveLength));
  for (double i = 0; i <= steps; ++i) {
    const double turn = 2 * std::numbers::pi * waves * i / steps;
    const double out = 0.75 * std::sin(turn) + 0.25 * std::sin(1.7 * turn + 0.8);
    edge.emplace_back(std::lerp(from, to, i / steps), size * out);
  }
}

/// From end to end of a stretch, at a side.
Path break_line(const PaperBreaks& breaks, double side, std::span<const Vec2> edge, double from,
                double to) {
  const Vec2 across(-breaks.along.y, breaks.along.x);
  Path line;
  line.kind = LineClass::Frame;
  const auto add = [&](double at, double out) {
    line.points.push_back(at * across + (side + out) * breaks.along);
  };
  add(from, edge_at(edge, from));
  for (const Vec2& point : edge) {
    if (point.x > from && point.x < to) add(point.x, point.y);
  }
  add(to, edge_at(edge, to));
  return line;
}

}  // namespace

std::vector<OptionRow<BreakOptions>> break_option_rows() {
  using options::number;
  return {
      options::word("line", &BreakOptions::line, {"zigzag", "freehand"},
                    "break lines of broken views: straight with zigzags, or a wave as of a hand"),
      number("width", &BreakOptions::width, {0.01, 10, "mm"}, "width of break lines, in mm"),
      number("gap", &BreakOptions::gap, {0, 100, "mm"},
             "distance on the sheet between both ends of a break, in mm"),
  };
}

Stretches joined(Stretches stretches) {
  constexpr double kMeet = 0.05;  // paper mm: the gaps of a tessellation, and what no pen shows
  std::ranges::sort(stretches);
  Stretches out;
  for (const auto& [from, to] : stretches) {
    if (!out.empty() && from <= out.back().second + kMeet) {
      out.back().second = std::max(out.back().second, to);
    } else {
      out.emplace_back(from, to);
    }
  }
  return out;
}

std::vector<Vec2> break_edge(const Stretches& cut, BreakOptions::Line line) {
  std::vector<Vec2> edge;
  for (const auto& [from, to] : cut) {
    if (!(from < to)) continue;
    if (line == BreakOptions::Line::Zigzag) {
      add_zigzags(from, to, edge);
    } else {
      add_wave(from, to, edge);
    }
  }
  return edge;
}

double break_reach(const BreakOptions& style) {
  return style.line == BreakOptions::Line::Zigzag ? kZigzagBeyond : 0;
}

void lay_break_lines(Drawing& drawing, const PaperBreaks& breaks, std::span<const Vec2> edge,
                     std::span<const Stretches> cut, const BreakOptions& style) {
  const double beyond = break_reach(style);
  Layer layer{"breaks", {}};
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const PaperBreaks::Band& band = breaks.bands[i / 2];
    for (const auto& [from, to] : cut[i]) {
      const bool upper = i % 2 == 1;
      Path line =
          break_line(breaks, upper ? band.high : band.low, edge, from - beyond, to + beyond);
      for (Vec2& p : line.points) p += breaks.shift(i / 2 + (upper ? 1 : 0));
      line.width = {style.width};
      layer.paths.push_back(std::move(line));
    }
  }
  if (!layer.paths.empty()) drawing.layers.push_back(std::move(layer));
}

}  // namespace burin
