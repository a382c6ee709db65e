#include "seeds.h"

#include <burin/base/parallel.h>

#include "wave_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::detail {
namespace {

bool wants_ink(const Picture& picture, const RasterCell& cell) {
  return cell.part >= 0 && picture.share(cell.darkness, 1) >= picture.options.tone_min;
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
            double distance = grid.nearest(s, near);
            if (distance >= near) distance = grid.nearest(s, reach);
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

Coverage cover_cells(const Picture& picture, const ViewRaster& raster, const RunContext& context) {
  constexpr std::int32_t kReach = 8;  // cells
  const double half = std::sqrt(0.5) * raster.pitch;
  std::vector<Coverage> row(static_cast<std::size_t>(raster.ny));
  // How far a cell without a point is from one of its sheet that has one.
  const auto far = [&](std::int32_t x, std::int32_t y) {
    const RasterCell& cell = raster.at(x, y);
    double least = kReach * raster.pitch;
    for (std::int32_t by = std::max(0, y - kReach); by < std::min(raster.ny, y + kReach + 1);
         ++by) {
      for (std::int32_t bx = std::max(0, x - kReach); bx < std::min(raster.nx, x + kReach + 1);
           ++bx) {
        const RasterCell& other = raster.at(bx, by);
        if (other.part != cell.part || other.region != cell.region || !has_node(other)) continue;
        least = std::min(least, glm::distance(raster.center(x, y), raster.center(bx, by)));
      }
    }
    return least;
  };
  parallel_for(
      row.size(), 8,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          for (std::int32_t x = 0; x < raster.nx; ++x) {
            const RasterCell& cell = raster.at(x, static_cast<std::int32_t>(y));
            if (!wants_ink(picture, cell)) continue;
            const bool point = has_node(cell);
            row[y].points += point;
            const double off = point ? half : half + far(x, static_cast<std::int32_t>(y));
            row[y].delta = std::max(row[y].delta, off);
          }
        }
      },
      &context);
  Coverage out;
  for (const Coverage& r : row) {
    out.points += r.points;
    out.delta = std::max(out.delta, r.delta);
  }
  return out;
}

}  // namespace burin::detail
