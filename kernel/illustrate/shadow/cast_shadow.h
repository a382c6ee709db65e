#pragma once
// Shadows of parts on parts; internal to the module.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/feature/isophotes.h>
#include <burin/visibility/occluder.h>

#include "exact_places.h"
#include "light_view.h"
#include "occluders.h"

#include <span>
#include <vector>

namespace burin::detail {

/// The borders of shadows that solid parts cast on each other and on themselves, as lines on what
/// they fall on: the outlines that the light sees, thrown along it onto what comes next. They end
/// where the shadow jumps to something else, within 0.01 mm of paper, and lie within 0.01 mm of the
/// facets that stand for a surface. Hidden ones too. They are of kind Isophote, without normals.
/// Where a part is in its darkest step all the same, or the face of a cut, there are none; `tones`:
/// the steps of each part.
/// The border of light on round surfaces themselves is none of them (`trace_isophotes`). Throws
/// Cancelled. Cost: two rays a mm of outline on the light's sheet, and some 20 where it jumps.
/// `casters`: the occluders but for parts that cast none, of which `light` is the view; shadows
/// fall on those parts, and behind them.
std::vector<Curve3> cast_shadows(const Occluders& occluders, const Occluders& casters,
                                 const LightView& light, const Camera& camera,
                                 std::span<const Isophotes> tones, const RunContext& context);

/// Whether one of the `casters` stands between the light and a place of a solid part that is turned
/// to it. Facets do not shade each other where they stand for one round surface, nor do those of
/// two parts that touch, where it is the facets alone that lie before each other.
bool in_shadow(const Occluders& occluders, const Occluder& casters, const ExactDepths& depths,
               const ViewHit& at, Vec3 to_light);

}  // namespace burin::detail
