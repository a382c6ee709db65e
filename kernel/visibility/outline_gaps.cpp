#include <burin/planar/near_lines.h>
#include <burin/visibility/outline_gaps.h>

#include "probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace burin {
namespace {

// Paper mm within which another line takes over, and along a line's own course from where on it is
// another one.
constexpr double kGapReach = 0.25, kAway = 1, kOwn = 3;
// Paper mm from one place of the border to the next; the first may lie this many times farther off
// the end of the line.
constexpr double kStep = 0.15;
constexpr int kFarthest = 3;
// Paper mm of border, and ends that are looked at.
constexpr double kLongest = 20;
constexpr std::size_t kMostEnds = 500;
// Directions that are looked at from each place; halvings of the angle between two.
constexpr int kDirections = 32, kGapBisections = 10;
// The sharpest turn at a place of the border: 120 degrees.
constexpr double kSharpest = -0.5;
// Paper mm: this near a line the border has met it.
constexpr double kMet = 0.03;

/// A place of the border, on the object's side of it.
struct GapPlace {
  Vec2 paper{0};
  Probe::Seen seen;
};

Vec2 turned(Vec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Follows the border between object and paper.
class Border {
 public:
  Border(const Probe& probe, Vec2 start, Vec2 heading)
      : probe_(probe), at_(start), heading_(heading) {}

  std::optional<GapPlace> next(double radius) {
    const double angle = 2 * std::numbers::pi / kDirections;
    std::array<bool, kDirections> covered{};
    for (int k = 0; k < kDirections; ++k) covered[index(k)] = on_object(radius, angle * k);
    double best = 0, most = kSharpest;
    int side = 0;
    for (int k = 0; k < kDirections; ++k) {
      if (covered[index(k)] == covered[index(k + 1)]) continue;
      const int there = covered[index(k)] ? 1 : -1;
      const double ahead = std::cos(angle * (k + 0.5));
      if (ahead <= most || (side_ != 0 && there != side_)) continue;
      most = ahead, best = angle * k, side = there;
    }
    if (side == 0) return std::nullopt;
    double object = side > 0 ? best : best + angle, paper = side > 0 ? best + angle : best;
    for (int i = 0; i < kGapBisections; ++i) {
      const double middle = 0.5 * (object + paper);
      (on_object(radius, middle) ? object : paper) = middle;
    }
    const Vec2 there = at_ + radius * turned(heading_, object);
    const auto seen = probe_.seen_at(there);
    if (!seen) return std::nullopt;
    side_ = side;
    heading_ = turned(heading_, object);
    at_ = there;
    return GapPlace{there, *seen};
  }

 private:
  static std::size_t index(int k) { return static_cast<std::size_t>(k % kDirections); }
  bool on_object(double radius, double angle) const {
    return probe_.paper_covered(at_ + radius * turned(heading_, angle));
  }

  const Probe& probe_;
  Vec2 at_, heading_;
  int side_ = 0;  // of the object: 1 to the right
};

/// The lines that are seen, as they lie on the sheet.
struct Seen {
  std::vector<Polyline> lines;
  std::vector<Vec3> first, last;     // their ends in the model
  std::vector<std::size_t> outline;  // of the outer outline, with ends
};

Seen seen_lines(std::span<const Curve3> features, std::span<const std::vector<Span>> spans,
                const Camera& camera) {
  Seen out;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Curve3& curve = features[i];
    const auto count = static_cast<double>(curve.segment_count());
    for (const Span& span : merged(spans[i], curve.closed, count)) {
      if (!span.visible) continue;
      const bool whole = curve.closed && span.end - span.begin >= count;
      const Curve3 part = whole ? curve : slice(curve, span.begin, span.end);
      if (part.points.size() < 2) continue;
      Polyline line;
      for (const Vec3& p : part.points) line.push_back(camera.to_paper(p));
      if (whole) line.push_back(line.front());
      if (span.outer && !whole) out.outline.push_back(out.lines.size());
      out.lines.push_back(std::move(line));
      out.first.push_back(part.points.front());
      out.last.push_back(part.points.back());
    }
  }
  return out;
}

bool on_sheet(const Camera& camera, Vec2 p) {
  return p.x > kGapReach && p.y > kGapReach && p.x < camera.paper().width - kGapReach &&
         p.y < camera.paper().height - kGapReach;
}

/// Which way a line goes at its end, over its last 0.3 mm.
Vec2 heading_at(const Polyline& line, bool last) {
  const std::size_t n = line.size();
  const Vec2 end = last ? line.back() : line.front();
  for (std::size_t i = 1; i < n; ++i) {
    const Vec2 off = end - (last ? line[n - 1 - i] : line[i]);
    if (glm::length(off) >= 2 * kStep || i + 1 == n) {
      const double length = glm::length(off);
      return length > 0 ? off / length : Vec2(1, 0);
    }
  }
  return {1, 0};
}

/// Follows the border from a free end to the next line; nothing where it meets none.
class Closer {
 public:
  Closer(const Seen& seen, const NearLines& grid, const Probe& probe)
      : seen_(seen), grid_(grid), probe_(probe) {}

