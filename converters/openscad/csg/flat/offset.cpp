#include <burin/base/error.h>

#include "clip.h"
#include "origins.h"

#include <fmt/format.h>
#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace burin::csg {
namespace {

// mm: moved points are rounded to the grid, after a calculation in doubles that is as exact.
constexpr double kOffsetSlack = 2.5 / kGrid;

// OpenSCAD sets it so high that corners of delta are never cut.
constexpr double kMiterLimit = 1e6;

ClipperLib::JoinType join_type(OffsetRule::Corner corner) {
  return corner == OffsetRule::Corner::Round   ? ClipperLib::jtRound
         : corner == OffsetRule::Corner::Sharp ? ClipperLib::jtMiter
                                               : ClipperLib::jtSquare;
}

bool on_circle(Vec2 p, Vec2 middle, double radius) {
  return std::abs(glm::length(p - middle) - radius) <= kOffsetSlack;
}

/// Whether the edge is a facet of the circle: its ends on it, and hardly longer than a facet. Where
/// moved edges meet at a small angle, rounding lets their ends slide along the circle.
bool facet_of(Vec2 a, Vec2 b, const Arc& arc) {
  constexpr double kSlide = 1.5;
  return on_circle(a, arc.middle, arc.radius) && on_circle(b, arc.middle, arc.radius) &&
         glm::length(b - a) <= kSlide * 2 * arc.radius * std::sin(std::min(arc.step, 2.0) / 2);
}

/// What a polygon for an arc becomes where its edges move by delta: to either side, with its
/// corners rounded (their ends stay on one circle) or as they are.
std::vector<Arc> moved_arcs(const Region& region, double delta) {
  std::vector<Arc> out;
  for (const Arc& arc : region.arcs) {
    const double half = std::cos(arc.step / 2), edge = arc.radius * half;
    for (const double by : {delta, -delta}) {
      for (const double radius :
           {arc.radius + by / half, std::hypot(edge + by, arc.radius * std::sin(arc.step / 2))}) {
        if (edge + by > 0) out.push_back({arc.middle, radius, arc.step});
      }
    }
  }
  return out;
}

/// Corners that round arcs may stand about, by squares as large as the arcs.
class Corners {
 public:
  Corners(const Region& region, double radius, double step) : radius_(radius), step_(step) {
    for (const Outline& o : region.outlines) {
      for (const Vec2& p : o.points) cells_[cell(p)].push_back(p);
    }
  }

  std::optional<Arc> around(Vec2 a, Vec2 b) const {
    const GridPoint c = cell(0.5 * (a + b));
    for (std::int64_t x = c.x - 1; x <= c.x + 1; ++x) {
      for (std::int64_t y = c.y - 1; y <= c.y + 1; ++y) {
        const auto found = cells_.find({x, y});
        if (found == cells_.end()) continue;
        for (const Vec2& p : found->second) {
          const Arc arc{p, radius_, step_};
          if (facet_of(a, b, arc)) return arc;
        }
      }
    }
    return std::nullopt;
  }

 private:
  GridPoint cell(Vec2 p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / radius_)),
            static_cast<std::int64_t>(std::floor(p.y / radius_))};
  }

  double radius_, step_;
  std::unordered_map<GridPoint, std::vector<Vec2>, GridPointHash> cells_;
};

void tag_moved(Region& moved, const Region& from, double delta, const OffsetRule& rule) {
  std::vector<Arc> arcs = moved_arcs(from, delta);
  std::optional<Corners> corners;
  if (rule.corner == OffsetRule::Corner::Round && rule.fragments >= kFewestRound) {
    corners.emplace(from, std::abs(delta), 2 * M_PI / rule.fragments);
  }
  moved.arcs = arcs;
  for (Outline& o : moved.outlines) {
    for (std::size_t i = 0; i < o.points.size(); ++i) {
      const Vec2 a = o.points[i], b = o.points[(i + 1) % o.points.size()];
      const auto whole =
          std::ranges::find_if(arcs, [&](const Arc& arc) { return facet_of(a, b, arc); });
      if (whole != arcs.end()) {
        o.arc[i] = static_cast<std::int32_t>(whole - arcs.begin());
      } else if (const auto arc = corners ? corners->around(a, b) : std::nullopt) {
        o.arc[i] = static_cast<std::int32_t>(moved.arcs.size());
        moved.arcs.push_back({arc->middle, arc->radius, 2 * M_PI / rule.fragments});
      }
    }
  }
  tidy_arcs(moved);
}

/// Points that round corners will have, if each were to be on the outside.
double corner_points(const Region& region, const OffsetRule& rule) {
  double turns = 0, corners = 0;
  for (const Outline& o : region.outlines) {
    const std::size_t n = o.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 in = o.points[i] - o.points[(i + n - 1) % n],
                 out = o.points[(i + 1) % n] - o.points[i];
      turns += std::abs(std::atan2(cross2(in, out), glm::dot(in, out))) / (2 * M_PI);
    }
    corners += static_cast<double>(n);
  }
  return rule.fragments * turns + corners;
}

void check_size(const Region& region, const OffsetRule& rule) {
  constexpr double kMostPoints = 1e7;
  if (rule.corner != OffsetRule::Corner::Round) return;
  if (const double points = corner_points(region, rule); points > kMostPoints) {
    throw InputError(
        fmt::format("offset() with round corners of {:g} points in all; set $fn, $fa or "
                    "$fs to less, e.g. $fn = 100",
                    points));
  }
}

}  // namespace

Region offset_region(const Region& region, double delta, const OffsetRule& rule) {
  check_size(region, rule);
  ClipperLib::ClipperOffset clipper(kMiterLimit, rule.tolerance * kGrid);
  for (const Outline& o : region.outlines) {
    ClipperLib::Path path;
    for (const Vec2& p : o.points) {
      const GridPoint g = on_grid(p);
      path.emplace_back(g.x, g.y);
    }
    clipper.AddPath(path, join_type(rule.corner), ClipperLib::etClosedPolygon);
  }
  on_grid({delta, 0});
  ClipperLib::PolyTree tree;
  clipper.Execute(tree, delta * kGrid);
  Region out;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext()) {
    ClipperLib::Path clean;
    ClipperLib::CleanPolygon(node->Contour, clean);
    if (clean.size() < 3) continue;
    Outline& outline = out.outlines.emplace_back();
    for (const ClipperLib::IntPoint& p : clean) outline.points.push_back(off_grid({p.X, p.Y}));
    outline.arc.assign(outline.points.size(), -1);
  }
  tag_moved(out, region, delta, rule);
  return out;
}

}  // namespace burin::csg
