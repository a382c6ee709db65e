#pragma once
// One streamline of the field through one point, in steps of paper millimetres.

#include "guide.h"
#include "picture.h"
#include "sample_grid.h"

#include <vector>

namespace burin::detail {

/// Paper mm between the samples of a stroke.
constexpr double kStep = 0.4;
/// Cosine to the view: seen more edge-on, a surface turns away.
constexpr double kTurning = 0.35;
/// Gaps that a stroke may be off its level line until it is lost.
constexpr double kLost = 0.5;

/// Why a stroke ends; decides how its end is shaped. Edge: a crease or boundary; Away: the surface
/// turns away from the viewer; Crowded: its neighbours need no line between them any more; Tip: its
/// level line ends inside the surface, and its neighbours close up; Met: the strokes of another
/// family cross its way.
enum class StrokeEnd { Edge, Away, Hidden, Light, Crowded, Tip, Met, Singular, Length, Closed };

/// One place of a stroke under way.
struct StrokeSample {
  SurfacePoint point;
  Vec3 normal{0};   // unit, outward
  Vec3 tangent{0};  // unit, along the stroke
  Vec2 paper{0};
  Vec2 direction{0};  // unit, on paper
  double depth = 0;
  double slope = 0;   // model mm of depth a paper mm
  double facing = 0;  // cosine between the normal turned to the viewer and the view
  double darkness = 0;
  double weight = 1;       // as in GridSample
  double gap = 0;          // paper mm to where the next line would be; 0: not known
  std::uint32_t face = 0;  // of the proxy
  FaceKind kind = FaceKind::Freeform;
  bool bent = true;  // curvature is known and not zero
  std::int32_t region = -1;
  bool front = true;  // its outside faces the viewer
  bool visible = true;
  bool own = true;  // the stroke runs along the arm that the field gives its family here
};

struct TracedStroke {
  std::int32_t part = -1;
  std::vector<StrokeSample> samples;
  StrokeEnd begin_reason = StrokeEnd::Length;
  StrokeEnd end_reason = StrokeEnd::Length;
  bool closed = false;
  int family = 1;
  std::optional<double> level;  // what the stroke keeps, if it runs along a level line of the field
  /// Of a motif, which may be of several strokes: its number among the seeds, and its middle.
  struct Whole {
    std::size_t number = 0;
    StrokeSample middle;
  };
  std::optional<Whole> whole;

  double length() const;  // on paper
};

/// The unit normal on paper of what a stroke ends at, at its first sample or at its last: a
/// contour, or the crease or boundary nearest to it; none where it ends for another reason.
std::optional<Vec2> border_normal(const Picture& picture, const TracedStroke& stroke, bool begin);

/// Fills in what a surface point says of itself; no tangent and no direction.
void look_at(const Picture& picture, std::int32_t part, const SurfacePoint& point,
             const Frame& frame, StrokeSample& out);

/// Whether a stroke may begin there: it faces the viewer and lies on the sheet. Whether something
/// hides it is not asked: that takes a ray.
bool may_begin(const Picture& picture, const StrokeSample& at);

GridSample grid_sample(const StrokeSample& s, std::int32_t part, std::int32_t stroke);

/// How far a stroke goes both ways from its seed.
struct StrokeWay {
  double reach = 0;      // paper mm either way
  double least_ink = 0;  // of its family: it ends where less is asked for
  /// The level line that it is drawn for, and the number of the point of it at the seed; none: it
  /// follows the field alone.
  const LevelLine* line = nullptr;
  std::size_t point = 0;
  /// The strokes so far: beyond its level line it does not run into them.
  const SampleGrid* neighbours = nullptr;
};

class Tracer {
 public:
  Tracer(const Picture& picture, int family) : picture_(picture), family_(family) {}

  /// The sample at a surface point; false where the field is singular or the point turned away.
  /// Whether something hides it is not asked: that takes a ray. The direction is the family's own,
  /// or the arm of the field nearest to `toward` (model space) where that is not zero.
  bool seed(std::int32_t part, const SurfacePoint& point, Vec3 toward, StrokeSample& out) const;

  /// The sample of the family's own arm, or, beside a seam of the families, of the other one that
  /// runs along a direction on paper, turned to run that way.
  bool seed_along(std::int32_t part, const SurfacePoint& point, Vec2 paper,
                  StrokeSample& out) const;

  /// The whole stroke through a seed.
  TracedStroke trace(std::int32_t part, const StrokeSample& seed, const StrokeWay& way) const;

  /// What a stroke that ends with a tip, whose last sample is `tip`, still has before it: the wedge
  /// between its neighbours, as far as there is more than one gap between them. `number` is the
  /// stroke's among the neighbours.
  std::vector<StrokeSample> wedge(const TracedStroke& stroke, StrokeSample tip, double gap,
                                  double least_ink, const SampleGrid& neighbours,
                                  std::int32_t number) const;

 private:
  bool fill(std::int32_t part, const SurfacePoint& point, Vec3 previous, StrokeSample& out) const;
  std::optional<double> level_kept(std::int32_t part, const StrokeSample& seed) const;
  bool keep_level(std::int32_t part, double level, double length, MarchStep& step) const;
  void aim(std::int32_t part, const SurfacePoint& from, Vec3 tangent, double level, double length,
           MarchStep& step) const;
  void end_at_seam(std::int32_t part, const StrokeSample& last,
                   std::vector<StrokeSample>& out) const;
  StrokeEnd extend(std::int32_t part, const StrokeSample& seed, const StrokeWay& way,
                   std::optional<double> level, double sign, std::vector<StrokeSample>& out) const;
  StrokeEnd advance(std::int32_t part, const StrokeSample& seed, const StrokeWay& way,
                    std::optional<double> level, double sign, std::vector<StrokeSample>& out) const;

  const Picture& picture_;
  int family_;
};

}  // namespace burin::detail
