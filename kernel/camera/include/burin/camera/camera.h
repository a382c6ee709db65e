#pragma once
/// The view: every map between model millimetres and paper millimetres.

#include <burin/base/box.h>
#include <burin/base/placement.h>
#include <burin/base/vec.h>
#include <burin/camera/paper.h>

#include <functional>
#include <optional>
#include <string_view>

namespace burin {

/// What a user asks of a view.
struct ViewOptions {
  /// From the model to the viewer; any length but zero.
  Vec3 direction{1, -1, 1};
  /// Up on the sheet; where it is (nearly) along `direction` another axis is taken.
  Vec3 up{0, 0, 1};
  /// Vertical field of view of the sheet's inner height in degrees; absent = orthographic.
  std::optional<double> perspective{};
  /// Paper mm per model mm (perspective: in the plane of the model's centre); absent = fit.
  std::optional<double> scale{};
  /// The point in the middle of the sheet; absent = the middle of what is drawn. A perspective view
  /// needs a scale with it, which holds in the plane through this point.
  std::optional<Vec3> center{};
  /// Empty border of the sheet in mm that a fitted drawing keeps.
  double margin = 10;
  Paper paper{};
};

/// The direction to the viewer (and up) of "front back left right top bottom iso dimetric
/// trimetric" or of "X,Y,Z". Throws UsageError for anything else and for the zero vector.
struct NamedView {
  Vec3 direction;
  Vec3 up;
};
NamedView named_view(std::string_view name);

/// A ray through a point of the paper, from the viewer into the scene; `direction` is a unit
/// vector.
struct ViewRay {
  Vec3 origin;
  Vec3 direction;
};

/// An orthographic or perspective projection onto the sheet. Immutable.
class Camera {
 public:
  /// Bounds of the model in given axes: takes a rotation whose ROWS are the axes, returns the box
  /// of the model's points in them.
  using ExtentFn = std::function<Box3(const Mat3& axes)>;

  /// A camera that shows the model in the middle of the sheet. Throws GeometryError where the
  /// extent is empty or not finite. A model that is a single point gets scale 1.
  static Camera fit(const ExtentFn& extent, const ViewOptions& options);

  /// The same picture of what `placement` takes to the scene: shows a point p where this camera
  /// shows `placement.point(p)`. The placement mirrors nothing.
  Camera inside(const Placement& placement) const;

  /// The same picture on another sheet, where the bottom left corner of this one lies at `corner`.
  Camera on_sheet(const Paper& sheet, Vec2 corner) const;

  /// The same picture `factor` times as large, where what this one shows at `from` lies at `to`:
  /// the viewer stands where it stood.
  Camera magnified(double factor, Vec2 from, Vec2 to) const;

  bool perspective() const { return eye_distance_ > 0; }
  const Paper& paper() const { return paper_; }
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  /// Unit vector from the model to the viewer (perspective: of the sheet's centre).
  Vec3 direction() const { return direction_; }
  /// Rows: right, up and direction.
  Mat3 axes() const { return glm::transpose(Mat3(right_, up_, direction_)); }
  Vec3 center() const { return center_; }
  Vec2 offset() const { return offset_; }
  /// Paper mm per model mm (perspective: in the plane through `center`).
  double scale() const { return scale_; }
  /// The viewer's place; perspective only.
  Vec3 eye() const { return center_ + direction_ * eye_distance_; }
  /// Vertical field of view in degrees; 0 for an orthographic camera.
  double field_of_view() const { return field_of_view_; }

  /// Paper millimetres, origin bottom left, y up.
  Vec2 to_paper(Vec3 p) const;
  /// Model mm along `direction` from the plane through `center`; larger is nearer to the viewer.
  /// Orders points that fall on one paper point, in perspective too.
  double depth(Vec3 p) const { return glm::dot(p - center_, direction_); }
  /// Unit vector from `p` to the viewer.
  Vec3 to_viewer(Vec3 p) const;
  /// Model mm from `p` to the viewer; infinite for an orthographic camera.
  double distance_to_viewer(Vec3 p) const;
  /// Paper mm per model mm at `p` for lengths at a right angle to the view.
  double scale_at(Vec3 p) const;
  /// Area on paper over area at a right angle to the ray at `p`, in paper mm2 a model mm2; not
  /// positive or not finite where `p` is beside or behind the viewer.
  double area_scale(Vec3 p) const;
  /// The derivative of `to_paper` at `p` along `t`.
  Vec2 velocity(Vec3 p, Vec3 t) const;
  /// The viewing ray through a point of the paper. Orthographic: the origin lies in the plane
  /// through `center` (step back along -direction before casting).
  ViewRay ray(Vec2 paper) const;

  bool operator==(const Camera&) const = default;

 private:
  Paper paper_;
  Vec3 right_{1, 0, 0}, up_{0, 1, 0}, direction_{0, 0, 1}, center_{0};
  Vec2 offset_{0};
  double scale_ = 1;
  double eye_distance_ = 0;
  double field_of_view_ = 0;
};

}  // namespace burin
