// The spline models of samples/.
#include "reading.h"

namespace burin {
namespace {

Scene sample(const std::string& name) {
  const RunContext context;
  return read_irit(std::filesystem::path(BURIN_SOURCE_DIR) / "samples" / name, context);
}

TEST(SplineSamples, HornIsOnePartOfThreePatches) {
  const Scene scene = sample("horn.itd");
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "HORN");
  EXPECT_EQ(scene.parts[0].color, "#c4a050");
  EXPECT_TRUE(scene.diagnostics.empty());
  const auto& patches = test::patches_of(scene.parts[0]);
  ASSERT_EQ(patches.size(), 3u);
  const Chart& wall = *patches[0];
  const ParameterBox box = wall.domain();
  for (double v = box.min.y; v < box.max.y; v += 0.3) {
    // Rim and tip go on where the wall ends, in its direction.
    for (const auto& [other, u] :
         {std::pair(patches[1], box.max.x), std::pair(patches[2], box.min.x)}) {
      const SurfaceDerivatives a = wall.derivatives({u, v});
      const SurfaceDerivatives b = other->derivatives({other->domain().min.x, v});
      test::expect_near(a.p, b.p, 1e-6);
      EXPECT_NEAR(std::abs(glm::dot(glm::normalize(glm::cross(a.u, a.v)),
                                    glm::normalize(glm::cross(b.u, b.v)))),
                  1, 1e-9);
    }
  }
}

TEST(SplineSamples, TeapotIsFourParts) {
  const Scene scene = sample("teapot.itd");
  ASSERT_EQ(scene.parts.size(), 4u);
  const char* const names[] = {"BODY", "LID", "SPOUT", "HANDLE"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.parts[i].name, names[i]);
    EXPECT_EQ(scene.parts[i].assembly, std::vector<std::string>{"TEAPOT"});
    EXPECT_EQ(test::patches_of(scene.parts[i]).size(), 1u);
  }
  // The body is turned: circles about z.
  const Chart& body = *test::patches_of(scene.parts[0])[0];
  const ParameterBox box = body.domain();
  for (double u = box.min.x; u < box.max.x; u += 0.7) {
    const Vec3 first = body.position({u, 0});
    for (double v = 0; v < 4; v += 0.23) {
      const Vec3 p = body.position({u, v});
      EXPECT_NEAR(std::hypot(p.x, p.y), first.x, 1e-6);
      EXPECT_NEAR(p.z, first.z, 1e-6);
    }
  }
}

}  // namespace
}  // namespace burin
