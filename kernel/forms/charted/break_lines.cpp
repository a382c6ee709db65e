#include "break_lines.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Share of the domain within which a place lies on a line: what a few operations leave of a
// parameter in double precision.
constexpr double kOnLine = 1e-11;

// Places along a seam, and the difference of derivatives there, relative, that is no break.
constexpr int kPlaces = 8;
constexpr double kSame = 1e-7;

// Whether the first derivatives of a periodic chart differ on both sides of its seam.
bool breaks_at_seam(const Chart& chart, int direction) {
  const ParameterBox box = chart.domain();
  for (int i = 0; i < kPlaces; ++i) {
    Vec2 low = box.min + ((i + 0.5) / kPlaces) * box.size(), high = low;
    low[direction] = box.min[direction] + kOnLine * box.size()[direction];
    high[direction] = box.max[direction] - kOnLine * box.size()[direction];
    const SurfaceDerivatives a = chart.derivatives(low), b = chart.derivatives(high);
    const double size = std::max(glm::length(a.u) + glm::length(a.v), 1e-300);
    if (glm::distance(a.u, b.u) + glm::distance(a.v, b.v) > kSame * size) return true;
  }
  return false;
}

}  // namespace

BreakLines::BreakLines(const Atlas& atlas) {
  const std::size_t count = atlas.face_count();
  for (std::size_t f = 0; f < count; ++f) {
    const Chart& chart = atlas.chart(static_cast<std::int32_t>(f));
    const ParameterBox domain = chart.domain();
    Face face;
    face.start = domain.min;
    face.period = chart.period();
    for (int i = 0; i < 2; ++i) {
      auto& lines = face.lines[static_cast<std::size_t>(i)];
      lines = chart.breaks(i, 1);
      const bool seam = face.period[i] > 0 && chart.kind() == FaceKind::Freeform;
      if (seam && breaks_at_seam(chart, i)) lines.insert(lines.begin(), domain.min[i]);
      face.noise[i] = kOnLine * domain.size()[i];
    }
    any_ = any_ || !face.none();
    faces_.push_back(std::move(face));
  }
}

ParameterBox BreakLines::cell(std::int32_t face, Vec2 uv, Vec2 velocity) const {
  const Face& f = of(face);
  ParameterBox box = kUnbounded;
  for (int i = 0; i < 2; ++i) {
    const std::vector<double>& lines = f.lines[static_cast<std::size_t>(i)];
    if (lines.empty()) continue;
    const double period = f.period[i];
    // On a line the side that the velocity leads to decides.
    const double x = uv[i] + std::copysign(f.noise[i], velocity[i]);
    const double shift = period > 0 ? period * std::floor((x - f.start[i]) / period) : 0;
    const auto above = std::upper_bound(lines.begin(), lines.end(), x - shift);
    if (above != lines.end()) {
      box.max[i] = *above + shift;
    } else if (period > 0) {
      box.max[i] = lines.front() + period + shift;
    }
    if (above != lines.begin()) {
      box.min[i] = *(above - 1) + shift;
    } else if (period > 0) {
      box.min[i] = lines.back() - period + shift;
    }
  }
  return box;
}

double BreakLines::nearest(const Face& f, int direction, double x) {
  const std::vector<double>& lines = f.lines[static_cast<std::size_t>(direction)];
  if (lines.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double period = f.period[direction];
  const double shift = period > 0 ? period * std::floor((x - f.start[direction]) / period) : 0;
  const auto above = std::lower_bound(lines.begin(), lines.end(), x - shift);
  double best = std::numeric_limits<double>::infinity();
  const auto consider = [&](double line) {
    if (std::abs(line - x) < std::abs(best - x)) best = line;
  };
  if (above != lines.end()) consider(*above + shift);
  if (above != lines.begin()) consider(*(above - 1) + shift);
  if (period > 0) {
    consider(lines.front() + period + shift);
    consider(lines.back() - period + shift);
  }
  return best;
}

double BreakLines::crossing(std::int32_t face, Vec2 from, Vec2 to) const {
  const Face& f = of(face);
  double best = 0.5, least = 0.5;
  for (int i = 0; i < 2; ++i) {
    const double line = nearest(f, i, 0.5 * (from[i] + to[i]));
    const double low = std::min(from[i], to[i]) + 2 * f.noise[i];
    const double high = std::max(from[i], to[i]) - 2 * f.noise[i];
    if (!(line > low && line < high)) continue;
    const double share = (line - from[i]) / (to[i] - from[i]);
    if (std::abs(share - 0.5) >= least) continue;
    least = std::abs(share - 0.5);
    best = share;
  }
  return best;
}

Vec2 BreakLines::snap(std::int32_t face, Vec2 uv) const {
  if (none(face)) return uv;
  const Face& f = of(face);
  for (int i = 0; i < 2; ++i) {
    const double line = nearest(f, i, uv[i]);
    if (std::abs(uv[i] - line) <= f.noise[i]) uv[i] = line;
  }
  return uv;
}

bool BreakLines::along_line(std::int32_t face, Vec2 from, Vec2 to) const {
  if (none(face)) return false;
  const Face& f = of(face);
  for (int i = 0; i < 2; ++i) {
    const double line = nearest(f, i, 0.5 * (from[i] + to[i]));
    const double near = 2 * f.noise[i];
    if (std::abs(from[i] - line) <= near && std::abs(to[i] - line) <= near) return true;
  }
  return false;
}

}  // namespace burin::detail
