#include <burin/converters/mesh_reader.h>
#include <burin/mesh/curvature.h>
#include <burin/repair/repair.h>

#include <burin_test/exact.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

class RealMesh : public testing::TestWithParam<const char*> {};

/// Normals must lie among those of the triangles around (a little beyond them at rims), and nothing
/// may be undefined.
TEST_P(RealMesh, HasSoundNormalsAndCurvature) {
  const std::filesystem::path path = test::data(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const RunContext context;
  Diagnostics diagnostics;
  MeshFile file = read_mesh_file(path, context);
  ASSERT_FALSE(file.objects.empty());
  const ProxyMesh proxy =
      build_proxy(repair(std::move(file.objects.front()), {}, diagnostics, context), {}, context);
  const std::vector<Curvature> curvature = estimate_curvature(proxy, {}, context);

  std::vector<Vec3> mean(curvature.size(), Vec3(0));
  std::vector<double> spread(curvature.size(), 0);
  const auto each_corner = [&](const auto& visit) {
    for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
      for (const std::uint32_t w : proxy.wedges[f]) visit(f, w);
    }
  };
  each_corner([&](std::uint32_t f, std::uint32_t w) {
    mean[w] += proxy.mesh.area(f) * proxy.mesh.normal(f);
  });
  each_corner([&](std::uint32_t f, std::uint32_t w) {
    spread[w] = std::max(spread[w], test::line_angle(proxy.mesh.normal(f), mean[w]));
  });
  std::size_t outside = 0;
  for (std::size_t w = 0; w < curvature.size(); ++w) {
    const Curvature& c = curvature[w];
    const Vec3 n = proxy.wedge_normal[w];
    ASSERT_NEAR(glm::length(n), 1, 1e-9);
    ASSERT_NEAR(glm::dot(glm::cross(c.d1, c.d2), n), 1, 1e-9);
    ASSERT_TRUE(std::isfinite(c.k1) && std::isfinite(c.k2) && c.k1 >= c.k2);
    ASSERT_TRUE(c.confidence >= 0 && c.confidence <= 1);
    outside += test::line_angle(n, mean[w]) > 1.5 * spread[w] + 5;
  }
  EXPECT_LE(outside, 0.002 * static_cast<double>(curvature.size()));
}

INSTANTIATE_TEST_SUITE_P(Models, RealMesh,
                         testing::Values("mesh/prusa/extruder-body.stl",
                                         "mesh/prusa/y-motor-holder.stl", "mesh/prusa/LCD-knob.stl",
                                         "mesh/cgal/couplingdown.off", "mesh/cgal/cow.off",
                                         "mesh/common3d/fandisk.obj",
                                         "mesh/common3d/stanford-bunny.obj"));

}  // namespace
}  // namespace burin
