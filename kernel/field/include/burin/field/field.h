#pragma once
/// Direction fields: which way a stroke goes at a point.

#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
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
  /// The direction the stroke came in; resolves the sign of a line field and the arm of a cross
  /// field. The zero vector at a seed.
  Vec3 previous{0};
  /// 1 or 2: the family asked for at a seed. While `previous` is not zero the arm nearest to it is
  /// followed.
  int family = 1;
};

/// Returns a unit tangent, or nothing where the field is singular.
using DirectionFn = std::function<std::optional<Vec3>(const FieldQuery&)>;

/// How clearly the field speaks at a seed: 0 = by chance, up to 1 = the shape says so, 2 = decided
/// for a whole face.
using CertaintyFn = std::function<double(const FieldQuery&)>;

/// A function on a surface and its tangent gradient (1/model mm).
struct Level {
  double value = 0;
  Vec3 gradient{0};
};
/// What lines that are meant to be level lines keep; nothing where it stands still.
using LevelFn = std::function<std::optional<Level>(const SurfacePoint&, const Frame&)>;

/// A named direction field. The functions may be called from many threads.
struct Field {
  std::string name;
  DirectionFn direction;
  /// Strokes start where it is largest. Absent = the frame's confidence.
  CertaintyFn certainty{};
  /// Where one family runs along the level lines of a function: that function, by which strokes are
  /// held on their lines. Absent = strokes follow the directions alone.
  LevelFn level{};
};

namespace field {

/// The part of a fixed model direction that is tangent.
Field fixed(Vec3 direction);
/// The principal directions: family 1 across the larger |curvature| bends most (d1 or d2 by |k|),
/// family 2 along it.
Field principal();

/// Family 1 runs along the curves in which planes with this normal cut the surface, family 2 at a
/// right angle. Nothing where the surface is parallel to them, within half a degree.
Field planes(Vec3 normal);
/// The tangent part of the camera's up direction: `fixed` seen from the sheet.
Field screen_vertical(const Camera& camera);
/// The parameter lines of the chart: family 1 along u, family 2 along v, which need not be at a
/// right angle. Nothing on forms without parameters (meshes, implicit ones) and at poles.
Field isoparametric();

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
/// family 2 across. Contours are such lines. Nothing where the angle stands still (it is largest,
/// smallest, or at a saddle), within half a degree. @cite Elber1998
Field isophote(const Camera& camera, const AngleOptions& options);
/// The same for the angle to a light from a direction in model space: lines of equal light.
Field isophote(Vec3 light, const AngleOptions& options);
/// The same cross as `isophote`, its families exchanged: family 1 runs where that angle changes
/// most, into the contours.
Field steepest(const Camera& camera, const AngleOptions& options);

/// What strokes follow on the faces of exact forms whose kind is known. Meshes have no such faces.
struct FacePolicy {
  enum class Plane {
    Differ,     // one direction a face along its outline, chosen so that neighbours over a crease
                // differ and smooth neighbours agree
    Direction,  // the tangent part of `fallback`
  };
  enum class Ruled { Circles, Rulings };
  enum class Sphere {
    Axis,  // circles of latitude about `fallback`
    View,  // ... about `view`
  };
  Plane plane = Plane::Differ;
  /// Which of the two is family 1.
  Ruled cylinder = Ruled::Circles;
  Ruled cone = Ruled::Circles;
  /// Spheres that nothing else tells a direction: a ball, not the corner between fillets.
  Sphere sphere = Sphere::Axis;
};

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

/// A smoothed 4-symmetric cross field over the proxies of `surfaces` (one a part): keeps confident
/// principal directions, follows creases, and flows into planes, umbilics and noise. Family 1 is,
/// at a seed, the arm nearest to the direction of larger absolute curvature (in regions without
/// one: to the region's fixed choice). On exact forms the arms are the exact principal directions
/// wherever the surface has some worth following; the cross says which family they belong to.
/// @cite Knoeppel2013
Field smoothed(const std::vector<const Surface*>& surfaces, const SmoothedOptions& options,
               const RunContext& context);

}  // namespace field
}  // namespace burin
