#pragma once
// Annotations of parts in a drawing; internal to the module.

#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/pmi.h>
#include <burin/surface/scene.h>
#include <burin/visibility/occluder.h>

#include "part_styles.h"

#include <span>
#include <string>

namespace burin::detail {

/// A view, what is left out of it, and what messages call it; empty: it is the only one.
struct AnnotatedView {
  const Camera& camera;
  const PaperBreaks& breaks;
  const std::string& name;
};

/// Lays them over the drawing, of parts that are drawn: layer "pmi", and areas of role "pmi" for
/// what is filled. An annotation is drawn as a whole or not at all, for a number of which a part
/// covers a digit is another number. Left out and told: what is seen from behind, from its edge or
/// upside down; whose letters are more than half behind parts, but in a view that the file saves;
/// what the file does not show. They stand where the breaks take the view of the camera: lines over
/// a gap go through it, letters stay as they are; annotations that end in a band are left out.
void lay_pmi(const Scene& scene, const PartStyles& part_styles, const AnnotatedView& view,
             const Occluder& solid, const Style& style, Drawing& drawing);

/// What a view may draw of them, in axes as those of `Form::bounds`; empty where there is none.
/// `part_styles`: as in IllustrateOptions.
Box3 pmi_bounds(const Scene& scene, std::span<const PartStyle> part_styles,
                const PmiOptions& options, const ViewOptions& view, const Mat3& axes);

}  // namespace burin::detail
