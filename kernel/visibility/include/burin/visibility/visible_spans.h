#pragma once
/// Which spans of a curve can be seen.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/visibility/occluder.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// A piece of a curve between two parameters (segment index plus share of the segment, 0 ..
/// segment_count()); the spans of a curve follow each other without gap. On a closed curve the last
/// one may be continued by the first.
struct Span {
  double begin = 0;
  double end = 0;
  bool visible = true;
  /// Visible, occluding, and on one side of it in the picture there is nothing but paper (looked at
  /// 0.2 mm beside it, more where the proxy's chord error is more): the outer outline.
  bool outer = false;
};

struct VisibilityOptions {
  /// Pieces shorter than this many paper mm take the answer of their neighbours.
  double minimum_length = 0.05;
  /// Whether `outer` is to be found out.
  bool classify_outer = false;
};

/// Visibility in one view. The picture is cut by the occluding curves (crossings in the plane,
/// found by a grid); every piece of a curve between two cuts gets one answer from a vote of
/// occlusion rays; along a chain the answer may change only at a cut, at a change of `self_hidden`,
/// where a stroke's surface turns away or where a curve passes through a surface. Features are cut
/// by every occluding feature before or at their depth, other curves by the visible ones alone: the
/// foremost sheet of the picture changes nowhere else. A line exactly behind a nearer line is
/// hidden.
/// @cite Appel1967, Benard2019
class VisibilityMap {
 public:
  /// `features`: all feature lines of the view; the occluding ones among them cut. All arguments
  /// must outlive the map.
  VisibilityMap(const Occluder& occluder, std::span<const ProxyMesh* const> proxies,
                const Camera& camera, std::span<const Curve3> features, const RunContext& context);
  ~VisibilityMap();

  /// Where the features cross each other millions of times, as those of damaged files do: the paper
  /// mm within which the places were visibility may change count as one. Else 0.
  double merged_cuts() const;

  /// The spans of each curve. `curves` may be the features themselves (the same memory), whose rays
  /// were cast before. Deterministic for any number
  /// of threads.
  std::vector<std::vector<Span>> classify(std::span<const Curve3> curves,
                                          const VisibilityOptions& options,
                                          const RunContext& context) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Neighbouring spans of one kind made one; on a closed curve of `count` segments the last may take
/// in the first and run past the end.
std::vector<Span> merged(const std::vector<Span>& spans, bool closed, double count);

/// The part of `curve` between two parameters as a curve of its own: per-point arrays are
/// interpolated at both ends. On a closed curve `end` may exceed segment_count() and wraps.
Curve3 slice(const Curve3& curve, double begin, double end);

}  // namespace burin
