#pragma once
/// Where the areas of a drawing are wrong.

#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/verify/areas.h>

#include <cstdint>
#include <vector>

namespace burin {

/// A patch where areas state what no ray sees.
struct WrongArea {
  AreaAnswer answer;
  /// mm^2 of paper, and a place in it.
  double size = 0;
  Vec2 at{0};
};

struct AreaFindings {
  /// mm^2 of paper that were tested.
  double tested = 0;
  std::vector<WrongArea> wrong;
};

/// Tests a box of the sheet (paper mm): a seeded random place in each square of 0.5 mm, of a larger
/// one where these would be more than a million. Squares side by side with one kind of wrong places
/// are one patch; 16 places in each say how much of it is wrong. Patches of 0.25 mm^2 and more are
/// listed, the largest first. The same for any number of threads. Throws Cancelled. Cost: that of
/// `AreaJudge::test`, and a search along a row of the sheet.
AreaFindings wrong_areas(const AreaJudge& judge, const Box2& box, std::uint64_t seed,
                         const RunContext& context);

}  // namespace burin
