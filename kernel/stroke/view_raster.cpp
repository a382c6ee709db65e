#include "view_raster.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Cells that the grid may have: on sheets over 0.3 square metres they are wider. A cell takes some
// 500 bytes while both families are placed.
constexpr double kMostCells = 2e6;

Box2 projected_bounds(const Picture& picture) {
  Box2 box;
  for (const Surface* s : picture.surfaces) {
    for (const Vec3& p : s->proxy().mesh.positions) box.add(picture.camera.to_paper(p));
  }
  const Box2 sheet = picture.sheet();
  return {glm::clamp(box.min, sheet.min, sheet.max), glm::clamp(box.max, sheet.min, sheet.max)};
}

}  // namespace

ViewRaster make_raster(const Picture& picture, const RunContext& context) {
  ViewRaster raster;
  const Box2 box = projected_bounds(picture);
  raster.origin = box.min;
  raster.pitch = std::max(raster.pitch, std::sqrt(box.size().x * box.size().y / kMostCells));
  raster.nx = static_cast<std::int32_t>(box.size().x / raster.pitch) + 1;
  raster.ny = static_cast<std::int32_t>(box.size().y / raster.pitch) + 1;
  const auto nx = static_cast<std::size_t>(raster.nx);
  raster.cells.resize(nx * static_cast<std::size_t>(raster.ny));
  parallel_for(
      static_cast<std::size_t>(raster.ny), 4,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          for (std::size_t x = 0; x < nx; ++x) {
            const auto hit = picture.probe(
                raster.center(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)));
            if (!hit || !hit->hatched) continue;
            const ProxyMesh& proxy = picture.surface(hit->part).proxy();
            if (proxy.is_cut(hit->point.face)) continue;  // hatched as a cut
            const Vec3 p = proxy.position(hit->point.face, hit->point.bary);
            const Vec3 n = proxy.normal(hit->point.face, hit->point.bary);
            const double cosine = glm::dot(n, picture.camera.to_viewer(p));
            const std::int32_t region = proxy.face_region[hit->point.face];
            raster.cells[y * nx + x] = {hit->part,
                                        region,
                                        picture.camera.depth(p),
                                        0,
                                        static_cast<float>(std::abs(cosine)),
                                        1,
                                        hit->point.face,
                                        static_cast<float>(hit->point.bary.y),
                                        static_cast<float>(hit->point.bary.z)};
          }
        }
      },
      &context);
  return raster;
}

void shade_raster(const Picture& picture, ViewRaster& raster, const RunContext& context) {
  constexpr std::size_t kGrain = 4096;
  parallel_for(
      raster.cells.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          RasterCell& cell = raster.cells[i];
          if (cell.part < 0) continue;
          const ProxyMesh& proxy = picture.surface(cell.part).proxy();
          const ProxyPoint at = cell.place();
          const Vec3 p = proxy.position(at.face, at.bary), n = proxy.normal(at.face, at.bary);
          const double cosine = glm::dot(n, picture.camera.to_viewer(p));
          cell.darkness =
              static_cast<float>(picture.darkness(cell.part, cell.region, p, n, cosine));
        }
      },
      &context);
}

}  // namespace burin::detail
