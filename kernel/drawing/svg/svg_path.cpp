#include "svg_path.h"

#include <cmath>

namespace burin {
namespace {

constexpr int kDecimals = 3;
constexpr double kGrid = 1000;
/// mm that a curve may leave its chord and still be written as a line.
constexpr double kStraightCubic = 0.001;

}  // namespace

std::size_t path_elements(std::span<const CubicBezier> curves, bool close) {
  std::size_t count = close ? 2 : 1;
  for (const CubicBezier& c : curves) count += is_straight(c, kStraightCubic) ? 1 : 3;
  return count;
}

SvgPen::Place SvgPen::place(Vec2 p) const {
  return {std::llround(p.x * kGrid), std::llround((height_ - p.y) * kGrid)};
}

void SvgPen::number(std::int64_t thousandths) {
  // A minus sign parts numbers as well as a space does.
  if (!glued_ && thousandths >= 0) out_.push_back(' ');
  append_scaled(out_, thousandths, kDecimals, true);
  glued_ = false;
}

void SvgPen::command(char c) {
  if (c == last_) return;
  out_.push_back(c);
  last_ = c;
  glued_ = true;
}

void SvgPen::step(Place from, Place to) {
  number(to.x - from.x);
  number(to.y - from.y);
}

void SvgPen::line(Place to) {
  if (to.y == at_.y) {
    command('h');
    number(to.x - at_.x);
  } else if (to.x == at_.x) {
    command('v');
    number(to.y - at_.y);
  } else {
    command('l');
    step(at_, to);
  }
  at_ = to;
}

void SvgPen::chain(std::span<const CubicBezier> curves, bool close) {
  if (curves.empty()) return;
  at_ = place(curves.front()[0]);
  command('M');
  step({}, at_);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const CubicBezier& c = curves[i];
    const Place to = place(c[3]);
    if (is_straight(c, kStraightCubic)) {
      // The last line of a closed chain is what z draws.
      const bool by_close = close && i + 1 == curves.size() && i > 0;
      if (!by_close && (to.x != at_.x || to.y != at_.y)) line(to);
      continue;
    }
    command('c');
    step(at_, place(c[1]));
    step(at_, place(c[2]));
    step(at_, to);
    at_ = to;
  }
  if (close) command('z');
}

void SvgPen::dot(Vec2 p) {
  at_ = place(p);
  command('M');
  step({}, at_);
  line(at_);
}

void SvgPen::points(std::span<const Vec2> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) out_.push_back(' ');
    const Place p = place(points[i]);
    append_scaled(out_, p.x, kDecimals);
    out_.push_back(',');
    append_scaled(out_, p.y, kDecimals);
  }
}

}  // namespace burin
