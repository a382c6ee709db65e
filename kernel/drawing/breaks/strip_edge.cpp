#include "strip_edge.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace burin {

double edge_at(std::span<const Vec2> edge, double across) {
  if (edge.empty()) return 0;
  const auto next = std::ranges::upper_bound(edge, across, {}, &Vec2::x);
  if (next == edge.begin()) return edge.front().y;
  if (next == edge.end()) return edge.back().y;
  const Vec2 a = *std::prev(next), b = *next;
  return std::lerp(a.y, b.y, (across - a.x) / (b.x - a.x));
}

double Strip::at(Vec2 p) const {
  const double straight = glm::dot(along, p);
  return edge.empty() ? straight : straight - edge_at(edge, glm::dot(across(), p));
}

namespace detail {
namespace {

/// Where a segment near a side of the strip passes points of its edge, as ascending shares.
std::vector<double> passed(Vec2 a, Vec2 b, const Strip& strip, double reach) {
  const double at_a = glm::dot(strip.along, a), at_b = glm::dot(strip.along, b);
  const auto is_near = [&](double side) {
    return std::min(at_a, at_b) <= side + reach && std::max(at_a, at_b) >= side - reach;
  };
  if (!is_near(strip.low) && !is_near(strip.high)) return {};
  const double from = glm::dot(strip.across(), a), way = glm::dot(strip.across(), b) - from;
  std::vector<double> shares;
  for (const Vec2& point : strip.edge) {
    const double share = (point.x - from) / way;
    if (share > 0 && share < 1) shares.push_back(share);
  }
  std::ranges::sort(shares);
  return shares;
}

double reach_of(const Strip& strip) {
  double reach = 0;
  for (const Vec2& point : strip.edge) reach = std::max(reach, std::abs(point.y));
  return reach;
}

}  // namespace

Path refined(const Path& path, const Strip& strip) {
  if (strip.edge.empty() || path.points.size() < 2) return path;
  const double reach = reach_of(strip);
  const std::size_t n = path.points.size();
  const bool varies = path.width.size() == n, spatial = path.points3.size() == n;
  Path out = path;
  out.points.clear();
  if (varies) out.width.clear();
  if (spatial) out.points3.clear();
  auto face = out.faces.begin();
  for (std::size_t i = 0; i < n; ++i) {
    for (; face != out.faces.end() && face->first_point <= i; ++face) {
      face->first_point = static_cast<std::uint32_t>(out.points.size());
    }
    const std::size_t j = (i + 1) % n;
    const auto add = [&](double t) {
      out.points.push_back(glm::mix(path.points[i], path.points[j], t));
      if (varies) out.width.push_back(std::lerp(path.width[i], path.width[j], t));
      if (spatial) out.points3.push_back(glm::mix(path.points3[i], path.points3[j], t));
    };
    add(0);
    if (j == 0 && !path.closed) break;
    for (const double t : passed(path.points[i], path.points[j], strip, reach)) add(t);
  }
  return out;
}

std::vector<Vec2> refined_ring(std::vector<Vec2> ring, const Strip& strip) {
  if (strip.edge.empty()) return ring;
  Path path;
  path.closed = true;
  path.points = std::move(ring);
  return refined(path, strip).points;
}

}  // namespace detail
}  // namespace burin
