#pragma once
/// Where a legend stands on its sheet.

#include <burin/annotate/annotate.h>
#include <burin/annotate/options.h>
#include <burin/base/box.h>
#include <burin/camera/paper.h>

#include <optional>

namespace burin {

/// The box of the legend that the annotations have, paper mm; nothing where there is none or it has
/// no room.
std::optional<Box2> legend_box(const Annotations& annotations, const CalloutOptions& style,
                               const Paper& paper);

/// The largest scale at which a drawing of the size `Annotations::shape` fits beside the tables, to
/// compare with that of other tables. If the shape is not known: the root of the area in paper mm.
double scale_beside_tables(const Annotations& annotations, const CalloutOptions& style,
                           const Paper& paper);

}  // namespace burin
