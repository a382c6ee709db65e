// Changed bytes, cut ends and repeated pieces of good files: each is read or refused in one line.
#include <burin/base/rng.h>
#include <burin/surface/surface.h>

#include "reading.h"

#include <burin_test/mutated.h>

namespace burin {
namespace {

constexpr std::string_view kSpice[] = {"-1", "0",  "99999999999", "nan", "1e999", "\n",   "[",
                                       "]",  "\"", "\\",          "#",   " 3 ",   "[KV ", "BEZ"};

/// To finite triangles, or not with a reason.
void realise(const Part& part) {
  RunContext context;
  RealiseOptions options;
  options.tolerance = 0.01 * part.form->bounds(Mat3(1)).diagonal();
  try {
    const auto surface = part.form->realise(options, context);
    for (const Vec3& p : surface->proxy().mesh.positions) {
      EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
  } catch (const GeometryError& e) {
    EXPECT_STRNE(e.what(), "");
  }
}

/// What was read evaluates to finite points.
void look_at(const Scene& scene) {
  ASSERT_FALSE(scene.parts.empty());
  for (const Part& part : scene.parts) {
    EXPECT_FALSE(part.name.empty());
    const auto* form = dynamic_cast<const ParametricForm*>(part.form.get());
    if (form == nullptr) {
      realise(part);
      continue;
    }
    for (const auto& patch : form->patches()) {
      const SurfaceDerivatives d = patch->derivatives(patch->domain().center());
      EXPECT_TRUE(std::isfinite(d.p.x + d.p.y + d.p.z));
    }
  }
}

void fuzz(const std::string& good, const std::string& name, int rounds, std::uint64_t seed) {
  ASSERT_NO_THROW(look_at(test::scene_of(good, name)));
  const Rng rng(seed);
  std::uint64_t n = 0;
  int read = 0, refused = 0;
  for (int i = 0; i < rounds; ++i) {
    const std::string bytes = test::mutated(good, kSpice, rng, n);
    try {
      look_at(test::scene_of(bytes, name));
      ++read;
    } catch (const InputError& e) {
      const std::string what = e.what();
      EXPECT_FALSE(what.empty());
      for (const char c : what) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << what;
      ++refused;
    }
  }
  EXPECT_EQ(read + refused, rounds);
  EXPECT_GT(refused, rounds / 10);
  EXPECT_GT(read, 0);
}

const std::string kData =
    "a comment\n[OBJECT [COLOR 4] [RGB \"1,2,3\"] BOTH\n"
    "[OBJECT A [SURFACE BSPLINE 4 3 3 2 P3 [KV 0 0 0 1 2 2 2] [KV 0 0 1 2 2]\n"
    "[1 0 0 0] [0.7 1 1 0] [1 2 0 0] [1 3 0 0]\n[1 0 0 1] [0.7 1 1 1] [1 2 0 1] [1 3 0 1]\n"
    "[1 0 0 2] [0.7 1 1 2] [1 2 0 2] [1 3 0 2]]]\n"
    "[OBJECT B [SURFACE BSPLINE 3 2 3 2 E3 [KVP 0 1 2 3 4 5 6 7] [KV 0 0 1 1]\n"
    "[1 0 0] [0 1 0] [-1 -1 0] [1 0 1] [0 1 1] [-1 -1 1]]]\n"
    "[OBJECT C [POLYGON [PLANE 0 0 1 0] 3 [0 0 0] [1 0 0] [0 1 0]] [POLYGON 3 [1 0 0] [1 1 0] [0 1 "
    "0]]]\n"
    "[OBJECT D [CURVE BEZIER 2 E2 [0 0] [1 1]]] [OBJECT E [TRISRF [x [y] z] q]]\n"
    "[OBJECT F [NUMBER 3]] [OBJECT G [MATRIX 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]]\n"
    "[OBJECT H [SURFACE BEZIER 2 2 E3 [0 0 9] [1 0 9] [0 1 9] [1 1 9]]]\n"
    "[OBJECT I [INSTANCE A 1 0 0 0 0 1 0 0 0 0 1 0.1 0 3 0 1]] [OBJECT J [INSTANCE I 2 0 0 0 0 1 0 "
    "0 0 0 1 0 0 0 0 1]]]\n";

TEST(IritFuzz, Data) { fuzz(kData, "a.itd", 5000, 1); }

TEST(IritFuzz, TrimmedSurfaces) {
  fuzz(
      "[OBJECT A [TRIMSRF [SURFACE BSPLINE 3 2 3 2 E3 [KV 0 0 0 1 1 1] [KV 0 0 1 1]\n"
      "[0 0 0] [1 0 0] [2 1 0] [0 0 1] [1 0 1] [2 1 1]]\n"
      "[TRIMCRV [TRIMCRVSEG [CURVE BSPLINE 5 2 E2 [KV 0 0 1 2 3 4 4] [0 0] [1 0] [1 1] [0 1] [0 "
      "0]]]]\n"
      "[TRIMCRV [TRIMCRVSEG [CURVE BSPLINE 4 3 P2 [KVP 0 1 2 3 4 5 6 7 8] [1 .2 .2] [1 .8 .2] [1 "
      ".8 "
      ".8] [1 .2 .8]]]]\n"
      "[TRIMCRV [TRIMCRVSEG [CURVE BEZIER 2 E2 [.4 .4] [.6 .4]]] [TRIMCRVSEG [CURVE BEZIER 3 E2 "
      "[.6 "
      ".4] [.7 .7] [.4 .4]] [CURVE BEZIER 2 E3 [0 0 0] [1 1 1]]]]]]\n"
      "[OBJECT B [INSTANCE A 1 0 0 0 0 1 0 0 0 0 1 0 0 3 0 1]]\n",
      "a.itd", 600, 5);
}

TEST(IritFuzz, Models) {
  fuzz(
      "[OBJECT A [MODEL 2 3\n[MDLTSRF 1 [SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]\n"
      "[MDLLOOP 1 2 3]]\n[MDLTSRF 1 [SURFACE BEZIER 2 2 E3 [1 0 0] [2 0 1] [1 1 0] [2 1 1]]\n"
      "[MDLLOOP -1 -3 -2]]\n[MDLTSEG 3 1 2 [CURVE BEZIER 2 E2 [0 0] [1 0]] [CURVE BEZIER 2 E2 [0 "
      "0] "
      "[1 0]]]\n[MDLTSEG 3 1 2 [CURVE BEZIER 3 E2 [1 0] [1 1] [.5 1]] [CURVE BEZIER 2 E2 [1 0] [1 "
      "1]]]\n[MDLTSEG 7 1 2 [CURVE BEZIER 2 P2 [1 .5 1] [1 0 0]] [CURVE BEZIER 2 E2 [1 1] [0 0]] "
      "[CURVE BEZIER 2 E3 [0 0 0] [1 1 1]]]\n]]\n",
      "a.itd", 600, 6);
}

TEST(IritFuzz, Geomview) {
  fuzz("#x\nBEZ214\n1 0 0 1  0 1 0 0  -1 0 0 1\n1 0 2 1  0 1 0 0  -1 0 2 1\n", "a.bez", 2000, 2);
}

TEST(IritFuzz, PatchList) {
  std::string text = "16 2\n";
  for (int i = 1; i <= 16; ++i) text += fmt::format("{} {} {} 0.5\n", i, i % 4, i / 4);
  for (int i = 0; i < 32; ++i) text += fmt::format("{} ", 1 + i % 16);
  fuzz(text, "a.bez", 1000, 3);
  text = "2\n";
  for (int i = 0; i < 32; ++i) text += fmt::format("{}{}", 1 + i % 16, i % 16 < 15 ? "," : "\n");
  text += "16\n";
  for (int i = 1; i <= 16; ++i) text += fmt::format("{},{},0.5\n", i % 4, i / 4);
  fuzz(text, "a.bez", 1000, 4);
}

}  // namespace
}  // namespace burin
