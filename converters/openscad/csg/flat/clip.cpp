#include "clip.h"

#include <burin/base/error.h>

#include "origins.h"

#include <fmt/format.h>
#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>

namespace burin::csg {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

Path path_of(const Outline& outline) {
  Path path;
  path.reserve(outline.points.size());
  for (const Vec2& p : outline.points) {
    const GridPoint g = on_grid(p);
    path.emplace_back(g.x, g.y);
  }
  return path;
}

Paths paths_of(const Region& region) {
  Paths paths;
  for (const Outline& o : region.outlines) paths.push_back(path_of(o));
  return paths;
}

/// Clipper's own clean-up takes away what is smaller than the grid, as in OpenSCAD.
Region region_of(const ClipperLib::PolyTree& tree, const Origins& origins) {
  Region region;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext()) {
    Path clean;
    ClipperLib::CleanPolygon(node->Contour, clean);
    if (clean.size() < 3) continue;
    Outline& outline = region.outlines.emplace_back();
    for (const IntPoint& p : clean) outline.points.push_back(origins.point({p.X, p.Y}));
    outline.arc.assign(outline.points.size(), -1);
  }
  return region;
}

/// Runs Clipper; where nothing has an area, so that it has nothing to begin with, the result is
/// empty.
template <typename Result>
void run(ClipperLib::Clipper& clipper, ClipperLib::ClipType type, Result& out,
         ClipperLib::PolyFillType fill) {
  try {
    if (!clipper.Execute(type, out, fill, fill)) out = Result();
  } catch (const ClipperLib::clipperException& error) {
    throw InputError(
        fmt::format("polygons that cannot be clipped ({}); simplify them", error.what()));
  }
}

ClipperLib::ClipType clip_type(ClipOp op) {
  return op == ClipOp::Union        ? ClipperLib::ctUnion
         : op == ClipOp::Difference ? ClipperLib::ctDifference
                                    : ClipperLib::ctIntersection;
}

/// Intersections go pair by pair: what lies in all.
void intersect(const std::vector<Paths>& operands, ClipperLib::PolyTree& out) {
  Paths so_far = operands[0];
  for (std::size_t i = 1; i < operands.size(); ++i) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(so_far, ClipperLib::ptSubject, true);
    clipper.AddPaths(operands[i], ClipperLib::ptClip, true);
    run(clipper, ClipperLib::ctIntersection, out, ClipperLib::pftNonZero);
    ClipperLib::PolyTreeToPaths(out, so_far);
  }
}

/// The edges of `a` where the points of `b` carry them: quads that together cover the sum's rim.
void sweep(const Path& a, const Path& b, Paths& quads) {
  const auto at = [&](std::size_t i, std::size_t j) {
    const IntPoint &p = a[i % a.size()], &q = b[j % b.size()];
    return IntPoint(p.X + q.X, p.Y + q.Y);
  };
  for (std::size_t j = 0; j < b.size(); ++j) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      Path quad{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)};
      if (!ClipperLib::Orientation(quad)) ClipperLib::ReversePath(quad);
      quads.push_back(std::move(quad));
    }
  }
}

/// `a`, moved to a point of each outer outline of `b`.
void fill_inside(const Paths& a, const Paths& b, Paths& out) {
  for (const Path& outer : b) {
    if (outer.empty() || !ClipperLib::Orientation(outer)) continue;
    for (Path path : a) {
      for (IntPoint& p : path) p = IntPoint(p.X + outer[0].X, p.Y + outer[0].Y);
      out.push_back(std::move(path));
    }
  }
}

/// Whether an edge along `d` can be on the rim of a sum where a corner between edges along `before`
/// and `after` carries it: the corner reaches farthest that way.
bool reaches(Vec2 before, Vec2 after, Vec2 d) {
  constexpr double kSlack = 1e-6;  // radians, about
  const double slack = kSlack * glm::length(d);
  return cross2(before, after) > 0 && cross2(before, d) >= -slack * glm::length(before) &&
         cross2(d, after) >= -slack * glm::length(after);
}

