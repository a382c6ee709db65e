#include "cut_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

/// Lines over one area at the most; wider apart beyond.
constexpr double kMostLines = 5000;
/// Of an area's size: pieces of one line so near are one.
constexpr double kJoined = 1e-9;

struct Run {
  double from, to;
  std::uint32_t face;
};

/// Where line `at` (its coordinate across) runs over a triangle, along it; nothing: empty.
Run over_triangle(const std::array<Vec2, 3>& triangle, Vec2 along, Vec2 across, double at,
                  std::uint32_t face) {
  Run run{1, 0, face};
  bool any = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 &p = triangle[k], &q = triangle[(k + 1) % 3];
    const double a = glm::dot(across, p) - at, b = glm::dot(across, q) - at;
    if ((a > 0) == (b > 0)) continue;
    const double t = glm::dot(along, glm::mix(p, q, a / (a - b)));
    run.from = any ? std::min(run.from, t) : t;
    run.to = any ? std::max(run.to, t) : t;
    any = true;
  }
  return run;
}

using Interval = std::pair<double, double>;

/// Where a line is nearer than `width` to a segment: one interval, for the places around a segment
/// are convex. Coordinates along the line and across it, which is 0 on it.
std::optional<Interval> near_segment(Vec2 p, Vec2 q, double width) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto add = [&](double from, double to) {
    low = std::min(low, from), high = std::max(high, to);
  };
  for (const Vec2& end : {p, q}) {
    if (std::abs(end.y) >= width) continue;
    const double half = std::sqrt(width * width - end.y * end.y);
    add(end.x - half, end.x + half);
  }
  // Over its sides.
  const Vec2 e = q - p;
  const double length = glm::length(e);
  if (length > 0 && std::abs(e.y) > 1e-12 * length) {
    const Vec2 side = width / length * Vec2(-e.y, e.x);
    for (const Vec2& shift : {side, -side}) {
      const double t = -(p.y + shift.y) / e.y;
      if (t >= 0 && t <= 1) add(p.x + shift.x + t * e.x, p.x + shift.x + t * e.x);
    }
  } else if (length > 0 && std::abs(p.y) < width) {
    add(std::min(p.x, q.x), std::max(p.x, q.x));
  }
  if (!(low < high)) return std::nullopt;
  return Interval{low, high};
}

struct Lattice {
  Vec2 along, across;
  double step;

  Vec2 flat(Vec2 p, double at) const { return {glm::dot(along, p), glm::dot(across, p) - at}; }
};
using Lines = std::map<std::int64_t, std::vector<Run>>;

/// Of each line of a lattice that runs over an area, its runs over the triangles.
Lines lines_over(const Area& area, const Lattice& lattice) {
  Lines lines;
  for (std::size_t i = 0; i < area.triangles.size(); ++i) {
    double low = glm::dot(lattice.across, area.triangles[i][0]), high = low;
    for (const Vec2& p : area.triangles[i]) {
      const double at = glm::dot(lattice.across, p);
      low = std::min(low, at), high = std::max(high, at);
    }
    for (auto k = static_cast<std::int64_t>(std::ceil(low / lattice.step));
         static_cast<double>(k) * lattice.step <= high; ++k) {
      const Run run = over_triangle(area.triangles[i], lattice.along, lattice.across,
                                    static_cast<double>(k) * lattice.step, area.faces[i]);
      if (run.to > run.from) lines[k].push_back(run);
    }
  }
  return lines;
}

/// What a line keeps clear of.
class Kept {
 public:
  Kept(const Clearance& clear, const Lattice& lattice) : clear_(clear), lattice_(lattice) {
    for (const Area* area : clear.areas) lines_.push_back(lines_over(*area, lattice));
  }

  /// What is left of an interval of line `k`.
  std::vector<Interval> left(std::int64_t k, Interval whole, double least) const {
    std::vector<Interval> near = taken(k);
    std::ranges::sort(near);
    std::vector<Interval> left;
    double from = whole.first;
    for (const auto& [low, high] : near) {
      if (low > from) left.push_back({from, std::min(low, whole.second)});
      from = std::max(from, high);
      if (from >= whole.second) break;
    }
    if (from < whole.second) left.push_back({from, whole.second});
    std::erase_if(left, [&](const Interval& i) { return !(i.second - i.first > least); });
    return left;
  }

 private:
  std::vector<Interval> taken(std::int64_t k) const {
    std::vector<Interval> taken;
    const double at = static_cast<double>(k) * lattice_.step;
    for (const auto& [p, q] : clear_.outline) {
      const auto near = near_segment(lattice_.flat(p, at), lattice_.flat(q, at), clear_.width);
      if (near) taken.push_back(*near);
    }
    for (const Lines& lines : lines_) {
      const auto runs = lines.find(k);
      if (runs == lines.end()) continue;
      for (const Run& run : runs->second) taken.push_back({run.from, run.to});
    }
    return taken;
  }

  const Clearance& clear_;
  const Lattice& lattice_;
  std::vector<Lines> lines_;
};

}  // namespace

void hatch_lines(const Area& area, double degrees, double spacing, const Clearance& clear,
                 std::vector<Curve3>& out) {
  const double angle = degrees * std::numbers::pi / 180;
  const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
  const Lattice lattice{along, across, std::max(spacing, area.box.diagonal() / kMostLines)};
  const Kept kept(clear, lattice);
  Lines lines = lines_over(area, lattice);
  const double joined = kJoined * area.box.diagonal();
  const auto point = [&](std::int64_t k, double t) {
    const Vec2 p = t * along + static_cast<double>(k) * lattice.step * across;
    return p.x * area.u + p.y * area.v + area.offset * area.normal;
  };
  for (auto& [k, runs] : lines) {
    std::ranges::sort(runs, {}, &Run::from);
    for (std::size_t i = 0; i < runs.size();) {
      std::size_t j = i + 1;
      double to = runs[i].to;
      while (j < runs.size() && runs[j].from <= to + joined) to = std::max(to, runs[j++].to);
      const std::uint32_t face = runs[i].face;
      const double least = clear.areas.empty() ? 0 : joined;
      for (const auto& [a, b] : kept.left(k, {runs[i].from, to}, least)) {
        Curve3 curve;
        curve.kind = LineClass::Pattern;
        curve.source.part = area.part;
        curve.points = {point(k, a), point(k, b)};
        curve.normals = {area.normal, area.normal};
        curve.faces = {static_cast<std::int32_t>(face)};
        out.push_back(std::move(curve));
      }
      i = j;
    }
  }
}

}  // namespace burin::detail
