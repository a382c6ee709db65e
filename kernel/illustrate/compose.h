#pragma once
// From curves with visible spans to the paths of a drawing; internal to the module.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/visibility/visible_spans.h>

#include "depth_cue.h"
#include "part_styles.h"

#include <span>
#include <string>
#include <vector>

namespace burin::detail {

/// The curves of a view and the spans of each.
struct LinesToDraw {
  std::span<const Curve3> features;
  std::span<const std::vector<Span>> feature_spans;
  std::span<const Curve3> strokes;
  std::span<const std::vector<Span>> stroke_spans;
  /// Seen all along.
  std::span<const Curve3> centres = {};
};

/// How they are to be drawn.
struct Composition {
  std::span<const ProxyMesh* const> proxies;
  const Camera& camera;
  const PartStyles& part_styles;
  /// The drawing's: haloes are one for all parts.
  const Style& style;
  HiddenLines hidden = HiddenLines::None;
  const DepthCue& cue;

  /// Whether hidden features are drawn at all.
  bool shows_hidden() const { return hidden != HiddenLines::None || style.halo.hidden; }
  /// That of the curve's part.
  const Style& style_of(const Curve3& curve) const {
    return part_styles.style(static_cast<std::size_t>(curve.source.part));
  }
  /// Of a stroke.
  const HatchStyle& hatch_of(const Curve3& stroke) const {
    return burin::hatch_of(style_of(stroke), static_cast<std::size_t>(stroke.stroke_kind));
  }
  /// "#rrggbb" where it is not that of the sheet's ink, else empty; of a stroke, of a feature.
  std::string stroke_color(const Curve3& stroke) const;
  std::string feature_color(const Curve3& feature) const;
  bool draws(const Curve3& feature) const;
  /// Paper mm, before depth.
  double feature_width(const Curve3& feature, const Span& span) const;
};

/// Appends the layers: strokes, one per kind and family, then feature lines, thin ones first.
/// `found`, if any, gets what is drawn with all its points, and what is left out as hidden: kind,
/// source, visible, closed and points3 of it.
void compose(const LinesToDraw& lines, const Composition& how, Drawing& drawing,
             const RunContext& context, std::vector<Path>* found = nullptr);

}  // namespace burin::detail
