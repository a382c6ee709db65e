#include "anchors.h"

#include <burin/area/largest_disc.h>
#include <burin/base/box.h>
#include <burin/drawing/length.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

constexpr double kLeastDisc = 0.8;    // paper mm of radius for a dot
constexpr double kAsWell = 0.75;      // of the radius of the largest disc
constexpr double kAsFar = 1;          // paper mm: of parts as far out within this the first counts
constexpr double kBesidePart = 0.75;  // paper mm from a part within which a line is seen on it

Box2 box_of(const BorderSide& side) {
  Box2 box;
  box.add(side[0]);
  box.add(side[1]);
  return box;
}

double nearest(std::span<const BorderSide> sides, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const BorderSide& side : sides) least = std::min(least, distance_to(side, p));
  return least;
}

/// What is seen of a part.
struct Seen {
  std::vector<BorderSide> border;
  Box2 box;
  /// Its place among the parts: of glass first, which lies over the rest.
  std::size_t order = 0;

  void add(const Area& area) {
    for (const std::vector<Vec2>& ring : area.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        border.push_back({ring[i], ring[(i + 1) % ring.size()]});
        box.add(ring[i]);
      }
    }
  }

  /// Whether a point is on it or beside it.
  bool shows(Vec2 p) const { return holds(p) || nearest(border, p) < kBesidePart; }
  bool holds(Vec2 p) const { return encloses(border, p); }
};

/// By part.
using SeenParts = std::map<std::int32_t, Seen>;

SeenParts parts_of(std::span<const Area> areas) {
  SeenParts parts;
  for (const Area& area : areas) {
    const auto [at, is_new] = parts.try_emplace(area.part);
    if (is_new) at->second.order = parts.size();
    at->second.add(area);
  }
  return parts;
}

using Lines = std::map<std::int32_t, std::vector<const Path*>>;

/// The visible lines of each part, without strokes.
Lines lines_by_part(const Drawing& drawing) {
  Lines lines;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      const bool line = path.visible && path.kind != LineClass::Stroke && path.points.size() > 1;
      if (line) lines[path.source.part].push_back(&path);
    }
  }
  return lines;
}

/// The point half-way along a path.
Vec2 middle_of(const Path& path) {
  double left = 0.5 * length_of(path);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const double step = glm::distance(path.points[i - 1], path.points[i]);
    if (step >= left && step > 0) return glm::mix(path.points[i - 1], path.points[i], left / step);
    left -= step;
  }
  return path.points.back();
}

/// The middle of the longest visible line of a part that lies on what is seen of it.
std::optional<Vec2> longest_line(const Lines& lines, std::int32_t part, const Seen& seen) {
  const auto of_part = lines.find(part);
  if (of_part == lines.end()) return std::nullopt;
  std::optional<Vec2> best;
  double longest = -1;
  for (const Path* path : of_part->second) {
    const double length = length_of(*path);
    if (length <= longest) continue;
    const Vec2 at = middle_of(*path);
    if (!seen.shows(at)) continue;
    longest = length;
    best = at;
  }
  return best;
}

/// Lines that a dot should not lie on.
std::vector<BorderSide> lines_of(const Drawing& drawing) {
  std::vector<BorderSide> sides;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!path.visible || path.kind == LineClass::Stroke || path.kind == LineClass::Pattern) {
        continue;
      }
      const std::size_t n = path.points.size();
      for (std::size_t i = 1; i < n; ++i) sides.push_back({path.points[i - 1], path.points[i]});
      if (path.closed && n > 1) sides.push_back({path.points.back(), path.points.front()});
    }
  }
  return sides;
}

/// The lines that may run over what is seen of a part.
std::vector<BorderSide> across(const Seen& seen, const std::vector<BorderSide>& lines) {
  std::vector<BorderSide> out;
  std::ranges::copy_if(lines, std::back_inserter(out),
                       [&](const BorderSide& side) { return box_of(side).overlaps(seen.box); });
  return out;
}

/// Clear of lines where a dot fits, else as far from other parts as can be.
InnerDisc disc_of(const Seen& seen, const std::vector<BorderSide>& lines) {
  const InnerDisc disc = largest_disc(seen.border, across(seen, lines));
  return disc.radius > kLeastDisc ? disc : largest_disc(seen.border);
}

