#include "letters.h"

#include <burin/drawing/font.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

/// Degrees from the right; quarters are exact, so that they are the same on any machine.
double turn_of(Vec2 along) {
  constexpr double kRounded = 1e-6;  // degrees
  const double turn = glm::degrees(std::atan2(along.y, along.x));
  const double quarters = std::round(turn / 90) * 90;
  return std::abs(turn - quarters) < kRounded ? quarters : turn;
}

}  // namespace

DimensionLetters::DimensionLetters(const Dimension& dimension, double height)
    : dimension_(dimension),
      height_(height),
      main_(text_width(dimension.text, height)),
      deviations_(std::max(text_width(dimension.upper, kSmall * height),
                           text_width(dimension.lower, kSmall * height))) {}

void DimensionLetters::lay(Vec2 low, Vec2 along, Layer& layer) const {
  const Vec2 up(-along.y, along.x);
  const double turn = turn_of(along);
  const auto add = [&](Vec2 at, double height, TextAnchor anchor, const std::string& text) {
    if (text.empty()) return;
    Text one{at, height, anchor, text, "dimension", 0};
    one.turn = turn;
    layer.texts.push_back(std::move(one));
  };
  const double base = 0.5 * (this->height() - height_);
  add(low + 0.5 * main_ * along + base * up, height_, TextAnchor::Middle, dimension_.text);
  const Vec2 behind = low + (main_ + gap()) * along;
  add(behind + (kSmall + kBetween) * height_ * up, kSmall * height_, TextAnchor::Start,
      dimension_.upper);
  add(behind, kSmall * height_, TextAnchor::Start, dimension_.lower);
}

}  // namespace burin::detail
