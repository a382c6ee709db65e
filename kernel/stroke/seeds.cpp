#include "seeds.h"

#include <burin/base/parallel.h>

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

Box2 box_of(const Camera& camera, Vec3 a, Vec3 b, Vec3 c) {
  Box2 box;
  for (const Vec3& corner : {a, b, c}) box.add(camera.to_paper(corner));
  return box;
}

// Whether a surface runs off a box of the sheet.
bool runs_off(const Surface& surface, const Camera& camera, const Box2& box) {
  const auto& positions = surface.proxy().mesh.positions;
  return std::ranges::any_of(
      positions, [&](Vec3 position) { return !box.contains(camera.to_paper(position)); });
}

GridSample cell_sample(const ViewRaster& raster, std::int32_t x, std::int32_t y) {
  const RasterCell& cell = raster.at(x, y);
  GridSample s;
  s.paper = raster.center(x, y);
  s.depth = cell.depth;
  s.part = cell.part;
  s.region = cell.region;
  return s;
}

// Seeds for what the coverage left white of parts that run off the sheet: the little of them that
// is on it may get no point of the coverage. Parts are flagged in `off`.
void fill_white(const Picture& picture, const ViewRaster& raster, const std::vector<bool>& off,
                SampleGrid& grid, std::vector<Seed>& seeds) {
  const double reach = 2 * picture.options.spacing_max;
  const auto stride = std::max(1, static_cast<std::int32_t>(reach / raster.pitch / 2));
  for (std::int32_t y = 0; y < raster.ny; y += stride) {
    for (std::int32_t x = 0; x < raster.nx; x += stride) {
      const RasterCell& cell = raster.at(x, y);
      if (!wants_ink(picture, cell) || !off[static_cast<std::size_t>(cell.part)]) continue;
      const GridSample s = cell_sample(raster, x, y);
      if (grid.nearest(s, reach).distance < reach) continue;
      const auto hit = picture.probe(s.paper);
      if (!hit || hit->part != cell.part) continue;
      grid.insert(s);
      seeds.push_back({s.part, picture.surface(s.part).lift(hit->point)});
    }
  }
}

// Seeds at which the field speaks clearly come first: their strokes set the direction of their
// neighbourhood. In classes of a quarter, so that the order inside a class stays random.
void surest_first(const Picture& picture, std::vector<Seed>& seeds) {
  std::vector<int> rank(seeds.size());
  std::vector<std::size_t> order(seeds.size());
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const SurfacePoint& point = seeds[i].point;
    const Frame frame = picture.surface(seeds[i].part).frame(point);
    const auto cross = picture.field.cross({seeds[i].part, point, frame});
    rank[i] = cross ? static_cast<int>(-4 * cross->certainty) : 0;
    order[i] = i;
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rank[i]; });
  std::vector<Seed> sorted;
  sorted.reserve(seeds.size());
  for (const std::size_t i : order) sorted.push_back(seeds[i]);
  seeds = std::move(sorted);
}

}  // namespace

Box2 box_of(const ViewRaster& raster) {
  return {raster.origin, raster.origin + raster.pitch * Vec2(raster.nx, raster.ny)};
}

double projected_area(const Surface& surface, const Camera& camera, const Box2& box) {
  const TriMesh& mesh = surface.proxy().mesh;
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec2 a = camera.to_paper(mesh.positions[t[0]]), b = camera.to_paper(mesh.positions[t[1]]);
    const Vec2 c = camera.to_paper(mesh.positions[t[2]]);
    const Vec2 shared = glm::min(glm::max(glm::max(a, b), c), box.max) -
                        glm::max(glm::min(glm::min(a, b), c), box.min);
    if (shared.x < 0 || shared.y < 0) continue;
    sum += std::min(std::max(0.0, 0.5 * cross2(b - a, c - a)), shared.x * shared.y);
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
            const GridSample s = cell_sample(raster, x, static_cast<std::int32_t>(y));
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

bool is_two_sided(const Surface& surface) {
  const auto& closed = surface.proxy().topology.component_closed;
  return std::find(closed.begin(), closed.end(), 0) != closed.end();
}

CoverRequest request_of(const Picture& picture, std::int32_t part, const Box2& box) {
  const Camera& camera = picture.camera;
  CoverRequest request;
  request.seed = picture.seed;
  request.part = part;
  if (runs_off(picture.surface(part), camera, box)) {
    request.among = [&camera, box](Vec3 a, Vec3 b, Vec3 c) {
      return box_of(camera, a, b, c).overlaps(box);
    };
  }
  return request;
}

PointOnPaper on_paper(const Picture& picture, std::int32_t part, const SurfacePoint& point) {
  const Camera& camera = picture.camera;
  const ProxyMesh& proxy = picture.surface(part).proxy();
  const ProxyPoint place = picture.surface(part).to_proxy(point);
  GridSample s;
  s.paper = camera.to_paper(point.position);
  s.depth = camera.depth(point.position);
  s.part = part;
  s.region = proxy.face_region[place.face];
  const double cosine =
      glm::dot(proxy.normal(place.face, place.bary), camera.to_viewer(point.position));
  s.slope = Picture::slope(std::abs(cosine), camera.scale_at(point.position));
  return {s, place.face};
}

Coverage cover_picture(const Picture& picture, const ViewRaster& raster,
                       const RunContext& context) {
  const Camera& camera = picture.camera;
  const HatchOptions& o = picture.options;
  const std::vector<double> dark = dark_area(picture, raster);
  SampleGrid grid(raster.origin, raster.pitch * Vec2(raster.nx, raster.ny), o.spacing_max);
  Coverage out;
  const Box2 box = box_of(raster);
  const double most = kMostSheets * box.size().x * box.size().y;
  std::vector<bool> off(picture.surfaces.size(), false);
  for (std::size_t part = 0; part < picture.surfaces.size(); ++part) {
    if (dark[part] <= 0) continue;
    const Surface& surface = *picture.surfaces[part];
    const double shown = std::max(projected_area(surface, camera, box), dark[part]);
    if (shown > most) ++out.thinned_parts;
    // The deeper sheets lie over each other, the fewer places of them are seen, and the longer a
    // ray takes to find out.
    const double tried = shown > most ? most * std::max(most / shown, 1.0 / 16) : shown;
    CoverRequest request = request_of(picture, static_cast<std::int32_t>(part), box);
    request.count =
        static_cast<std::size_t>(kCandidates * tried / (o.spacing_max * o.spacing_max)) + 64;
    request.weight = weight_in_picture(
        picture, surface, box, [&](Vec3 /*position*/, double darkness, double facing) {
          return picture.share(darkness, 1) < o.tone_min ? 0.0 : facing;
        });
    off[part] = static_cast<bool>(request.among);
    for (const SurfacePoint& p : surface.cover(request, context)) {
      const auto [s, face] = on_paper(picture, request.part, p);
      if (grid.nearest(s, o.spacing_max).distance < o.spacing_max) continue;
      if (!picture.seen(s.part, face, s.paper, s.depth)) continue;
      grid.insert(s);
      out.seeds.push_back({s.part, p});
    }
  }
  fill_white(picture, raster, off, grid, out.seeds);
  surest_first(picture, out.seeds);
  out.delta = measure_delta(picture, raster, grid, o.spacing_max, 4 * o.spacing_max, context);
  return out;
}

}  // namespace burin::detail
