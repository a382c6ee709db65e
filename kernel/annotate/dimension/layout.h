#pragma once
// Where one dimension may stand; internal to the module.

#include <burin/annotate/dimensions.h>

#include "letters.h"
#include "shapes.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace burin::detail {

/// A place of one dimension.
struct DimensionPlace {
  Footprint print;
  /// About that, once it is laid.
  Box2 about = {};
  Layer layer{"", {}};
  std::vector<Area> areas = {};
  /// The less the better: without the others, and with what is wrong between it and these.
  double alone = 0, cost = 0;
  /// Of a length: across its line, outwards; where the line stands along it, and where it begins
  /// and ends along itself.
  Vec2 outwards{0};
  double level = 0, low = 0, high = 0;
};

/// All that finding a place looks at.
struct DimensionGround {
  const PaperView& view;
  const DimensionOptions& style;
  /// About the parts, and about these and what stands beside them, convex, paper mm.
  std::vector<Vec2> part;
  std::vector<Vec2> outline;
  /// Lines that stand beside the parts.
  std::vector<std::vector<Vec2>> beside;
  Margin taken{0};
  /// Lines that are laid over the drawing later, paper mm.
  const std::vector<std::vector<Vec2>>& over_it;
  /// What texts stand in.
  std::optional<Box2> within;
  const Drawing* drawn = nullptr;
  /// In the order in which places are looked for; those before `own` stay nearer to the drawing.
  std::vector<DimensionPlace> laid = {};
  std::size_t own = 0;
  /// Whether there are so many that fewer places are looked at for each.
  bool many = false;
  /// Whether places are looked for as if the others took up nothing.
  bool alone = false;

  /// Paper mm from what is measured to the first line, and from line to line.
  double first() const { return 2.4 * style.height; }
  double step() const { return 2 * style.height; }
  /// Paper mm that something else takes in a direction.
  double taken_in(Vec2 way) const;
  /// What is wrong with a place.
  Conflicts conflicts(const DimensionPlace& place) const;
};

/// The best place of a dimension; nothing is drawn of one that the view shows as a point.
DimensionPlace place_length(const Dimension& dimension, const DimensionGround& ground);
DimensionPlace place_round(const Dimension& dimension, const DimensionGround& ground);
DimensionPlace place_angle(const Dimension& dimension, const DimensionGround& ground);
DimensionPlace place_note(const Dimension& note, const DimensionGround& ground);

/// Paper mm that conflicts are as bad as.
double cost_of(const Conflicts& found);

/// The first of the steps of a place without a hard conflict; of none that with the fewest.
/// `make`: the place after that many steps. It ends where a place costs `limit` already, as each
/// step costs more.
DimensionPlace first_free(const std::function<DimensionPlace(int)>& make, int steps,
                          const DimensionGround& ground,
                          double limit = std::numeric_limits<double>::infinity());

}  // namespace burin::detail
