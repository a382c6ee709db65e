#include "guide.h"

#include <cmath>

namespace burin::detail {
namespace {

constexpr double kAhead = 0.8;  // paper mm: where a stroke aims

}  // namespace

Guide::Heading Guide::at(Vec2 paper) {
  const std::vector<Vec2>& p = line_->points;
  Heading out;
  if (last(at_)) {  // a line whose end is its start
    out.past = true;
    out.inside = way_ > 0 ? line_->end_inside : line_->begin_inside;
    return out;
  }
  double along = 0;
  Vec2 step{0};
  // Once around a closed line at the most.
  for (std::size_t i = 0; i < size(); ++i) {
    step = p[next(at_)] - p[at_];
    const double square = glm::dot(step, step);
    along = square > 0 ? glm::dot(paper - p[at_], step) / square : 1;
    if (along <= 1 || last(next(at_))) break;
    at_ = next(at_);
  }
  const double length = glm::length(step);
  const Vec2 unit = length > 0 ? step / length : Vec2(1, 0);
  out.off = cross2(unit, paper - p[at_]);
  out.gap = line_->gaps[at_];
  out.beside_end = line_->beside_end;
  out.past = along > 1 && last(next(at_));
  out.inside = way_ > 0 ? line_->end_inside : line_->begin_inside;
  // The place ahead, on the line or on its last step drawn out.
  double left = kAhead + std::max(0.0, along) * length;
  std::size_t i = at_;
  Vec2 target = p[i];
  while (true) {
    const Vec2 s = p[next(i)] - p[i];
    const double n = glm::length(s);
    if (n >= left || last(next(i))) {
      target = p[i] + (n > 0 ? left / n : 0) * s;
      break;
    }
    left -= n;
    i = next(i);
    if (i == at_) {
      target = p[i];
      break;
    }
  }
  const Vec2 way = target - paper;
  const double n = glm::length(way);
  out.ahead = n > 0 ? way / n : unit;
  return out;
}

}  // namespace burin::detail
