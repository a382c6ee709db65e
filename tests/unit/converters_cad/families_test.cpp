#include <burin/field/smoothed_field.h>
#include <burin/mesh/whole_faces.h>

#include "cad_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace burin {
namespace {

// Areas of a cylinder or cone on which family 1 runs round it, and along it.
using Areas = std::array<double, 2>;

// One entry a cylinder or cone: half cylinders are one.
std::map<std::int32_t, Areas> families(const Surface& surface) {
  RunContext context;
  const std::vector<const Surface*> surfaces{&surface};
  const field::SmoothedField field(surfaces, {}, context);
  const ProxyMesh& proxy = surface.proxy();
  const std::vector<std::int32_t> whole = whole_faces(proxy);
  std::map<std::int32_t, Areas> out;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const SurfacePoint point = surface.lift({f, Vec3(1.0 / 3)});
    const Frame frame = surface.frame(point);
    if (frame.kind != FaceKind::Cylinder && frame.kind != FaceKind::Cone) continue;
    const auto cross = field.cross({0, point, frame});
    if (!cross) continue;
    const Vec3 round = std::abs(frame.k1) > std::abs(frame.k2) ? frame.d1 : frame.d2;
    const std::int32_t face = proxy.source_face[f];
    const bool along = std::abs(glm::dot(cross->first, round)) < std::sqrt(0.5);
    out[whole.empty() ? face : whole[static_cast<std::size_t>(face)]][along ? 1 : 0] +=
        proxy.mesh.area(f);
  }
  return out;
}

class Families : public test::CadTest {};

TEST_F(Families, ChangeNamesBesideCylindersAndNotOnThem) {
  for (const char* name : {"pedestal.step", "coupling.step", "propeller.step"}) {
    SCOPED_TRACE(name);
    const Scene scene = read(std::string(BURIN_SOURCE_DIR) + "/samples/" + name);
    std::size_t faces = 0;
    for (const Part& part : scene.parts) {
      RunContext context;
      RealiseOptions options;
      options.tolerance = 0.02;
      const auto surface = part.form->realise(options, context);
      for (const auto& [face, area] : families(*surface)) {
        const auto [less, more] = std::minmax(area[0], area[1]);
        EXPECT_LE(less, 0.1 * (less + more)) << part.name << ", face " << face;
        ++faces;
      }
    }
    EXPECT_GT(faces, 1U);
  }
}

}  // namespace
}  // namespace burin
