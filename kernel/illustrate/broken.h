#pragma once
// Views with stretches left out: drawn whole on a larger paper, then cut and moved together;
// internal to the module.

#include <burin/annotate/break_lines.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/illustrate/sheet.h>
#include <burin/mesh/proxy_mesh.h>

#include "labels.h"
#include "part_styles.h"

#include <span>
#include <vector>

namespace burin::detail {

/// The camera that draws a view whole. Sets `options.broken`. Where nothing is left out it is the
/// view's own.
Camera whole_camera(const Scene& scene, const PlacedView& view, const Style& style,
                    IllustrateOptions& options);
/// The camera of the sheet, where what lies before the first band belongs but for the shift of it.
Camera camera_on_sheet(const Camera& whole, const BrokenView& broken);

/// What of the drawn parts is on each side of each band, low and high in turn. Tells of sides on
/// which faces lie. Cost: a look at each triangle for each side.
std::vector<Stretches> cut_stretches(std::span<const ProxyMesh* const> proxies,
                                     const PartStyles& part_styles, const Camera& camera,
                                     const PaperBreaks& breaks, Diagnostics& diagnostics);

/// Makes the drawing of a whole view, and what is seen where in it, that of the broken one, with
/// its break lines.
void break_drawing(const Camera& camera, const BrokenView& broken, const BreakOptions& style,
                   Labels& labels, Drawing& drawing);

}  // namespace burin::detail
