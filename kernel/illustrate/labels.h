#pragma once
// Which parts are seen where on the sheet; internal to the module.

#include <burin/annotate/break_lines.h>
#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/surface/face_colors.h>

#include "occluders.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin::detail {

struct Labels {
  /// What is seen of each part, within the drawn lines: of glass first, which lies over the rest,
  /// by the colours of its faces (`fill`, and `opacity` of those that say it).
  std::vector<Area> areas = {};
  /// The same where `areas` are parted further, and callouts ask for it; else empty.
  std::vector<Area> whole = {};
  /// Below all of them.
  std::optional<Area> shadow = {};
  /// Of a broken view: what of the parts is on each side of each band.
  std::vector<Stretches> cut = {};
};

/// A drawn line that parts may end at.
struct LabelBorder {
  /// Paper mm.
  std::vector<Vec2> points;
  bool closed = false;
  bool operator==(const LabelBorder&) const = default;
};

/// All that labels are made from.
struct LabelRequest {
  std::shared_ptr<const Occluders> occluders;
  Camera camera;
  /// The stretch of the sheet that has ink.
  Box2 box{};
  /// Where areas are made of them.
  std::vector<LabelBorder> borders{};
  /// Of solid parts, too; else of those alone that can be looked through.
  bool solid = true;
  /// One a part, or fewer: the colours of faces by which the areas of glass are told apart; absent:
  /// it has one.
  std::vector<std::shared_ptr<const FaceColors>> colors{};

  LabelRequest(const Drawing& drawing, std::shared_ptr<const Occluders> parts, const Camera& of,
               bool with_solid);
  bool operator==(const LabelRequest&) const = default;
};

/// What can be looked through is seen first, then what is seen through that, and so on. Cost: that
/// of `partition`, and as much for each of these: as many as such parts hide each other whole, one
/// behind the other, 8 at the most. Throws Cancelled.
Labels label(const LabelRequest& wanted, const RunContext& context);

}  // namespace burin::detail