  std::optional<std::vector<GapPlace>> close(const LineEnd& end) const {
    const Polyline& line = seen_.lines[end.line];
    const std::vector<double> at = lengths_along(line);
    const auto other = [&](std::size_t l, std::size_t segment) {
      if (l != end.line) return true;
      return (end.last ? at.back() - at[segment + 1] : at[segment]) >= kOwn;
    };
    const Vec2 from = end.last ? line.back() : line.front();
    Border border(probe_, from, heading_at(line, end.last));
    std::vector<GapPlace> gap;
    std::optional<GapPlace> place;
    for (int i = 1; i <= kFarthest && !place; ++i) place = border.next(i * kStep);
    double nearest = std::numeric_limits<double>::infinity();
    for (int steps = static_cast<int>(kLongest / kStep); place && steps > 0; --steps) {
      const double distance = grid_.distance(place->paper, other);
      if (distance > nearest && nearest <= kGapReach) return gap;  // it was met at the place before
      gap.push_back(*place);
      if (distance <= kMet) return gap;
      nearest = distance;
      place = border.next(kStep);
    }
    return std::nullopt;
  }

 private:
  const Seen& seen_;
  const NearLines& grid_;
  const Probe& probe_;
};

/// One curve a part that the border runs over.
void add_curves(const std::vector<GapPlace>& gap, Vec3 start, const Camera& camera,
                std::span<const ProxyMesh* const> proxies, std::vector<Curve3>& out) {
  Curve3 curve;
  Vec3 before = start;
  const auto begin = [&](const GapPlace& place) {
    curve = {};
    curve.kind = LineClass::Contour;
    curve.occluding = true;
    curve.source.part = place.seen.where.part;
    curve.points = {before};
    curve.normals = {camera.to_viewer(before)};
  };
  begin(gap.front());
  for (const GapPlace& place : gap) {
    if (place.seen.where.part != curve.source.part) {
      if (curve.points.size() > 1) out.push_back(curve);
      begin(place);
    }
    const auto part = static_cast<std::size_t>(place.seen.where.part);
    const Vec3 to_viewer = camera.to_viewer(place.seen.position);
    const Vec3 flat = proxies[part]->mesh.normal(place.seen.where.face);
    // At the border the open side is the part of the normal across the line of sight.
    const Vec3 open = flat - glm::dot(flat, to_viewer) * to_viewer;
    curve.points.push_back(place.seen.position);
    curve.normals.push_back(normalize_or(open, flat));
    curve.faces.push_back(static_cast<std::int32_t>(place.seen.where.face));
    before = place.seen.position;
  }
  curve.normals.front() = curve.normals[1];
  out.push_back(std::move(curve));
}

}  // namespace

std::vector<Curve3> outline_gaps(const Occluder& occluder,
                                 std::span<const ProxyMesh* const> proxies, const Camera& camera,
                                 std::span<const Curve3> features,
                                 std::span<const std::vector<Span>> spans,
                                 const RunContext& context) {
  const Seen seen = seen_lines(features, spans, camera);
  const NearLines grid(seen.lines, kGapReach);
  std::vector<LineEnd> ends = free_ends(seen.lines, grid, seen.outline, kAway);
  if (ends.size() > kMostEnds) ends.resize(kMostEnds);
  const Probe probe(occluder, proxies, camera);
  const Closer closer(seen, grid, probe);
  std::vector<Curve3> out;
  std::vector<Vec2> met;  // ends that borders from others came to
  for (const LineEnd& end : ends) {
    context.check();
    const Polyline& line = seen.lines[end.line];
    const Vec2 p = end.last ? line.back() : line.front();
    const auto here = [&](Vec2 q) { return glm::distance(p, q) <= kGapReach; };
    if (!on_sheet(camera, p) || std::ranges::any_of(met, here)) continue;
    const auto gap = closer.close(end);
    if (!gap || gap->empty()) continue;
    met.push_back(gap->back().paper);
    add_curves(*gap, end.last ? seen.last[end.line] : seen.first[end.line], camera, proxies, out);
  }
  return out;
}

}  // namespace burin
