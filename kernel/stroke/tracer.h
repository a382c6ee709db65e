#pragma once
// One streamline of the field through one point, in steps of paper millimetres.

#include "picture.h"
#include "sample_grid.h"

#include <vector>

namespace burin::detail {

/// Why a stroke ends; decides how its end is shaped. Edge: a crease or boundary; Away: the surface
/// turns away from the viewer; Crowded: a neighbour comes too close; Met: a stroke crosses its way.
enum class StrokeEnd { Edge, Away, Hidden, Light, Crowded, Met, Singular, Length, Closed };

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
  std::uint32_t face = 0;  // of the proxy
  std::int32_t region = -1;
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

  double length() const;  // on paper
};

/// Fills in what a surface point says of itself; no tangent and no direction.
void look_at(const Picture& picture, std::int32_t part, const SurfacePoint& point,
             const Frame& frame, StrokeSample& out);

/// Whether a stroke may begin there: it faces the viewer and lies on the sheet. Whether something
/// hides it is not asked: that takes a ray.
bool may_begin(const Picture& picture, const StrokeSample& at);

GridSample grid_sample(const StrokeSample& s, std::int32_t part, std::int32_t stroke);

class Tracer {
 public:
  /// `neighbours`: the family's strokes so far.
  Tracer(const Picture& picture, const SampleGrid& neighbours, int family)
      : picture_(picture), grid_(neighbours), family_(family) {}

  /// The sample at a surface point; false where the field is singular or the point turned away.
  /// Whether something hides it is not asked: that takes a ray. The direction is the family's own,
  /// or the arm of the field nearest to `toward` (model space) where that is not zero.
  bool seed(std::int32_t part, const SurfacePoint& point, Vec3 toward, StrokeSample& out) const;

  /// The unit direction on paper that a stroke coming in along `previous` (model space) has at a
  /// surface point.
  std::optional<Vec2> direction(std::int32_t part, const SurfacePoint& point, Vec3 previous) const;

  /// The whole stroke through a seed, both ways, each at most `reach` paper mm.
  TracedStroke trace(std::int32_t part, const StrokeSample& seed, double reach) const;

  /// The distance that neighbours of this family keep at a place.
  double spacing(const StrokeSample& s) const;

  /// Whether a new stroke of this family may begin here: dark enough, and no neighbour nearer than
  /// `share` of the spacing.
  bool free(std::int32_t part, const StrokeSample& s, double share) const;

 private:
  bool fill(std::int32_t part, const SurfacePoint& point, Vec3 previous, StrokeSample& out) const;
  std::optional<double> level_kept(std::int32_t part, const StrokeSample& seed) const;
  bool keep_level(std::int32_t part, double level, double length, MarchStep& step) const;
  void aim(std::int32_t part, const SurfacePoint& from, Vec3 tangent, double level, double length,
           MarchStep& step) const;
  StrokeEnd extend(std::int32_t part, const StrokeSample& seed, std::optional<double> level,
                   double sign, double reach, std::vector<StrokeSample>& out) const;

  StrokeEnd advance(std::int32_t part, const StrokeSample& seed, std::optional<double> level,
                    double sign, double reach, std::vector<StrokeSample>& out) const;

  const Picture& picture_;
  const SampleGrid& grid_;
  int family_;
};

}  // namespace burin::detail
