#pragma once
/// Fitting one smooth run of points with given tangents at its ends.

#include <burin/drawing/bezier.h>

#include <span>
#include <vector>

namespace burin {

/// Cosine of 30 degrees: a sharper turn is a corner that the eye should see.
constexpr double kCornerCosine = 0.8660254037844386;
/// The share of the tolerance spent on leaving points out; the fit has the rest.
constexpr double kSimplifyShare = 0.25;

/// The unit direction from a to b, which differ.
Vec2 direction(Vec2 a, Vec2 b);

/// The tangent at b of the circle through a, b, c; near to second order for any smooth curve,
/// whatever the spacing.
Vec2 circle_tangent(Vec2 a, Vec2 b, Vec2 c);

/// The straight line from a to b as a cubic.
CubicBezier straight(Vec2 a, Vec2 b);

/// Appends cubics that follow `points` (two or more, no two neighbours equal) within `tolerance`.
/// `start` and `end` are the unit tangents there, both in the sense of travel.
void fit_run(std::span<const Vec2> points, Vec2 start, Vec2 end, double tolerance,
             std::vector<CubicBezier>& out);

/// Fits an open polyline that needs no thinning: corners and straight runs first, then the runs
/// between them. Points that repeat are ignored.
void fit_thinned(std::span<const Vec2> points, double tolerance, std::vector<CubicBezier>& out);

}  // namespace burin
