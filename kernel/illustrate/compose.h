#pragma once
// From curves with visible spans to the paths of a drawing; internal to the module.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/visibility/visible_spans.h>

#include "looks.h"

#include <span>
#include <vector>

namespace burin::detail {

/// Appends the layers of the strokes: one a family.
void compose_strokes(std::span<const Curve3> strokes, const std::vector<std::vector<Span>>& spans,
                     std::span<const ProxyMesh* const> proxies, const Camera& camera,
                     const Looks& looks, Drawing& drawing);

/// Appends the layers of the feature lines, thin ones first.
void compose_features(std::span<const Curve3> features, const std::vector<std::vector<Span>>& spans,
                      std::span<const ProxyMesh* const> proxies, const Camera& camera,
                      const Looks& looks, HiddenLines hidden, Drawing& drawing);

}  // namespace burin::detail
