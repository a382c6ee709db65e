// The PMI of NIST's test cases. Most texts were read by eye from drawings of the annotations;
// counts are the validation properties that the files carry.
#include "cad_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>

namespace burin {
namespace {

namespace fs = std::filesystem;

class NistPmi : public test::CadTest {
 protected:
  static fs::path file(const std::string& name) {
    return fs::path(BURIN_TEST_DATA) / "step" / "nist" / ("nist_" + name + ".stp");
  }
  /// What all parts have (some files hold surfaces beside the part, which are parts here); none
  /// where the folder of real models is not there.
  static PlacedPmi pmi_of(const std::string& name) {
    if (!fs::exists(file(name))) return {};
    RunContext context;
    const Scene scene = read_cad(file(name), context, {.encoding = {}, .pmi = true});
    auto all = std::make_shared<Pmi>();
    for (const Part& part : scene.parts) {
      if (!part.pmi) continue;
      const std::vector<PmiItem>& items = part.pmi.pmi->items;
      all->items.insert(all->items.end(), items.begin(), items.end());
      all->views = part.pmi.pmi->views;
    }
    return {all};
  }
};

/// The faces of the item that has a name and a text.
std::multimap<std::string, const PmiItem*> by_text(const Pmi& pmi) {
  std::multimap<std::string, const PmiItem*> items;
  for (const PmiItem& item : pmi.items) items.emplace(item.text, &item);
  return items;
}

TEST_F(NistPmi, HasWhatTheValidationPropertiesCount) {
  using Kinds = std::array<std::int64_t, 4>;  // dimensions, tolerances, datum features, targets
  for (const auto& [name, kinds, annotations, views] :
       {std::tuple("ctc_01_asme1_ap242-e1", Kinds{12, 6, 3, 0}, 23, 1),
        std::tuple("ctc_02_asme1_ap242-e2", Kinds{7, 22, 6, 9}, 46, 3),
        std::tuple("ctc_03_asme1_ap242-e2", Kinds{10, 13, 6, 0}, 29, 1),
        std::tuple("ctc_04_asme1_ap242-e1", Kinds{10, 7, 8, 0}, 27, 1),
        std::tuple("ftc_06_asme1_ap242-e2", Kinds{24, 28, 6, 6}, 67, 3)}) {
    SCOPED_TRACE(name);
    const PlacedPmi placed = pmi_of(name);
    if (!placed) GTEST_SKIP() << "no real models";
    const auto count = [&](PmiKind kind) {
      return std::ranges::count(placed.pmi->items, kind, &PmiItem::kind);
    };
    EXPECT_EQ((Kinds{count(PmiKind::Dimension), count(PmiKind::Tolerance), count(PmiKind::Datum),
                     count(PmiKind::DatumTarget)}),
              kinds);
    EXPECT_EQ(std::ranges::count_if(placed.pmi->items, &PmiItem::shown), annotations);
    EXPECT_EQ(placed.pmi->views.size(), static_cast<std::size_t>(views));
    for (const PmiItem& item : placed.pmi->items) {
      EXPECT_TRUE(item.shown() || item.shown_with >= 0) << item.text;
      EXPECT_NE(item.kind, PmiKind::Other) << item.text;
      EXPECT_TRUE(item.plane || !item.shown()) << item.text;
    }
  }
}

TEST_F(NistPmi, SaysWhatTheDrawingsShow) {
  for (const auto& [name, texts] : {
           std::pair<const char*, std::vector<const char*>>{
               "ctc_01_asme1_ap242-e1",
               {"⌀ 35 +0/-0.2", "⌀ 35 +0.2/-0", "⌀ 20 +0.05/-0.1", "⌀ 20 +0.1/-0.05",
                "⌀ 35 (34.8 to 35.2)", "⌀ 25 ±0.15", "angle 60° ±0.5°", "flatness 0.2",
                "perpendicularity 1.5 | A", "surface profile 0.5 | A",
                "surface profile 1.25 | A | B | C", "position 0.75 | A | B | C"}},
           {"ctc_02_asme1_ap242-e2",
            {"⌀ 100 ±0.15", "position ⌀ 1.5 (M) | A | B | C", "surface profile 0.5 | D | E (M) | F",
             "perpendicularity ⌀ 0.1 (L) | G", "surface profile 2.5 (U) 0.5 | A | B | C",
             "K1 (circle)"}},
           {"ctc_03_asme1_ap242-e2",
            {"⌀ 0.438 ±0.005 in", "position ⌀ 0.05 in (M) | A | B (M) | C (M)",
             "flatness 0.005 in / 0.250 in", "linear distance 0.750 in (auxiliary)",
             "angularity 0.04 in | A"}},
           {"ctc_04_asme1_ap242-e1",
            {"⌀ 6.65 ±0.12", "angle 90° ±1°", "position ⌀ 1.5 | D | E | F",
             "position ⌀ 0.3 | D | E"}},
           {"ftc_06_asme1_ap242-e2",
            {"linear distance 12.00 ±0.01 in", "S⌀ 1.250 ±0.008 in", "SR 0.500 in (auxiliary)",
             "position ⌀ 0.025 in (M) | C | A | B", "G1 (circular curve)", "4X INDIVIDUALLY"}},
           {"ftc_11_asme1_ap242-e2",
            {"⌀ 63.0 ±0.5 (average), AVG (O.D.)", "curve length 197.9 (auxiliary)",
             "circular runout 1.2 (F) | A | B", "roundness 1.2 (F)", "linear distance 1.93 ±0.08",
             "R 0.1 (maximum), 2X MAX"}},
       }) {
    SCOPED_TRACE(name);
    const PlacedPmi placed = pmi_of(name);
    if (!placed) GTEST_SKIP() << "no real models";
    const auto items = by_text(*placed.pmi);
    for (const char* text : texts) EXPECT_TRUE(items.contains(text)) << text;
  }
}

TEST_F(NistPmi, IsAboutTheFacesThatItNames) {
  const std::string name = "ctc_01_asme1_ap242-e1";
  const PlacedPmi placed = pmi_of(name);
  if (!placed) GTEST_SKIP() << "no real models";
  // A bore of 25 mm is two halves of a cylinder; the datum plane is one face.
  const auto items = by_text(*placed.pmi);
  EXPECT_EQ(items.find("⌀ 25 ±0.15")->second->faces, (std::vector<std::int32_t>{91, 92}));
  EXPECT_EQ(items.find("A")->second->faces, items.find("flatness 0.2")->second->faces);
  EXPECT_EQ(items.find("surface profile 0.5 | A")->second->faces.size(), 6u);
}

TEST_F(NistPmi, IsNotReadUnlessItIsAskedFor) {
  const fs::path path = file("ctc_01_asme1_ap242-e1");
  if (!fs::exists(path)) GTEST_SKIP() << "no real models";
  EXPECT_FALSE(read(path.string()).parts.front().pmi);
  RunContext context;
  EXPECT_TRUE(inspect_cad(path, context, {.encoding = {}, .pmi = true}).parts.front().pmi);
}

}  // namespace
}  // namespace burin
