#pragma once
/// Direction fields: which way a stroke goes at a point.

#include <burin/base/image.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/field/options.h>
#include <burin/surface/surface.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A point of one part together with its local geometry.
struct FieldQuery {
  std::int32_t part = 0;
  const SurfacePoint& point;
  const Frame& frame;
};

/// A function on a surface and its gradient along it (1/model mm).
struct Level {
  double value = 0;
  Vec3 gradient{0};
  /// The gradient in space, where the function is defined off the surface, too; else zero.
  Vec3 in_space{0};
};

/// The lines that strokes may follow at a point. A line has no sign: who follows one chooses it.
struct Cross {
  /// Unit tangents, of family 1 and of family 2; not always at a right angle.
  Vec3 first{1, 0, 0}, second{0, 1, 0};
  /// How certain the lines are: 0 = arbitrary, up to 1 = given by the shape, 2 = one cross chosen
  /// for a whole face. Strokes start where it is largest.
  double certainty = 0;
  /// Where one of the families runs along the level lines of a function: that function, by which
  /// strokes are held on their lines.
  std::optional<Level> level{};
  /// Sine of the angle between the normal and the direction that the field is the tangent part of;
  /// 1 where it is of none.
  double lean = 1;
};

/// The direction of a family, 1 or 2.
Vec3 family_direction(const Cross& cross, int family);
/// The direction in which a stroke that comes in along `previous` (not zero) goes on, with its
/// sign.
Vec3 direction_along(const Cross& cross, Vec3 previous);

/// A named direction field: a cross, or nothing where the field is singular. The function may be
/// called from many threads.
struct Field {
  std::string name;
  std::function<std::optional<Cross>(const FieldQuery&)> cross;
  /// Whether its families may change names where that serves the drawing: nobody asked for one of
  /// them.
  bool free = false;
};

namespace field {

/// The part of a fixed model direction that is tangent.
Field fixed(Vec3 direction);
/// The same with a direction for each part (one a surface) that is as far as can be from all of its
/// normals and their opposites, most by area: outside its Gauss map, where there is an outside. Of
/// directions that are as good the nearest to `usual`. Cost: 5 to 15 ms a part. @cite Elber1998
Field fixed_auto(const std::vector<const Surface*>& surfaces, Vec3 usual,
                 const RunContext& context);
/// The principal directions: family 1 across the larger |curvature| bends most (d1 or d2 by |k|),
/// family 2 along it.
Field principal();

/// Family 1 runs along the curves in which planes with this normal cut the surface, family 2 at a
/// right angle. Nothing where the surface is parallel to them, within half a degree.
Field planes(Vec3 normal);
/// Family 1 is upright on the sheet: it runs along the curves in which planes through the line of
/// sight and up cut the surface (in perspective they turn about the eye), family 2 at a right
/// angle. Nothing where the surface is parallel to them, within half a degree. @cite Elber1998
Field screen_vertical(const Camera& camera);
/// Family 1 runs at a right angle to the normal and to the line of sight, as silhouettes do: along
/// the curves of equal distance to the viewer. Family 2 runs at a right angle, to and from the
/// silhouettes. Nothing where the surface is seen square on, within half a degree. @cite Elber1998
Field silhouette(const Camera& camera);
/// The same with its families exchanged: family 1 runs to and from the silhouettes.
Field silhouette_across(const Camera& camera);
/// The parameter lines of the chart: family 1 along u, family 2 along v, which need not be at a
/// right angle. Nothing on forms without parameters (meshes, implicit ones) and at poles.
Field isoparametric();

/// Family 1 runs across the gradient of a picture that lies over the surface by its u and v,
/// blurred as by a Gaussian of a standard deviation of `blur` of its sides; family 2 along it.
/// Nothing where the surface has no u and v, or the picture is even. Throws UsageError where there
/// is no picture.
/// @cite Elber1998
Field texture_image(const std::vector<const Surface*>& surfaces,
                    const std::shared_ptr<const Image>& image, double blur);
/// Family 1 runs where u and v change as two formulas (burin/expression/formula.h) over u v x y z
/// say, family 2 at a right angle. Nothing where the surface has no u and v, or both are 0 or no
/// numbers. Throws UsageError where a text is no formula. @cite Elber1998
Field texture_vector(const std::vector<const Surface*>& surfaces, const std::string& along_u,
                     const std::string& along_v);

struct AngleOptions {
  /// What flat places follow: the tangent part of this direction, or of an axis where it is nearly
  /// normal.
  Vec3 fallback{0, 0, 1};
  /// 1/model mm: a place is flat where its larger |curvature| (plus, in perspective, 1 / distance
  /// to the viewer) is no more than this. 0 = only true planes are.
  double flat = 0;
};

/// Lines of constant angle between the normal and the line of sight (perspective: that of the
/// point), from the change of the normal along the principal directions: family 1 along them,
/// family 2 across. Contours are such lines. Nothing where the gradient of the angle vanishes (it
/// is largest, smallest, or at a saddle), within half a degree. @cite Elber1998
Field isophote(const Camera& camera, const AngleOptions& options);
/// The same for the angle to a light from a direction in model space: lines of equal light.
Field isophote(Vec3 light, const AngleOptions& options);
/// The same cross as `isophote`, its families exchanged: family 1 runs where that angle changes
/// most, into the contours.
Field steepest(const Camera& camera, const AngleOptions& options);

struct SmoothedOptions {
  /// Weight of the confident directions against smoothness, relative; larger follows curvature more
  /// closely.
  double alignment = 1;
  /// Direction in model space that parts without any confident direction (spheres, planes) follow.
  Vec3 fallback{0, 0, 1};
  FacePolicy policy{};
  /// Direction from the model to the viewer, for FacePolicy::Sphere::View.
  Vec3 view{0, 0, 1};
};

/// A smoothed 4-symmetric cross field over the proxies of `surfaces` (one per part): keeps
/// confident principal directions, follows creases, and flows into planes, umbilics and noise.
/// Family 1 is, at a seed, the arm nearest to the direction of larger absolute curvature (in
/// regions without one: to the region's fixed choice). On exact forms the arms are the exact
/// principal directions wherever the surface has some worth following; the cross says which family
/// they belong to.
/// @cite Knoeppel2013
Field smoothed(const std::vector<const Surface*>& surfaces, const SmoothedOptions& options,
               const RunContext& context);

}  // namespace field
}  // namespace burin
