#pragma once
// Planes, circles, cylinders and others through points with normals; internal to the module.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/measure/feature.h>
#include <burin/surface/face_samples.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin::detail {

using Sample = SampledPoint;

/// How far points may lie beside what they are taken for, of their size; and normals, radians.
struct FitTolerance {
  double place = 0, normal = 0;
};
/// Points and normals of equations: what is beside is rounding of files, of 1e-7 mm at parts of
/// some mm.
inline constexpr FitTolerance kExactFit{1e-6, 1e-5};
/// Corners of triangles in single precision, and their own normals.
inline constexpr FitTolerance kFacetFit{1e-4, 1e-2};

/// The plane, cylinder, cone or sphere that has these points with these normals; kind Other where
/// there is none. Sets kind, point, along, radius, opening, hollow.
Feature fit_surface(std::span<const Sample> samples, const FitTolerance& tolerance);

/// The torus about an axis, where that is what it is.
std::optional<Feature> fit_torus(std::span<const Sample> samples, Vec3 point, Vec3 along,
                                 const FitTolerance& tolerance);

/// A sphere or a cylinder through corners of triangles whose normals are not those of the surface.
Feature fit_facets(std::span<const Vec3> corners, std::span<const Vec3> normals);

/// The feature that a face is which has these triangles, at least one. Throws Cancelled.
Feature feature_of(const Surface& surface, std::int32_t number,
                   const std::vector<std::uint32_t>& triangles, const RunContext& context);

/// The straight line or circle that has these points.
Feature fit_edge(std::span<const Vec3> points);

}  // namespace burin::detail
