#pragma once
/// Charts of OCCT's surfaces.

#include <burin/forms/charted/chart.h>

#include <Geom_Surface.hxx>

#include <memory>

namespace burin {

/// The chart of a surface with its location baked in. `used` is the box of (u,v) that the face
/// takes; directions without an end are cut a little outside it. Planes, cylinders, cones, spheres
/// and tori are evaluated in closed form, Bezier and B-spline surfaces by make_nurbs_chart, the
/// rest (extrusions, revolutions, offsets) by OCCT. Parameters stay those of the surface.
std::shared_ptr<const Chart> make_surface_chart(const Handle(Geom_Surface) & surface,
                                                const ParameterBox& used);

/// The surface below trims, which leave parameters as they are.
Handle(Geom_Surface) without_trims(Handle(Geom_Surface) surface);

/// A chart for a Bezier or B-spline surface; nullptr where it cannot be one.
std::shared_ptr<const Chart> make_spline_chart(const Handle(Geom_Surface) & surface);

/// A chart that asks OCCT. Geom_Surface keeps no cache, so that it is safe for many threads (the
/// adaptors are not). What it throws at singular places becomes zero derivatives.
std::shared_ptr<const Chart> make_evaluated_chart(const Handle(Geom_Surface) & surface,
                                                  const ParameterBox& used);

}  // namespace burin
