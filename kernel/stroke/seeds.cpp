#include "seeds.h"

#include <burin/base/parallel.h>

#include "sample_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::detail {
namespace {

// Candidates for each seed that fits: enough that few gaps are left to the strokes' own neighbours.
constexpr double kCandidates = 4;

bool wants_ink(const Picture& picture, const RasterCell& cell) {
  return cell.part >= 0 && picture.share(cell.darkness, 1) >= picture.options.tone_min;
}

// Paper mm^2 that each part shows and that want ink.
std::vector<double> dark_area(const Picture& picture, const ViewRaster& raster) {
  std::vector<double> area(picture.surfaces.size(), 0);
  for (const RasterCell& c : raster.cells) {
    if (wants_ink(picture, c))
      area[static_cast<std::size_t>(c.part)] += raster.pitch * raster.pitch;
  }
  return area;
}

// Paper mm^2 that the triangles of a surface turned to the viewer would cover, seen or not: the
// measure that points of a view-uniform coverage are spread over.
double projected_area(const Surface& surface, const Camera& camera) {
  const TriMesh& mesh = surface.proxy().mesh;
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec2 a = camera.to_paper(mesh.positions[t[0]]), b = camera.to_paper(mesh.positions[t[1]]);
    const Vec2 c = camera.to_paper(mesh.positions[t[2]]);
    sum += std::max(0.0, 0.5 * cross2(b - a, c - a));
  }
  return sum;
}

double measure_delta(const Picture& picture, const ViewRaster& raster, const SampleGrid& grid,
                     double near, double reach, const RunContext& context) {
  std::vector<double> row(static_cast<std::size_t>(raster.ny), 0);
  parallel_for(
      row.size(), 8,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          for (std::int32_t x = 0; x < raster.nx; ++x) {
            const RasterCell& cell = raster.at(x, static_cast<std::int32_t>(y));
            if (!wants_ink(picture, cell)) continue;
            GridSample s;
            s.paper = raster.center(x, static_cast<std::int32_t>(y));
            s.depth = cell.depth;
            s.part = cell.part;
            s.region = cell.region;
            // Nearly every cell has a seed close by: the far ones are looked for where it has not.
            double distance = grid.nearest(s, near).distance;
            if (distance >= near) distance = grid.nearest(s, reach).distance;
            row[y] = std::max(row[y], distance);
          }
        }
      },
      &context);
  return row.empty() ? 0 : *std::max_element(row.begin(), row.end());
}

// Seeds at which the field speaks clearly come first: their strokes set the direction of their
// neighbourhood. In classes of a quarter, so that the order inside a class stays random.
void surest_first(const Picture& picture, std::vector<Seed>& seeds) {
  std::vector<int> rank(seeds.size());
  std::vector<std::size_t> order(seeds.size());
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const SurfacePoint& point = seeds[i].point;
    const Frame frame = picture.surface(seeds[i].part).frame(point);
    const double certainty = picture.field.certainty
                                 ? picture.field.certainty({seeds[i].part, point, frame})
                                 : frame.confidence;
    rank[i] = static_cast<int>(-4 * certainty);
    order[i] = i;
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rank[i]; });
  std::vector<Seed> sorted;
  sorted.reserve(seeds.size());
  for (const std::size_t i : order) sorted.push_back(seeds[i]);
  seeds = std::move(sorted);
}

}  // namespace

Coverage cover_picture(const Picture& picture, const ViewRaster& raster,
                       const RunContext& context) {
  const Camera& camera = picture.camera;
  const HatchOptions& o = picture.options;
  const std::vector<double> dark = dark_area(picture, raster);
  SampleGrid grid(raster.origin, raster.pitch * Vec2(raster.nx, raster.ny), o.spacing_max);
  Coverage out;
  for (std::size_t part = 0; part < picture.surfaces.size(); ++part) {
    if (dark[part] <= 0) continue;
    const Surface& surface = *picture.surfaces[part];
    const double shown = std::max(projected_area(surface, camera), dark[part]);
    CoverRequest request;
    request.seed = o.seed;
    request.part = static_cast<std::int32_t>(part);
    request.count =
        static_cast<std::size_t>(kCandidates * shown / (o.spacing_max * o.spacing_max)) + 64;
    const bool two_sided = [&] {
      const auto& closed = surface.proxy().topology.component_closed;
      return std::find(closed.begin(), closed.end(), 0) != closed.end();
    }();
    request.weight = [&](Vec3 position, Vec3 normal) {
      const double cosine = glm::dot(normal, camera.to_viewer(position));
      const double facing = two_sided ? std::abs(cosine) : std::max(0.0, cosine);
      if (facing <= 0) return 0.0;
      if (picture.share(picture.darkness(position, cosine < 0 ? -normal : normal), 1) < o.tone_min)
        return 0.0;
      return facing;
    };
    for (const SurfacePoint& p : surface.cover(request, context)) {
      const ProxyPoint place = surface.to_proxy(p);
      GridSample s;
      s.paper = camera.to_paper(p.position);
      s.depth = camera.depth(p.position);
      s.part = static_cast<std::int32_t>(part);
      s.region = surface.proxy().face_region[place.face];
      const Vec3 n = surface.proxy().normal(place.face, place.bary);
      const double cosine = glm::dot(n, camera.to_viewer(p.position));
      s.slope = Picture::slope(std::abs(cosine), camera.scale_at(p.position));
      if (grid.nearest(s, o.spacing_max).distance < o.spacing_max) continue;
      if (!picture.seen(s.part, place.face, s.paper, s.depth)) continue;
      grid.insert(s);
      out.seeds.push_back({s.part, p});
    }
  }
  surest_first(picture, out.seeds);
  out.delta = measure_delta(picture, raster, grid, o.spacing_max, 4 * o.spacing_max, context);
  return out;
}

}  // namespace burin::detail