/// A dot on what is seen through its part would name that: it goes to where the part alone is seen,
/// if it fits there.
void leave_what_is_behind(const SeenParts& parts, const std::vector<BorderSide>& lines,
                          Anchor& anchor) {
  constexpr double kMostPlaces = 40;  // each way
  const Seen& own = parts.at(anchor.part);
  std::vector<const Seen*> behind;
  for (const auto& [part, other] : parts) {
    if (other.order > own.order && other.box.overlaps(own.box)) behind.push_back(&other);
  }
  const auto is_through = [&](Vec2 p) {
    return std::ranges::any_of(behind, [&](const Seen* other) { return other->holds(p); });
  };
  if (!anchor.dot || !is_through(anchor.at)) return;
  std::vector<BorderSide> sides = across(own, lines);
  sides.insert(sides.end(), own.border.begin(), own.border.end());
  const Vec2 size = own.box.size();
  const double step = std::max(kLeastDisc, std::max(size.x, size.y) / kMostPlaces);
  double widest = kLeastDisc;
  for (double y = own.box.min.y + 0.5 * step; y < own.box.max.y; y += step) {
    for (double x = own.box.min.x + 0.5 * step; x < own.box.max.x; x += step) {
      const Vec2 p(x, y);
      if (!own.holds(p) || is_through(p)) continue;
      const double radius = nearest(sides, p);
      if (radius <= widest) continue;
      widest = radius;
      anchor.at = p;
    }
  }
}

/// What is seen through a part has its place where that part has its own: of two dots on one place
/// the one of the wider part goes elsewhere, where it fits away from all others.
void part_dots(const SeenParts& parts, std::vector<BorderSide> lines,
               std::vector<Anchor>& anchors) {
  constexpr double kOnOnePlace = 3 * kLeastDisc, kPoint = 1e-3;  // paper mm
  const std::size_t of_drawing = lines.size();
  std::vector<char> moved(anchors.size(), 0);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    for (std::size_t k = i + 1; k < anchors.size(); ++k) {
      if (glm::distance(anchors[i].at, anchors[k].at) >= kOnOnePlace) continue;
      const auto width = [&](std::size_t one) {
        return largest_disc(parts.at(anchors[one].part).border).radius;
      };
      const std::size_t wider = width(i) > width(k) ? i : k;
      if (!anchors[wider].dot || std::exchange(moved[wider], 1) != 0) continue;
      lines.resize(of_drawing);
      for (std::size_t other = 0; other < anchors.size(); ++other) {
        const Vec2 at = anchors[other].at;
        if (other != wider) lines.push_back({at, at + kPoint});
      }
      const InnerDisc disc = disc_of(parts.at(anchors[wider].part), lines);
      const double away = glm::distance(disc.middle, anchors[wider == i ? k : i].at);
      if (disc.radius > kLeastDisc && away >= kOnOnePlace) anchors[wider].at = disc.middle;
    }
  }
}

double out_of(Vec2 middle, Vec2 at, CalloutOptions::Layout layout) {
  const Vec2 off = glm::abs(at - middle);
  if (layout == CalloutOptions::Layout::Columns) return off.x;
  if (layout == CalloutOptions::Layout::Rows) return off.y;
  return std::max(off.x, off.y);
}

}  // namespace

std::vector<Anchor> find_anchors(const Drawing& drawing, std::span<const Area> seen,
                                 const std::vector<DrawingItem>& items, Vec2 middle,
                                 CalloutOptions::Layout layout,
                                 std::vector<const DrawingItem*>& not_shown) {
  const SeenParts parts = parts_of(seen);
  const std::vector<BorderSide> lines = lines_of(drawing);
  const Lines by_part = lines_by_part(drawing);
  std::vector<Anchor> anchors;
  for (const DrawingItem& item : items) {
    std::map<std::int32_t, InnerDisc> discs;
    double largest = 0;
    for (const std::int32_t part : item.parts) {
      const auto at = parts.find(part);
      if (at == parts.end()) continue;
      largest = std::max(largest, (discs[part] = disc_of(at->second, lines)).radius);
    }
    if (largest <= 0) {
      not_shown.push_back(&item);
      continue;
    }
    // Of those that are seen about as well, the outermost: its leader passes over the fewest.
    Anchor anchor{&item};
    double farthest = -1 - kAsFar;
    for (const std::int32_t part : item.parts) {
      const auto disc = discs.find(part);
      if (disc == discs.end() || disc->second.radius < kAsWell * largest) continue;
      const Vec2 at = disc->second.middle;
      const double out = out_of(middle, at, layout);
      if (out <= farthest + kAsFar) continue;
      farthest = out;
      anchor = {&item, part, at, disc->second.radius > kLeastDisc};
    }
    if (!anchor.dot) {
      const auto line = longest_line(by_part, anchor.part, parts.at(anchor.part));
      if (line) anchor.at = *line;
    }
    leave_what_is_behind(parts, lines, anchor);
    anchors.push_back(anchor);
  }
  part_dots(parts, lines, anchors);
  return anchors;
}

}  // namespace burin::detail
