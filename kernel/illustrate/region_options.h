#pragma once
// What the styles of parts say of regions; internal to the module.

#include <burin/camera/camera.h>
#include <burin/feature/options.h>
#include <burin/surface/face_colors.h>
#include <burin/surface/scene.h>

#include "part_styles.h"
#include "regions.h"

#include <memory>
#include <vector>

namespace burin::detail {

/// The kinds of lines that any part shows.
FeatureOptions feature_options(const PartStyles& part_styles);

/// The colours of faces of parts that show them.
std::vector<std::shared_ptr<const FaceColors>> face_colors(const Scene& scene,
                                                           const PartStyles& part_styles);

/// What parts the sheet where parts have flat colours. `shadows`: parts without steps have two.
RegionOptions region_options(const Scene& scene, const PartStyles& part_styles,
                             const Camera& camera, bool shadows);

/// Whose faces are areas of their own; `all`: those of all parts that are drawn.
std::vector<bool> told_faces(const PartStyles& part_styles, bool all);

/// Where areas of a step hold the darker ones.
std::vector<bool> nested_fills(const PartStyles& part_styles);

/// What the light passes through: `transparent`, and solid parts whose style casts no shadow.
std::vector<bool> without_shadow(const PartStyles& part_styles, std::vector<bool> transparent);

}  // namespace burin::detail
