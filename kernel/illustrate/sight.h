#pragma once
// What is seen of which lines when some parts can be looked through; internal to the module.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>
#include <burin/visibility/visible_spans.h>

#include "occluders.h"

#include <memory>
#include <span>
#include <vector>

namespace burin::detail {

using Spans = std::vector<std::vector<Span>>;

/// The feature lines of a view. What is seen of them is found once, where no part can be looked
/// through; else with each set of strokes, one tree of rays a transparent part after the other.
class Sight {
 public:
  /// `features` of all parts, drawn or not: they cut. `closes_outline`: what is missing of the
  /// outer outline is added to them (`outline_gaps`); of parts that can be looked through nothing,
  /// whose outlines end behind others.
  Sight(std::shared_ptr<const Occluders> occluders, const Camera& camera,
        std::vector<Curve3> features, bool closes_outline)
      : occluders_(std::move(occluders)),
        camera_(camera),
        features_(std::move(features)),
        closes_outline_(closes_outline) {}

  /// The spans of strokes. From then on `features` and `feature_spans` say what they say.
  Spans classify(std::span<const Curve3> strokes, const RunContext& context);

  std::span<const Curve3> features() const { return closed_.empty() ? features_ : closed_; }
  const Spans& feature_spans() const { return spans_; }
  /// See VisibilityMap; the largest.
  double merged_cuts() const { return merged_cuts_; }

 private:
  void see_features(const RunContext& context);
  void close_outline(const RunContext& context);
  Spans classify_transparent(std::span<const Curve3> strokes, const RunContext& context);

  std::shared_ptr<const Occluders> occluders_;
  Camera camera_;
  std::vector<Curve3> features_;
  bool closes_outline_;
  /// The features and the gaps that were closed; empty where there are none.
  std::vector<Curve3> closed_;
  Spans spans_;
  double merged_cuts_ = 0;
  /// Refers to the other members: once it is there this must stay where it is.
  std::unique_ptr<VisibilityMap> map_;
};

}  // namespace burin::detail
