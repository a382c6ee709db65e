#pragma once
// A view of a model of which stretches are left out; internal to the module.

#include <burin/annotate/dimensions.h>
#include <burin/arrange/illustration.h>
#include <burin/base/box.h>
#include <burin/camera/camera.h>
#include <burin/camera/sheet.h>
#include <burin/drawing/paper_breaks.h>
#include <burin/illustrate/sheet.h>
#include <burin/surface/scene.h>

#include "uniform_stretches.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace burin::detail {

/// What a view leaves out. In views at a slant to the axis this is less than in others: what shows
/// nothing but the stretch.
class BrokenAs {
 public:
  BrokenAs() = default;
  /// Nothing in perspective, and in views that see the axis from its end.
  BrokenAs(const Scene& scene, const Illustration& illustration, const ViewOptions& view);

  bool empty() const { return bands_.empty(); }
  /// The same extent as the view shows it, without its gaps.
  Camera::ExtentFn shortened(Camera::ExtentFn whole) const;
  /// Paper mm on each side that gaps and break lines take.
  Margin room() const;
  /// What is left out on paper. `origin`: paper mm along the way, where the model's origin is.
  PaperBreaks on_paper(double scale, double origin) const;
  /// The same in a view with that camera, whose `center`, if any, stays where it is.
  PaperBreaks on_paper(const Camera& camera, const ViewOptions& view) const;
  /// Moves a dimension to where the view shows something of what it measures; false where it shows
  /// nothing of it.
  bool put_where_seen(Dimension& one) const;
  /// Whether what is left of parts reaches both ends of them along x, y and z. Cost: a look at each
  /// triangle.
  std::array<bool, 3> reaches(const MeasuredParts& parts) const;
  /// Dimensions of what is left at a scale, about the middle of the shortened view.
  ViewDimensions moved(const ViewDimensions& dimensions, double scale) const;
  /// The same where `breaks` take what the camera shows.
  ViewDimensions moved(const ViewDimensions& dimensions, const Camera& camera,
                       const PaperBreaks& breaks) const;

 private:
  class Mover;

  static ViewDimensions moved(ViewDimensions dimensions, const Mover& mover);
  /// Model mm along the way.
  bool leaves_out(double at) const;
  bool leaves_out(const Vec3& p) const { return leaves_out(glm::dot(way_, p)); }
  std::pair<double, double> longest_left(double low, double high) const;
  std::vector<Vec3> seen_of(const std::vector<Vec3>& points) const;
  void add_left(const Vec3& p, const Vec3& q, Box3& to) const;

  /// Of the model, unit; how long it is on paper; its way there and that in the model.
  Vec3 axis_{1, 0, 0};
  double foreshortened_ = 1;
  Vec2 along_{1, 0};
  Vec3 way_{1, 0, 0};
  /// Model mm along that way.
  std::vector<PaperBreaks::Band> bands_;
  /// Paper mm: the gaps, and how far break lines go on beyond the parts.
  double gap_ = 0, reach_ = 0;
};

/// Tells of breaks that no view of the sheet shows, of those that are no shorter than a gap, and of
/// parts that no view shows.
void report_unbroken(Scene& scene, const Illustration& illustration, const SheetOfViews& sheet);

/// Breaks a view that has its camera, with its dimensions.
void break_view(const BrokenAs& broken, const ViewOptions& view, PlacedView& placed);

}  // namespace burin::detail
