#pragma once
/// Whether a finished drawing is true: every visible and hidden span against rays of its own.

#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/surface/scene.h>
#include <burin/verify/areas.h>

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// How each part stands in the picture.
enum class PartOpacity : std::uint8_t {
  Solid,
  /// Hidden by solid parts and by itself, hides no other.
  Transparent,
  Absent,
};

struct VerifyOptions {
  /// Model mm: the chord tolerance that the drawing's own tessellation was asked for.
  double tolerance = 0.05;
  /// One a part, in order; parts beyond its end are solid.
  std::vector<PartOpacity> parts{};
  /// Degrees from which edges of a mesh were sharp, one a part; empty: as RealiseOptions has it.
  std::vector<double> crease_angles{};
  /// Whether the outer outline is drawn whole, so that its loose ends are defects.
  bool outline = true;
  /// `OccluderOptions::ranks` of the drawing.
  std::vector<double> ranks{};
  /// Areas are tested where they are given; `AreaRule::glass` follows from `parts`.
  std::optional<AreaRule> areas{};
  /// Paper mm: where they are tested; empty: all over the sheet.
  Box2 shown{};
};

/// Tests `lines` (all that `drawing` draws, with points3 as dense as they were found, and what it
/// leaves out as hidden) every 0.125 mm of paper; a line of less than 0.5 mm is not tested. A
/// contradiction is a stretch of 0.5 mm and more of one line where at every place, wherever one
/// looks within 0.1 mm (or twice the drawing's tolerance, if that is more), rays against a
/// tessellation four times finer than the drawing's say the opposite of it
/// (kernel/verify/README.md). Areas are tested as `wrong_areas` has it, on the sheet and a mm
/// around them and the lines. The longest twenty of lines and the largest twenty of areas are named
/// in `diagnostics`, so are parts that cannot be tessellated. Rays are timed as stage "verify".
/// Deterministic for any number of threads; throws Cancelled. Cost: at most 1,000 rays a mm of
/// line, mostly 8, and the tessellation.
Verification verify(const Drawing& drawing, std::span<const Path> lines, const Scene& scene,
                    const Camera& camera, const VerifyOptions& options, Diagnostics& diagnostics,
                    RunContext& context);

/// Stretches of the border between object and paper, as a grid of rays a quarter of a mm apart
/// finds it (wider where that would be more than a million), without a visible feature line within
/// 0.25 mm, or what the facets there leave open: "missing", those of 0.5 mm and more.
std::vector<Contradiction> missing_outline(const Drawing& drawing, const Referee& referee,
                                           const Camera& camera, const RunContext& context);

/// An end of the outer outline with nothing that goes on from it.
struct LooseEnd {
  SourceId source;
  Vec2 at{0};
  Vec3 model{0};
};

/// The outer outline is the border between object and paper, which has no end: the ends of paths in
/// the layer "outline" without another visible feature line within `reach` paper mm (the path
/// itself counts a mm and more away along it). Ends off the sheet or at its border are none.
std::vector<LooseEnd> loose_ends(const Drawing& drawing, double reach = 0.25);

}  // namespace burin
