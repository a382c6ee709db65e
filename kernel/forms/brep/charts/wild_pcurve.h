#pragma once
/// Curves in faces that a damaged file has led astray.

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace burin {

/// The curve of an edge in a face over `first`..`last`, and the edge in space (null where it has no
/// curve there) over `edge_first`..`edge_last`.
struct EdgeInFace {
  Handle(Geom2d_Curve) curve;
  double first = 0, last = 0;
  Handle(Geom_Surface) surface;
  Handle(Geom_Curve) edge;
  double edge_first = 0, edge_last = 0;
};

/// Whether no pole of a spline is without numbers, or so far from where the others are that it was
/// changed; of any other curve true.
bool has_sound_poles(const Handle(Geom2d_Curve) & curve);

/// Whether the curve leaves the surface and there lies beside the edge by more than a small share
/// of the part's `size`. A few evaluations, none of the surface where the curve stays on it.
bool leaves_edge(const EdgeInFace& use, double size);

/// Whether the curve is many times the surface's size away from it, where a spline only grows:
/// OCCT's mesher would not come to an end.
bool leaves_surface(const EdgeInFace& use);

}  // namespace burin
