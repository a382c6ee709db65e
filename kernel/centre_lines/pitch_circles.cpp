#include "pitch_circles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace burin::detail {
namespace {

/// Paper mm within which holes are equal and stand on one circle.
constexpr double kEqual = 0.01;
/// Radians within which steps from hole to hole are equal.
constexpr double kEqualAngle = 1e-3;
constexpr std::size_t kFewest = 3;

bool equal(double a, double b) { return std::abs(a - b) <= kEqual; }

/// Holes of one part and radius.
using Class = std::vector<std::size_t>;

std::vector<Class> classes_of(std::span<const Round> rounds) {
  std::vector<Class> out;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    if (!rounds[i].hollow) continue;
    const auto same = std::ranges::find_if(out, [&](const Class& one) {
      const Round& first = rounds[one.front()];
      return first.part == rounds[i].part && equal(first.radius, rounds[i].radius);
    });
    if (same == out.end()) {
      out.push_back({i});
    } else {
      same->push_back(i);
    }
  }
  std::erase_if(out, [](const Class& one) { return one.size() < kFewest; });
  return out;
}

/// The circles about a centre, each with three holes at least; those on them leave `left`.
void take_about(Vec2 center, std::span<const Round> rounds, Class& left,
                std::vector<PitchCircle>& out) {
  std::vector<std::pair<double, std::size_t>> at;
  for (const std::size_t i : left) at.emplace_back(glm::distance(rounds[i].center, center), i);
  std::ranges::sort(at);
  for (std::size_t first = 0; first < at.size();) {
    std::size_t end = first + 1;
    while (end < at.size() && equal(at[end].first, at[first].first)) ++end;
    if (end - first >= kFewest && at[first].first > kEqual) {
      PitchCircle circle{center, at[first].first, {}};
      for (std::size_t k = first; k < end; ++k) circle.holes.push_back(at[k].second);
      std::ranges::sort(circle.holes);
      std::erase_if(left,
                    [&](std::size_t i) { return std::ranges::binary_search(circle.holes, i); });
      out.push_back(std::move(circle));
    }
    first = end;
  }
}

/// Whether all holes stand at equal angles about their middle.
bool evenly_round(Vec2 middle, std::span<const Round> rounds, const Class& holes) {
  if (holes.size() == 4) return false;
  std::vector<double> angles;
  for (const std::size_t i : holes) {
    const Vec2 way = rounds[i].center - middle;
    if (!equal(glm::length(way), glm::distance(rounds[holes.front()].center, middle))) return false;
    angles.push_back(std::atan2(way.y, way.x));
  }
  std::ranges::sort(angles);
  const double step = 2 * std::numbers::pi / static_cast<double>(angles.size());
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (std::abs(angles[i] - angles[i - 1] - step) > kEqualAngle) return false;
  }
  return true;
}

}  // namespace

std::vector<PitchCircle> pitch_circles(std::span<const Round> rounds) {
  std::vector<PitchCircle> out;
  for (Class& holes : classes_of(rounds)) {
    const Round first = rounds[holes.front()];
    for (const Round& about : rounds) {
      if (about.part != first.part || equal(about.radius, first.radius)) continue;
      take_about(about.center, rounds, holes, out);
    }
    if (holes.size() < kFewest) continue;
    Vec2 middle(0);
    for (const std::size_t i : holes)
      middle += rounds[i].center / static_cast<double>(holes.size());
    if (evenly_round(middle, rounds, holes)) take_about(middle, rounds, holes, out);
  }
  return out;
}

}  // namespace burin::detail
