#pragma once
/// Which parts of two revisions are one and the same, by what is known of each.

#include <burin/base/run_context.h>
#include <burin/congruence/pose.h>
#include <burin/surface/shape_measure.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Where a part whose faces differ has one of its colours.
struct ColorShare {
  /// "#rrggbb"; empty: that of the part itself.
  std::string color;
  /// Model mm^2; of these the middle and, by axis, the mean square of the distance from it.
  double area = 0;
  Vec3 middle{0}, spread{0};
};

/// What matching knows of a part.
struct RevisionPart {
  /// Names from the top of the assembly, without what tells equal ones apart as they are read
  /// (" #2"): several parts may have it.
  std::string path;
  /// The same without any number that tells instances apart ("bolt_2").
  std::string stem;
  ShapeMeasure shape;
  Pose pose;
  /// "#rrggbb" or empty; how much it covers (`Part::opacity`); whether it is drawn at all.
  std::string color;
  double opacity = 1;
  bool drawn = true;
  /// By colour; empty where all faces look alike.
  std::vector<ColorShare> face_colors = {};
};

inline constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();

/// Two parts that are one, or one that has no other.
struct PartMatch {
  /// Numbers of the parts, or kNoPart.
  std::size_t before = kNoPart, after = kNoPart;
  /// Of a pair: its shape stands elsewhere (unknown yet where the shape has changed, too).
  bool moved = false;
  bool changed = false;
  /// Its stem is another one.
  bool renamed = false;
  /// Its colour is another one, or how much it covers by a step of a byte or more, or it is drawn
  /// in one revision alone, or its faces have other colours.
  bool look = false;
  /// Its faces have other colours, or other ones of them have these.
  bool face_colors = false;

  bool same() const {
    return before != kNoPart && after != kNoPart && !(moved || changed || renamed || look);
  }
};

struct MatchTolerance {
  /// Model mm; `Pose::error` of both comes to it.
  double place = 1e-3;
  /// Of areas, volumes and moments.
  double shape = 1e-6;
};

/// Whether the surfaces of two parts lie on each other: asked of pairs whose shapes and poses
/// agree.
using LieOnEachOther = std::function<bool(std::size_t before, std::size_t after)>;

/// Matches each part with at most one of the other revision, the first of these rules first:
/// one shape in one place (of equal paths, then of equal stems, then of any); one shape and one
/// path; one shape and one stem; one path; one stem; one shape; boxes that share half of what they
/// cover together. Where several could be meant the nearest are taken, over 250,000 pairs of one
/// rule and name those of about 50 neighbours each. In the order of the new revision,
/// then those that are gone. Throws Cancelled. Cost: 10 us a part and 1 us a pair of parts of equal
/// name that have moved; the last rule looks at four million pairs at the most.
std::vector<PartMatch> match_parts(std::span<const RevisionPart> before,
                                   std::span<const RevisionPart> after,
                                   const MatchTolerance& tolerance, const LieOnEachOther& lie,
                                   const RunContext& context);

}  // namespace burin
