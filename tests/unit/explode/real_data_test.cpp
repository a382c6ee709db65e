/// Assemblies of files: samples, and models from outside the project where they are there.

#include <burin/assembly/pieces.h>
#include <burin/converters/read.h>
#include <burin/explode/explode.h>
#include <burin/surface/placed_form.h>

#include <burin_test/exploded.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace burin {
namespace {

struct Case {
  const char* file;
  /// Sets of parts that stay together, and parts that do not move at all.
  std::size_t interlocked = 0;
};

class RealAssemblies : public testing::TestWithParam<Case> {};

TEST_P(RealAssemblies, ComeApart) {
  const std::filesystem::path sample =
      std::filesystem::path(BURIN_SOURCE_DIR) / "samples" / GetParam().file;
  const auto path = std::filesystem::exists(sample) ? sample : test::data(GetParam().file);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  RunContext context;
  Diagnostics reported;
  Scene scene = read_scene({path.string()}, {}, context);
  // The bodies of a product that is alone, as a drawing takes them apart.
  const std::vector<std::string> bodies{"*/*"};
  if (scene.parts.size() == 1) split_pieces(scene, bodies);
  const ExplodeModel model(scene, std::vector<bool>(scene.parts.size(), true), context);
  const Explosion explosion = model.find({}, reported, context);
  EXPECT_EQ(explosion.interlocked.size(), GetParam().interlocked)
      << (reported.empty() ? "" : reported.entries().front().message);
  std::size_t held = 0;
  for (const auto& set : explosion.interlocked) held += set.size() - 1;
  EXPECT_GT(explosion.steps.size() + held, 0U);
  test::expect_takes_apart(scene, explosion.steps);
  // All but the base and what it holds has moved.
  std::size_t still = 0;
  for (const Vec3& move : moves_of(explosion.steps, scene.parts.size(), 1)) {
    if (move == Vec3(0)) ++still;
  }
  EXPECT_LE(still, 1 + held);
  EXPECT_TRUE(held > 0 || !model.trails(explosion.steps, 1).empty());
}

// Steps are those of the assembly, however it stands.
TEST(SampleAssemblies, GiveTheSameStepsTurnedScaledAndMoved) {
  const Placement place{0.04 * test::tilted(), {30, -4, 1.7}};
  for (const char* file : {"coupling.step", "gear_pump.step"}) {
    RunContext context;
    Diagnostics reported;
    const auto path = std::filesystem::path(BURIN_SOURCE_DIR) / "samples" / file;
    Scene scene = read_scene({path.string()}, {}, context);
    const std::vector<bool> all(scene.parts.size(), true);
    const auto a = ExplodeModel(scene, all, context).find({}, reported, context).steps;
    for (Part& part : scene.parts) part.form = placed(part.form, place);
    const auto b = ExplodeModel(scene, all, context).find({}, reported, context).steps;
    ASSERT_EQ(a.size(), b.size()) << file;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].parts, b[i].parts) << file << " step " << i;
      // Rays over a fillet meet it at other places.
      EXPECT_NEAR(0.04 * a[i].by, b[i].by, 0.05 * b[i].by) << file << " step " << i;
      EXPECT_LT(glm::distance(place.linear * a[i].along / 0.04, b[i].along), 1e-3)
          << file << " step " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealAssemblies,
                         testing::Values(Case{"coupling.step"}, Case{"gear_pump.step"},
                                         Case{"step/pythonocc/as1-oc-214.stp"},
                                         Case{"step/gmsh/as1-tu-203.stp"},
                                         Case{"step/freecad/as1-ac-214.stp"},
                                         Case{"step/gmsh/wrenchnut.stp"},
                                         Case{"step/kicad/RJ45_Amphenol_RJHSE538X.step"},
                                         Case{"step/kicad/Transformer_CHK_EI48-10VA_2xSec.step", 1},
                                         Case{"step/prusa/fan-shroud.stp", 1}),
                         [](const auto& one) {
                           std::string name = std::filesystem::path(one.param.file).stem().string();
                           for (char& c : name) {
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace burin
