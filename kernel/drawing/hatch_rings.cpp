#include <burin/drawing/hatch_rings.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace burin {
namespace {

constexpr double kMostLines = 20'000;
constexpr double kShortest = 0.02;  // paper mm: less is a speck at a corner

/// An edge in coordinates along the lines and across them, the lower end first.
struct Edge {
  Vec2 low, high;
};

}  // namespace

std::vector<std::pair<Vec2, Vec2>> hatch_rings(std::span<const std::vector<Vec2>> rings,
                                               double degrees, double distance) {
  const double angle = degrees * std::numbers::pi / 180;
  const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
  std::vector<Edge> edges;
  double lowest = 0, highest = 0;
  for (const std::vector<Vec2>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      Vec2 low(glm::dot(along, a), glm::dot(across, a)),
          high(glm::dot(along, b), glm::dot(across, b));
      if (low.y > high.y) std::swap(low, high);
      lowest = edges.empty() ? low.y : std::min(lowest, low.y);
      highest = edges.empty() ? high.y : std::max(highest, high.y);
      edges.push_back({low, high});
    }
  }
  std::vector<std::pair<Vec2, Vec2>> lines;
  if (edges.empty() || !(distance > 0)) return lines;
  const double step = std::max(distance, (highest - lowest) / kMostLines);
  const auto first = static_cast<std::int64_t>(std::ceil(lowest / step));
  const auto last = static_cast<std::int64_t>(std::floor(highest / step));
  if (last < first) return lines;
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(last - first) + 1);
  for (const Edge& edge : edges) {
    // Half-open, so that a line through a corner of the rings crosses one of its two edges.
    auto k = static_cast<std::int64_t>(std::ceil(edge.low.y / step));
    for (; static_cast<double>(k) * step < edge.high.y; ++k) {
      const double t = (static_cast<double>(k) * step - edge.low.y) / (edge.high.y - edge.low.y);
      crossings[static_cast<std::size_t>(k - first)].push_back(
          std::lerp(edge.low.x, edge.high.x, t));
    }
  }
  for (std::int64_t k = first; k <= last; ++k) {
    std::vector<double>& at = crossings[static_cast<std::size_t>(k - first)];
    std::ranges::sort(at);
    const Vec2 origin = static_cast<double>(k) * step * across;
    const std::size_t before = lines.size();
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      if (at[i + 1] - at[i] < kShortest) continue;
      lines.emplace_back(origin + at[i] * along, origin + at[i + 1] * along);
    }
    if (k % 2 == 0) continue;
    std::reverse(lines.begin() + static_cast<std::ptrdiff_t>(before), lines.end());
    for (std::size_t i = before; i < lines.size(); ++i) std::swap(lines[i].first, lines[i].second);
  }
  return lines;
}

}  // namespace burin
