#pragma once
// What is reported about a drawing besides its lines; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/illustrate/illustrate.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/stroke/stroke.h>
#include <burin/surface/scene.h>

#include "part_styles.h"

#include <cstdint>
#include <span>

namespace burin::detail {

/// A drawing without lines: sheet, view, parts and the diagnostics of the scene.
Drawing describe(const Scene& scene, std::span<const ProxyMesh* const> proxies,
                 const Camera& camera, const Style& style, std::uint64_t seed);

/// What was done with less care so that the work stays bounded. `merged_cuts`: see VisibilityMap.
void report_bounds(const StrokeResult& strokes, double merged_cuts, Diagnostics& diagnostics);

/// Parts on which laws of u and v say nothing.
void report_unmapped(const Scene& scene, std::vector<std::int32_t> parts, Diagnostics& diagnostics);

/// Faces of glass that are painted as solid.
void report_solid_glass(const Scene& scene, const PartStyles& part_styles,
                        Diagnostics& diagnostics);

/// Choices of strokes that nothing of the drawing looks at, each once.
void report_unused(const PartStyles& part_styles, const IllustrateOptions& options,
                   Diagnostics& diagnostics);

}  // namespace burin::detail
