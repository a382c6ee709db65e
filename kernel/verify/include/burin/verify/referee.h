#pragma once
/// What a place of the picture shows, found by rays against a fine tessellation that nothing which
/// drew the picture has seen.

#include <burin/base/ids.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/surface/scene.h>
#include <burin/visibility/occluder.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

using FineSurfaces = std::vector<std::shared_ptr<const Surface>>;

/// Every part at `tolerance` (chord, model mm), without cuts along any view's contours. A part that
/// cannot be tessellated so finely is taken at up to eight times that, else null. `parts`: one flag
/// a part, which ones; empty = all. `crease_angles`: degrees, one a part, from which edges of
/// meshes are sharp; as RealiseOptions has it for parts beyond the end.
FineSurfaces fine_surfaces(const Scene& scene, double tolerance, const std::vector<bool>& parts,
                           const std::vector<double>& crease_angles, RunContext& context);

/// What the drawing says of a point of a line, and what speaks against it.
enum class Finding : std::uint8_t {
  Holds,
  /// Drawn as visible, but wherever one looks something stands before it.
  Covered,
  /// Left out or dashed as hidden, but nowhere does anything stand before it.
  Open,
  /// Drawn as visible, but there is no surface where the line is.
  Adrift,
};
const char* to_string(Finding finding);

struct RefereeOptions {
  /// Paper mm around a place that are looked at: what differs within it is not told apart.
  double radius = 0.1;
  /// Paper mm of depth or of place that both tessellations may be off together.
  double slack = 0.0625;
  /// As `OccluderOptions` has them.
  std::vector<double> ranks{};
};

/// One view of fine surfaces. Read by many threads.
class Referee {
 public:
  /// `surfaces`: null and empty ones hide nothing. The camera must outlive the referee. Throws
  /// Cancelled.
  Referee(FineSurfaces surfaces, const Camera& camera, const RefereeOptions& options,
          const RunContext& context);

  /// Whether rays within `radius` mm of a place see more than one smooth sheet of one face: paper
  /// and part, two faces, or a jump in depth.
  bool line_near(Vec2 paper, double radius) const;
  /// What is seen at a place; nothing where there is paper.
  struct Seen {
    SourceId source;
    Vec3 place{0};
    /// Model mm that the triangle may lie beside what it stands for.
    double chord = 0;
  };
  std::optional<Seen> see(Vec2 paper) const;
  /// A sheet of a part that is seen at a place.
  struct Sheet {
    std::int32_t part = -1, face = -1;
    /// Whether it closes a cut, and whether it is of an exact surface.
    bool cut = false, exact = false;
    Vec3 place{0};
    /// Where on its proxy.
    ProxyPoint point;
  };
  /// Whether `accepts` takes the foremost sheet at a place, or one that lies behind it by no more
  /// than both tessellations may be off: any of them may be the one that is seen. False where there
  /// is paper.
  bool may_see(Vec2 paper, const std::function<bool(const Sheet&)>& accepts) const;
  /// Of the exact surface where there is one, else that between the `light_normals` of its proxy;
  /// of the side that is looked at.
  Vec3 normal(const Sheet& sheet, std::span<const Vec3> light_normals) const;
  const FineSurfaces& surfaces() const { return surfaces_; }
  const Camera& camera() const { return camera_; }
  const RefereeOptions& options() const { return options_; }
  /// What stands between a sheet and a light far away.
  enum class Shade : std::uint8_t { Lit, Shaded, Unsure };
  /// `to_light`: from the model. `casting`: the referee of what casts shadows. Unsure: what shades
  /// it, or does not, is as near to the sheet as both tessellations may be off. Cost: two rays.
  Shade shade(const Sheet& sheet, Vec3 to_light, const Referee& casting) const;
  double radius() const { return options_.radius; }
  /// How the surface bends at a line: a contour is a fold, a sharp one where it is an edge.
  enum class Fold : std::uint8_t { None, Sharp, Smooth };
  /// What speaks against `point` of a line being visible, or hidden, as `visible` says. Cost: one
  /// ray where a point is plainly right, up to 150 where nothing speaks for it.
  Finding test(Vec3 point, bool visible, Fold fold) const;

 private:
  struct Sight;
  struct Point;
  std::optional<Sight> look(Vec2 paper) const;
  Sight describe(const Hit& hit, Vec2 paper) const;
  bool differ(const Sight& a, const Sight& b) const;
  double excess(const Point& p, const Sight& s) const;
  template <class Visit>
  void each_sheet(Vec2 paper, const Visit& visit) const;
  bool thin_sheet(const Point& p, Vec2 paper) const;
  double own_sheet(const Point& p) const;
  bool behind_another(const Point& p, Fold fold) const;
  bool in_the_open(const Point& p, Fold fold) const;
  bool surface_near(const Point& p) const;
  Finding test_visible(const Point& p) const;
  Finding test_hidden(const Point& p, Fold fold) const;

  FineSurfaces surfaces_;
  std::vector<const ProxyMesh*> proxies_;
  const Camera& camera_;
  RefereeOptions options_;
  std::unique_ptr<Occluder> occluder_;
};

}  // namespace burin
