#pragma once
/// Splines as data, as OCCT's.

#include <burin/converters/trimmed_faces.h>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

namespace burin {

/// Clamped to its domain, with the same points at all parameters; not periodic. Throws
/// GeometryError where OCCT cannot hold it.
Handle(Geom_BSplineSurface) occt_surface(const NurbsData& data);
Handle(Geom2d_BSplineCurve) occt_curve(const TrimCurve& curve);

}  // namespace burin
