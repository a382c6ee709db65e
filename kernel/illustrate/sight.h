#pragma once
// What is seen of which lines when some parts can be looked through; internal to the module.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>
#include <burin/visibility/occluder.h>
#include <burin/visibility/visible_spans.h>

#include "part_styles.h"

#include <span>
#include <vector>

namespace burin::detail {

/// Spans of features and of strokes, one list a curve.
struct Seen {
  std::vector<std::vector<Span>> features, strokes;
  /// See VisibilityMap; the largest.
  double merged_cuts = 0;
};

/// All arguments must outlive it.
class Sight {
 public:
  Sight(std::span<const ProxyMesh* const> proxies, const Camera& camera,
        const PartStyles& part_styles, const RunContext& context);

  /// The parts that hide others.
  const Occluder& solid() const { return solid_; }
  /// What stands before a transparent part: the solid ones and itself.
  Occluder before(std::size_t part, const RunContext& context) const;
  /// One tree of rays a transparent part, one after the other.
  Seen classify(std::span<const Curve3> features, std::span<const Curve3> strokes,
                const RunContext& context) const;
  /// Appends what is missing of the outer outline (`outline_gaps`); of parts that can be looked
  /// through nothing, whose outlines end behind others.
  void close_outline(std::vector<Curve3>& features, Seen& seen, const RunContext& context) const;

 private:
  std::vector<const ProxyMesh*> proxies_before(std::size_t part) const;

  std::span<const ProxyMesh* const> proxies_;
  const Camera& camera_;
  const PartStyles& part_styles_;
  std::vector<const ProxyMesh*> solid_proxies_;
  Occluder solid_;
};

}  // namespace burin::detail
