#include <burin/base/error.h>
#include <burin/forms/brep/realise_faces.h>
#include <burin/forms/charted/place_mesh.h>
#include <burin/surface/composite_surface.h>

#include "isolate.h"
#include "loose_faces.h"
#include "name_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace burin {
namespace {

using SurfacePtr = std::shared_ptr<const Surface>;

LooseTriangles placed(LooseTriangles loose, const Placement& placement) {
  for (Vec3& p : loose.positions) p = placement.point(p);
  if (placement.mirrors()) {
    for (Triangle& t : loose.triangles) std::swap(t[1], t[2]);
  }
  return loose;
}

/// A NaN would spread to whatever looks at the surface.
void check_numbers(const ChartMesh& mesh) {
  for (const Vec3& p : mesh.positions) {
    if (!std::isfinite(p.x + p.y + p.z)) {
      throw GeometryError("a point of the surface is no number");
    }
  }
}

}  // namespace

std::shared_ptr<const Surface> realise_faces(const PlacedAtlas& atlas, const ChartMesh& mesh,
                                             const LooseTriangles& loose,
                                             const RealiseOptions& options,
                                             const RunContext& context, const FaceStages& stages) {
  LooseTriangles parted;
  SurfacePtr joined;
  bool found = true;
  const Isolated isolated =
      isolate(atlas.atlas->face_count(), [&](const std::vector<std::uint8_t>& out) {
        joined.reset();
        ChartMesh m = placed(mesh, atlas.placement);
        parted = take_loose(m, out);
        if (m.triangles.empty()) return;
        stages.normals(m, atlas, context);
        found = !options.view || stages.cut(m, atlas, *options.view, context);
        check_numbers(m);
        joined = stages.join(atlas, std::move(m), context);
      });
  name_loose_faces(isolated.out, isolated.reason, *atlas.atlas, options.diagnostics);
  if (!found && options.diagnostics) add_contours_bounded(*options.diagnostics);
  parted.append(placed(loose, atlas.placement));
  for (std::int32_t& face : parted.face) face = atlas.atlas->source_face(face);
  std::vector<SurfacePtr> pieces;
  if (joined) pieces.push_back(std::move(joined));
  if (SurfacePtr apart = loose_surface(parted, options, context)) pieces.push_back(apart);
  if (pieces.empty()) {
    throw GeometryError(
        fmt::format("none of the faces can be drawn ({}); repair the shape",
                    isolated.reason.empty() ? "they have no triangles" : isolated.reason));
  }
  return make_composite_surface(std::move(pieces));
}

}  // namespace burin
