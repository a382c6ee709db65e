#pragma once
// What every coverage of the picture needs, and the coverage by its cells that lines at even
// distances come from.

#include "picture.h"
#include "sample_grid.h"
#include "view_raster.h"

#include <vector>

namespace burin::detail {

struct Seed {
  std::int32_t part = -1;
  SurfacePoint point;
  /// Whose strokes start here, where each family has its own.
  int family = 1;
};

struct Coverage {
  std::vector<Seed> seeds;
  /// How many points it has, seeds or cells.
  std::int64_t points = 0;
  /// Paper mm: no seen place that wants ink is farther from its nearest seed than this (Definition
  /// 1 of the paper, measured at the cells of the raster).
  double delta = 0;
  /// Parts for which fewer candidates were tried than their area asks for.
  std::int64_t thinned_parts = 0;
};

/// Sheets of a part over each other that seeds are tried for, counted in areas of the picture: a
/// porous part has some ten, the triangles of a damaged file thousands.
constexpr double kMostSheets = 16;

Box2 box_of(const ViewRaster& raster);

/// Paper mm^2 that the triangles of a surface turned to the viewer would cover of `box`, seen or
/// not: the measure that points of a view-uniform coverage are spread over. A triangle that reaches
/// out of the box counts for no more than the box that both share.
double projected_area(const Surface& surface, const Camera& camera, const Box2& box);

/// Whether both sides of a surface can be seen: it has a border somewhere.
bool is_two_sided(const Surface& surface);

/// What a coverage of one part asks of its surface but for count and weight: of a part that runs
/// off `box` only what reaches into it.
CoverRequest request_of(const Picture& picture, std::int32_t part, const Box2& box);

/// The weight of a coverage that is uniform in the picture, of what can be seen of a surface within
/// `box`: `share(position, darkness, facing, denser)`, with the ink asked for, the cosine to the
/// viewer and what a law of density says.
template <class Share>
std::function<double(Vec3, Vec3)> weight_in_picture(const Picture& picture,
                                                    const ViewRaster& raster, std::int32_t part,
                                                    const Share& share) {
  const bool two_sided = is_two_sided(picture.surface(part));
  return [&picture, &raster, box = box_of(raster), part, two_sided, share](Vec3 position,
                                                                           Vec3 normal) {
    const Camera& camera = picture.camera;
    const Vec2 paper = camera.to_paper(position);
    if (!box.contains(paper)) return 0.0;
    const double cosine = glm::dot(normal, camera.to_viewer(position));
    const double facing = two_sided ? std::abs(cosine) : std::max(0.0, cosine);
    if (facing <= 0) return 0.0;
    // What is not seen at its place gets no stroke: any region of the part will do.
    const RasterCell& cell = raster.nearest(paper);
    const std::int32_t region = cell.part == part ? cell.region : 0;
    const bool cells =
        picture.laws != nullptr && picture.laws->shape_picture() && cell.part == part;
    const double darkness =
        cells ? cell.darkness : picture.darkness(part, region, position, normal, cosine);
    return share(position, darkness, facing, cells ? cell.denser : 1.0);
  };
}

/// A surface point as the grid of samples keeps it, and its triangle.
struct PointOnPaper {
  GridSample sample;
  std::uint32_t face = 0;
};
PointOnPaper on_paper(const Picture& picture, std::int32_t part, const SurfacePoint& point);

/// The covering radius of the points of a grid over what wants ink, looked for within `near` first,
/// then within `reach`, which is the answer where there is none.
double measure_delta(const Picture& picture, const ViewRaster& raster, const SampleGrid& grid,
                     double near, double reach, const RunContext& context);

/// The point of the surface at each cell that wants ink: no seeds, the phase of lines is found at
/// all of them at once.
Coverage cover_cells(const Picture& picture, const ViewRaster& raster, const RunContext& context);

}  // namespace burin::detail
