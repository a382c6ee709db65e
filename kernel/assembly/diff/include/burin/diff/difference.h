#pragma once
/// What has become of each part of an assembly from one revision to the next.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/diff/match.h>
#include <burin/surface/scene.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// The first that holds, from the top, is what a part is called.
enum class PartChange { Added, Removed, Changed, Moved, Renamed, Look, Same };
inline constexpr std::size_t kPartChanges = 7;

/// "added", "removed", "changed", "moved", "renamed", "look", "same".
const char* to_string(PartChange change);

/// Model mm, mm2, mm3.
struct PartNumbers {
  double volume = 0, area = 0;
  Vec3 box{0};
  std::int64_t faces = 0;
  /// The middle of its surface.
  Vec3 middle{0};
};

struct PartMotion {
  /// How far its middle went, model mm.
  Vec3 by{0};
  /// Degrees about an axis through the middle; absent where no turn was found that lays the shape
  /// on its copy. Of a part that has changed, too, only shifts are looked for: 0.
  std::optional<double> degrees = 0.0;
  Vec3 axis{0, 0, 1};
};

struct PartDifference {
  PartMatch match;
  /// Paths in the assembly; empty where the revision has none.
  std::string before, after;
  std::optional<PartNumbers> numbers_before = {}, numbers_after = {};
  /// Where it has moved.
  std::optional<PartMotion> motion = {};
  /// Of a part that has changed: the share of both surfaces that does not lie on the other's, once
  /// the part is moved back.
  double surface_changed = 0;
  /// "#rrggbb" or empty, how much it covers, and whether it is drawn, in both revisions.
  std::string color_before = {}, color_after = {};
  double opacity_before = 1, opacity_after = 1;
  bool drawn_before = true, drawn_after = true;

  PartChange change() const;
  /// All that holds: a part may be changed, moved and renamed.
  std::vector<PartChange> changes() const;
};

struct Difference {
  /// In the order of the new revision, then those that are gone.
  std::vector<PartDifference> parts;
  MatchTolerance tolerance;
  /// Parts by `PartChange`.
  std::array<std::size_t, kPartChanges> counts{};

  bool same() const { return counts[static_cast<std::size_t>(PartChange::Same)] == parts.size(); }
  std::size_t count(PartChange change) const { return counts[static_cast<std::size_t>(change)]; }
};

/// Places that differ by less are one: share of the diagonal of the larger revision.
inline constexpr double kSamePlace = 1e-5;

/// Compares two revisions. Parts are measured (`Form::measure`) and realised within 2e-4 of their
/// size; `match_parts` says which are one, places being one within 1e-5 of the diagonal of the
/// larger revision, to which a tenth of the chord tolerance of curved CAD faces comes. A surface
/// lies on another where 400 points of each, even by area, have the other within that distance and
/// both chord tolerances, but for 1 %. `drawn`: one flag a part. Stage "build".
/// Diagnostics: "diff.not_measured". Throws Cancelled. Cost: that of realising all parts, and 0.2
/// ms a part whose triangles are not those of the other revision, in their order.
Difference compare_revisions(const Scene& before, const Scene& after,
                             const std::vector<bool>& drawn_before,
                             const std::vector<bool>& drawn_after, Diagnostics& diagnostics,
                             RunContext& context);

}  // namespace burin