/// Arcs of `a` about the corners of `b` that carry them.
void add_carried(const Region& a, const Region& b, Origins& origins) {
  for (const Outline& carrier : b.outlines) {
    const std::size_t n = carrier.points.size();
    for (std::size_t j = 0; j < n; ++j) {
      const Vec2 by = carrier.points[j], before = by - carrier.points[(j + n - 1) % n],
                 after = carrier.points[(j + 1) % n] - by;
      for (const Outline& o : a.outlines) {
        for (std::size_t i = 0; i < o.points.size(); ++i) {
          const Vec2 from = o.points[i], to = o.points[(i + 1) % o.points.size()];
          if (o.arc[i] < 0 || !reaches(before, after, to - from)) continue;
          Arc arc = a.arcs[static_cast<std::size_t>(o.arc[i])];
          arc.middle += by;
          origins.add_edge(from + by, to + by, arc);
        }
      }
    }
  }
}

std::size_t edges_of(const Region& region) {
  std::size_t count = 0;
  for (const Outline& o : region.outlines) count += o.points.size();
  return count;
}

/// Counterclockwise.
Path turned_left(const Outline& outline) {
  Path path = path_of(outline);
  if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  return path;
}

/// What Clipper made, its edges with the circles that they stand for.
Region tagged(const ClipperLib::PolyTree& tree, const Origins& origins) {
  Region region = region_of(tree, origins);
  origins.tag(region);
  return region;
}

}  // namespace

Region odd_places(const Region& outlines) {
  Origins origins;
  origins.add(outlines);
  ClipperLib::Clipper clipper;
  for (const Outline& o : outlines.outlines) {
    clipper.AddPath(turned_left(o), ClipperLib::ptSubject, true);
  }
  ClipperLib::PolyTree tree;
  run(clipper, ClipperLib::ctUnion, tree, ClipperLib::pftEvenOdd);
  return tagged(tree, origins);
}

Region clip(ClipOp op, std::span<const Region> operands) {
  if (operands.empty()) return {};
  Origins origins;
  std::vector<Paths> paths;
  for (const Region& r : operands) {
    origins.add(r);
    paths.push_back(paths_of(r));
  }
  ClipperLib::PolyTree tree;
  if (op == ClipOp::Intersection && operands.size() > 1) {
    intersect(paths, tree);
  } else {
    ClipperLib::Clipper clipper;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      clipper.AddPaths(paths[i], i == 0 ? ClipperLib::ptSubject : ClipperLib::ptClip, true);
    }
    run(clipper, clip_type(op), tree, ClipperLib::pftNonZero);
  }
  return tagged(tree, origins);
}

Region covered(std::span<const Outline> triangles, const Origins& origins) {
  Paths paths;
  for (const Outline& o : triangles) paths.push_back(turned_left(o));
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  Paths once;
  run(clipper, ClipperLib::ctUnion, once, ClipperLib::pftNonZero);
  // Outlines that touch themselves come apart, which OpenSCAD found to be needed for meshes.
  ClipperLib::Clipper again;
  again.StrictlySimple(true);
  again.AddPaths(once, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  run(again, ClipperLib::ctUnion, tree, ClipperLib::pftNonZero);
  return tagged(tree, origins);
}

Region minkowski_sum(const Region& a, const Region& b) {
  constexpr double kMostPairs = 4e6;
  if (static_cast<double>(edges_of(a)) * static_cast<double>(edges_of(b)) > kMostPairs) {
    throw InputError(
        "minkowski() of polygons with more than four million pairs of edges; make "
        "them of fewer edges, for example by a lower $fn");
  }
  const Paths left = paths_of(a), right = paths_of(b);
  Paths terms;
  for (const Path& q : right) {
    for (const Path& p : left) sweep(p, q, terms);
  }
  fill_inside(left, right, terms);
  fill_inside(right, left, terms);
  ClipperLib::Clipper clipper;
  clipper.AddPaths(terms, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  run(clipper, ClipperLib::ctUnion, tree, ClipperLib::pftNonZero);
  Origins origins;
  add_carried(a, b, origins);
  add_carried(b, a, origins);
  return tagged(tree, origins);
}

}  // namespace burin::csg
