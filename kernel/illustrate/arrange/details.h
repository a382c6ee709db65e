#pragma once
// Places that are drawn again at another scale: what they show, and where; internal to the module.

#include <burin/arrange/illustration.h>
#include <burin/base/box.h>

#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

struct PlannedDetail {
  /// Model mm.
  Vec3 at{0};
  double radius = 0;
  /// Paper mm a model mm.
  double scale = 1;
  std::string letter;
  std::string place;
  /// Parts that it is there for.
  std::vector<std::size_t> parts;
  /// Paper mm: the middle of what is drawn again.
  Vec2 center{0};
};

/// What each detail shows in a view with these axes (rows), at which scale, under which letter.
/// `shorter_side`: paper mm of the sheet without its margin. `taken`: letters that others have.
/// Throws UsageError.
std::vector<PlannedDetail> plan_details(const Scene& scene, const std::vector<DetailView>& details,
                                        const Mat3& axes, double shorter_side,
                                        std::vector<std::string> taken);

/// Where details may stand, paper mm.
struct DetailRoom {
  /// What list and legend leave of the sheet without its margin, and all of that.
  Box2 frame, whole;
  /// The parts list, in the lower right corner of the whole, and the legend.
  std::optional<Box2> list{}, legend{};
};

/// Gives details their places along the right or the lower side of the frame, or above the list,
/// whichever leaves most; returns what is left. Throws UsageError where they have no room.
Box2 place_details(std::vector<PlannedDetail>& details, double caption, const DetailRoom& room);

}  // namespace burin::detail
