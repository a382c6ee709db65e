#include <burin/base/error.h>
#include <burin/field/catalogue.h>
#include <burin/illustrate/style.h>
#include <burin/plugin/plugins.h>

#include <burin_test/facets.h>
#include <burin_test/irregular.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace burin {
namespace {

std::string built(const std::string& name) { return std::string(BURIN_PLUGINS) + "/" + name; }

Camera camera() {
  return Camera::fit([](const Mat3& axes) { return Box3{axes * Vec3(-1), axes * Vec3(1)}; }, {});
}

TEST(PluginReport, IsReadWhateverStandsInIt) {
  EXPECT_EQ(plugin::read_report("burin-probe 1\nok\n"), "");
  EXPECT_EQ(plugin::read_report("burin-probe 1\nfault it is bad\nmore\n"), "it is bad");
  for (const char* report :
       {"", "ok", "burin-probe 2\nok", "burin-probe 1\n", "burin-probe 1\nok \n",
        "burin-probe 1\nfault \n", "burin-probe 1\nokay\n"}) {
    EXPECT_FALSE(plugin::read_report(report).empty()) << report;
  }
  const std::string long_one =
      plugin::read_report("burin-probe 1\nfault " + std::string(9000, 'x'));
  EXPECT_LE(long_one.size(), 1000U);
}

TEST(Plugin, DirectionIsARowWithItsOptions) {
  ASSERT_EQ(plugin::probe(built("samples/spiral.so")), "");
  const plugin::Plugin loaded = plugin::load(built("samples/spiral.so"));
  EXPECT_EQ(loaded.refused, "");
  ASSERT_EQ(loaded.offers.size(), 1U);
  EXPECT_EQ(loaded.offers[0].refused, "");
  const field::FieldKind& kind = field::find("spiral");
  ASSERT_EQ(kind.options.size(), 1U);
  EXPECT_EQ(kind.options[0].option.name, "climb");
  // Old rows stay, and are found as before.
  EXPECT_EQ(field::catalogue().front().name, "smoothed");

  Style style = builtin_style("engraving");
  set_style_key(style, "hatch.field", "spiral");
  set_style_key(style, "hatch.spiral.climb", "0");
  EXPECT_NE(style, builtin_style("engraving"));
  EXPECT_EQ(parse_style(style_to_json(style), "again").hatch, style.hatch);
  EXPECT_THROW(set_style_key(style, "hatch.spiral.climb", "90"), UsageError);
  set_style_key(style, "hatch.spiral.climb", "15");
  EXPECT_TRUE(style.hatch.field.declared.changed.empty());
}

TEST(Plugin, SpiralClimbsByItsAngle) {
  plugin::load(built("samples/spiral.so"));
  const auto surface = test::realised(test::icosphere(1, 24));
  const std::vector<const Surface*> surfaces{surface.get()};
  const Camera eye = camera();
  const RunContext context;
  field::FieldOptions options{.name = "spiral"};
  set_value(options.declared, "spiral", field::find("spiral").options[0], 30.0);
  const Field spiral = field::find("spiral").make({.surfaces = surfaces,
                                                   .camera = eye,
                                                   .options = options,
                                                   .context = context,
                                                   .shown = {surfaces, {}}});
  int looked = 0;
  for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); t += 7) {
    const SurfacePoint p = surface->lift({t, Vec3(1.0 / 3)});
    const Frame frame = surface->frame(p);
    const auto cross = spiral.cross({0, p, frame});
    ASSERT_TRUE(cross);
    // The tangent part of what goes round and climbs by tan 30 degrees of the axis.
    const Vec3 round = glm::normalize(glm::cross(Vec3(0, 0, 1), p.position));
    const Vec3 expected =
        glm::normalize(reject(round + std::tan(M_PI / 6) * Vec3(0, 0, 1), frame.normal));
    EXPECT_NEAR(std::abs(glm::dot(cross->first, expected)), 1, 1e-6);
    EXPECT_NEAR(glm::dot(cross->first, frame.normal), 0, 1e-12);
    EXPECT_NEAR(glm::dot(cross->first, cross->second), 0, 1e-12);
    ++looked;
  }
  EXPECT_GT(looked, 100);
}

TEST(Plugin, NamesOfOursAndOfOthersAreNotTaken) {
  const plugin::Plugin taken = plugin::load(built("bad/taken.so"));
  ASSERT_EQ(taken.offers.size(), 2U);
  EXPECT_NE(taken.offers[0].refused.find("Burin's own"), std::string::npos);
  EXPECT_NE(taken.offers[1].refused.find("does not know the interface"), std::string::npos);
  EXPECT_EQ(field::find("smoothed").meaning, "the principal directions, made smooth");
  plugin::load(built("bad/nan_later.so"));
  EXPECT_EQ(plugin::load(built("bad/nan_later.so")).offers[0].refused, "");
}

}  // namespace
}  // namespace burin
