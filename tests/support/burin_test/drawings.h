#pragma once
/// Drawings made by hand, for tests and benchmarks of the writers.

#include <burin/drawing/drawing.h>

#include <cmath>
#include <numbers>

namespace burin::test {

/// A stroke in waves across the sheet, tapered to points at both ends, its width swelling in
/// between.
inline Path wavy_stroke(Vec2 from, double length, double amplitude, std::size_t n = 100) {
  Path p;
  p.kind = LineClass::Stroke;
  p.source = {0, 3, -1};
  p.field = "smoothed";
  p.family = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n - 1), x = length * t;
    p.points.push_back(from + Vec2(x, amplitude * std::sin(2 * std::numbers::pi * x / 15)));
    p.points3.push_back({p.points.back() / 2.0, std::sin(t)});
    p.width.push_back(std::min({1.0, x / 2.5, (length - x) / 2.5}) *
                      (0.3 + 0.12 * std::sin(x / 4)));
  }
  return p;
}

inline Path feature_line(LineClass kind, std::vector<Vec2> points, bool closed, double width) {
  Path p;
  p.kind = kind;
  p.source = {1, 12, kind == LineClass::Crease ? 7 : -1};
  p.closed = closed;
  for (const Vec2& q : points) p.points3.push_back({q / 2.0, 1});
  p.points = std::move(points);
  p.width.assign(1, width);
  return p;
}

/// Of a part, a face and an edge, with twice its places in the model at depth 1.
inline Path plain_path(std::vector<Vec2> points, bool closed = false) {
  Path p;
  p.closed = closed;
  for (const Vec2& at : points) p.points3.emplace_back(2.0 * at, 1);
  p.points = std::move(points);
  p.width.assign(1, 0.3);
  p.source = {2, 5, 7};
  return p;
}

inline std::vector<Vec2> ring(Vec2 center, double radius, std::size_t n = 180) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    out.push_back(center + radius * Vec2(std::cos(a), std::sin(a)));
  }
  return out;
}

/// A little of everything on a sheet of 200 x 150 mm: two parts, strokes, circle, corners, a hidden
/// line.
inline Drawing sample_drawing() {
  Drawing d;
  d.paper_width = 200;
  d.paper_height = 150;
  d.seed = 42;
  d.style = "engraving";
  d.view.direction = {0, 0, 1};
  d.view.right = {1, 0, 0};
  d.view.up = {0, 1, 0};
  d.view.scale = 2;
  d.view.center = {1, 2, 3};
  d.view.offset = {100, 75};
  d.parts = {{0, "bracket <A&B>", "dir/br\"acket.stl", 1234, 4}, {1, "", "second.obj", 12, 6}};
  Layer strokes{"stroke-1", {}}, hidden{"hidden", {}}, contour{"contour", {}};
  for (int i = 0; i < 12; ++i) {
    strokes.paths.push_back(wavy_stroke({15 + i, 20.0 + 1.2 * i}, 80 + 3 * i, 0.15 * i, 200));
  }
  contour.paths.push_back(feature_line(LineClass::Contour, ring({150, 100}, 30), true, 0.7));
  contour.paths.push_back(
      feature_line(LineClass::Crease, {{20, 60}, {60, 60}, {60, 100}, {20, 130}}, false, 0.25));
  contour.paths.back().source.part = 0;
  hidden.paths.push_back(feature_line(LineClass::Crease, ring({150, 100}, 20), true, 0.18));
  hidden.paths.back().visible = false;
  d.layers = {strokes, hidden, contour};
  d.diagnostics.add(Severity::Warning, "mesh.nonmanifold_edges", 3, "3 edges \"mended\"");
  d.stats = {1246, 12, 1000, 0.8};
  return d;
}

}  // namespace burin::test
