#include <burin/mesh/proxy_mesh.h>

#include "broken_view.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

/// Model mm.
constexpr double kRounding = 1e-6;
/// Sine within which a length is across the way that a view becomes shorter.
constexpr double kAcross = 1e-6;

using Range = std::pair<double, double>;

Range range_of(const std::vector<Vec3>& points, const Vec3& way) {
  const auto along = [&](const Vec3& p) { return glm::dot(way, p); };
  const auto [low, high] = std::ranges::minmax(points, {}, along);
  return {along(low), along(high)};
}

}  // namespace

bool BrokenAs::leaves_out(double at) const {
  return std::ranges::any_of(bands_, [&](const PaperBreaks::Band& band) {
    return at > band.low + kRounding && at < band.high - kRounding;
  });
}

/// The longest piece of a stretch that is not left out; its low end is above its high one where
/// there is none.
std::pair<double, double> BrokenAs::longest_left(double low, double high) const {
  Range best{1, 0};
  const auto look = [&](double from, double to) {
    if (to >= from && to - from > best.second - best.first) best = {from, to};
  };
  double from = low;
  for (const PaperBreaks::Band& band : bands_) {
    look(from, std::min(high, band.low));
    from = std::max(from, band.high);
  }
  look(from, high);
  return best;
}

/// Those of the ends of a feature that are seen; where none is, ends of what is seen between them.
std::vector<Vec3> BrokenAs::seen_of(const std::vector<Vec3>& points) const {
  std::vector<Vec3> seen = points;
  std::erase_if(seen, [&](const Vec3& p) { return leaves_out(p); });
  if (!seen.empty()) return seen;
  const auto [low, high] = range_of(points, way_);
  const auto [from, to] = longest_left(low, high);
  if (from > to) return seen;
  for (const double at : {from, to}) {
    const Vec3& p = points.front();
    seen.push_back(p + (at - glm::dot(way_, p)) / foreshortened_ * axis_);
  }
  return seen;
}

bool BrokenAs::put_where_seen(Dimension& one) const {
  if (empty()) return true;
  if (one.kind == Dimension::Kind::Note) {
    return std::ranges::all_of(one.targets, [&](LeaderTarget& target) {
      for (std::size_t k = target.tips.size(); k-- > 0;) {
        if (!leaves_out(target.tips[k])) continue;
        target.tips.erase(target.tips.begin() + static_cast<std::ptrdiff_t>(k));
        target.rooms.erase(target.rooms.begin() + static_cast<std::ptrdiff_t>(k));
      }
      return !target.tips.empty();
    });
  }
  if (one.kind == Dimension::Kind::Round) return !leaves_out(one.from);
  if (one.kind == Dimension::Kind::Angle) return !leaves_out(one.to) && !leaves_out(one.other);
  const Vec3 length = one.to - one.from;
  const bool across = std::abs(glm::dot(way_, length)) <= kAcross * glm::length(length);
  if (!across || one.from_points.empty() || one.to_points.empty()) {
    return !leaves_out(one.from) && !leaves_out(one.to);
  }
  const Range a = range_of(one.from_points, way_), b = range_of(one.to_points, way_);
  one.from_points = seen_of(one.from_points);
  one.to_points = seen_of(one.to_points);
  if (one.from_points.empty() || one.to_points.empty()) return false;
  if (!leaves_out(one.from) && !leaves_out(one.to)) return true;
  // Both ends side by side where there is something of both features, else of one.
  auto [low, high] = longest_left(std::max(a.first, b.first), std::min(a.second, b.second));
  if (low > high) low = high = glm::dot(way_, one.from_points.front());
  const double by = 0.5 * (low + high) - glm::dot(way_, one.from);
  one.from += by / foreshortened_ * axis_;
  one.to += by / foreshortened_ * axis_;
  return true;
}

std::array<bool, 3> BrokenAs::reaches(const MeasuredParts& parts) const {
  std::array<bool, 3> out{true, true, true};
  if (empty()) return out;
  Box3 whole, left;
  for (const std::shared_ptr<const Surface>& surface : parts.surfaces) {
    if (!surface) continue;
    const TriMesh& mesh = surface->proxy().mesh;
    for (const Triangle& triangle : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &p = mesh.positions[triangle[k]], &q = mesh.positions[triangle[(k + 1) % 3]];
        whole.add(p);
        add_left(p, q, left);
      }
    }
  }
  // Round parts are less than twice that shorter than they are.
  const double near = 2 * parts.tolerance + kRounding;
  for (int k = 0; k < 3; ++k) {
    out[static_cast<std::size_t>(k)] =
        left.min[k] <= whole.min[k] + near && left.max[k] >= whole.max[k] - near;
  }
  return out;
}

/// The beginning of an edge, and where it crosses the sides of breaks, where they are not left out.
void BrokenAs::add_left(const Vec3& p, const Vec3& q, Box3& to) const {
  const double from = glm::dot(way_, p), until = glm::dot(way_, q);
  if (!leaves_out(from)) to.add(p);
  for (const PaperBreaks::Band& band : bands_) {
    for (const double side : {band.low, band.high}) {
      if ((from < side) != (until < side)) to.add(glm::mix(p, q, (side - from) / (until - from)));
    }
  }
}

}  // namespace burin::detail
