/// Cut areas of CAD parts beside those that OCCT finds on the exact faces. tests/bench/sections
/// does so over all files.

#include <burin/converters/cad_reader.h>

#include <burin_test/occt_section.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace burin {
namespace {

std::vector<CutPlane> planes_of(const Box3& box) {
  const Vec3 c = box.center(), n = glm::normalize(Vec3(1, 2, 3));
  return {{{0, 0, 1}, c.z},
          {{1, 0, 0}, box.min.x + 0.37 * (box.max.x - box.min.x)},
          {n, glm::dot(n, c)}};
}

/// How many cuts of the solids of a file were compared.
int compare(const std::filesystem::path& file, std::size_t most) {
  RunContext context;
  const Scene scene = read_cad(file, context);
  std::set<const BrepModel*> done;
  int compared = 0, exact = 0;
  for (const Part& part : scene.parts) {
    const auto& brep = dynamic_cast<const BrepForm&>(*part.form);
    if (done.size() == most || !done.insert(&brep.model()).second) continue;
    const Box3 box = brep.model().bounds(Mat3(1));
    const double deflection = 2e-4 * box.diagonal();
    const auto form = std::make_shared<BrepForm>(
        std::shared_ptr<const BrepModel>(part.form, &brep.model()), Placement{});
    for (const CutPlane& plane : planes_of(box)) {
      const auto whole = form->realise({.tolerance = deflection}, context);
      if (test::face_in_plane(whole->proxy(), plane, 1e-6 * box.diagonal())) continue;
      Diagnostics said;
      const auto surface = cut_form(form, plane, 0, "")
                               ->realise({.tolerance = deflection, .diagnostics = &said}, context);
      for (const Diagnostic& d : said.entries()) EXPECT_NE(d.code, "section.open") << file;
      const test::CapMeasure cap = test::measure_cap(*surface);
      const test::OcctCap occt =
          test::occt_cap(brep.model().shape(), plane, 4 * box.diagonal() + 10);
      EXPECT_TRUE(occt.done);
      EXPECT_GT(cap.area, 0);
      EXPECT_NEAR(cap.area, occt.area, deflection * cap.perimeter + 1e-9) << file << part.name;
      EXPECT_EQ(cap.loops, occt.loops) << file << part.name;
      EXPECT_LT(cap.off_surface, deflection) << file << part.name;
      exact += cap.off_surface < 1e-3 * deflection ? 1 : 0;
      ++compared;
    }
  }
  // Not where the plane runs nearly along an edge.
  EXPECT_GE(exact, 0.3 * compared) << file;
  return compared;
}

TEST(CadSections, AgreeWithThoseOfTheExactFaces) {
  const std::filesystem::path samples = std::filesystem::path(BURIN_SOURCE_DIR) / "samples";
  EXPECT_EQ(compare(samples / "coupling.step", 8), 24);
  EXPECT_GE(compare(samples / "gear_pump.step", 3), 7);
}

TEST(CadSections, OfRealPartsAgreeToo) {
  for (const char* name :
       {"featuretype.STEP", "as1-ac-214.stp", "M6-1x12-countersunk-screw.step"}) {
    std::filesystem::path file;
    if (!std::filesystem::exists(test::data("step"))) GTEST_SKIP() << "no " << test::data("step");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::data("step"))) {
      if (entry.path().filename() == name) file = entry.path();
    }
    if (file.empty()) GTEST_SKIP() << "no " << name;
    EXPECT_GE(compare(file, 4), 2) << name;
  }
}

}  // namespace
}  // namespace burin
