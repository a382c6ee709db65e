// Changed bytes, cut ends and repeated pieces of good files: each is read or refused, and what is
// read is manifold.
#include <burin/base/rng.h>
#include <burin/forms/mesh/mesh_form.h>

#include "reading.h"

#include <burin_test/mutated.h>

namespace burin {
namespace {

constexpr int kMutations = 400;

constexpr std::string_view kSpice[] = {"-1", "0", "99999999999",      "nan", "1e999",
                                       "\n", "",  "\xff\xff\xff\xff", "/",   "\\\n"};

void fuzz(const std::string& good, const std::string& name, std::uint64_t seed) {
  const Rng rng(seed);
  std::uint64_t n = 0;
  int read = 0, refused = 0;
  for (int i = 0; i < kMutations; ++i) {
    const std::string bytes = test::mutated(good, kSpice, rng, n);
    try {
      const Scene scene = test::read_scene(bytes, name);
      for (const Part& part : scene.parts) {
        EXPECT_NO_THROW(test::numbers(dynamic_cast<const MeshForm&>(*part.form).mesh()));
      }
      ++read;
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
      EXPECT_FALSE(std::string(e.what()).empty());
      ++refused;
    } catch (const GeometryError&) {
      ADD_FAILURE() << "read_mesh tells geometry that cannot be drawn as InputError";
    }
  }
  EXPECT_EQ(read + refused, kMutations);
  EXPECT_GT(refused, 0);
}

const TriMesh kSmall = test::joined(test::torus(5, 2, 8, 6), test::box({20, 0, 0}, {21, 1, 1}));

TEST(Fuzz, StlBinary) { fuzz(test::stl_binary(kSmall), "a.stl", 1); }
TEST(Fuzz, StlAscii) {
  fuzz(test::stl_ascii(kSmall) + test::stl_ascii(test::precise_box(), "b"), "a.stl", 2);
}
TEST(Fuzz, Obj) { fuzz("o a\n" + test::obj(kSmall) + "g b\nf 1/2/3 2//3 3/3 -4\n", "a.obj", 3); }
TEST(Fuzz, Off) { fuzz(test::off(kSmall), "a.off", 4); }
TEST(Fuzz, PlyAscii) { fuzz(test::ply_ascii(kSmall), "a.ply", 5); }
TEST(Fuzz, PlyLittleEndian) { fuzz(test::ply_binary(kSmall), "a.ply", 6); }
TEST(Fuzz, PlyBigEndian) { fuzz(test::ply_binary(kSmall, std::endian::big), "a.ply", 7); }

TEST(Fuzz, RandomTrianglesBecomeSurfaces) {
  // Random triangles over few points break every rule at once.
  const Rng rng(9);
  std::uint64_t n = 0;
  for (int round = 0; round < 1000; ++round) {
    TriMesh m;
    const auto points = static_cast<std::uint32_t>(4 + rng.uniform(n++) * 12);
    for (std::uint32_t i = 0; i < points; ++i) {
      // On a small grid, so that collinear and coincident points abound.
      m.positions.push_back({static_cast<int>(rng.uniform(n) * 4),
                             static_cast<int>(rng.uniform(n + 1) * 4),
                             static_cast<int>(rng.uniform(n + 2) * 2)});
      n += 3;
    }
    const int triangles = 1 + static_cast<int>(rng.uniform(n++) * 60);
    for (int t = 0; t < triangles; ++t) {
      Triangle tri;
      for (std::uint32_t& v : tri) v = static_cast<std::uint32_t>(rng.uniform(n++) * points);
      m.triangles.push_back(tri);
    }
    try {
      const Scene scene = test::read_scene(test::obj(m), "a.obj");
      ASSERT_EQ(scene.parts.size(), 1u);
      EXPECT_NO_THROW(test::numbers(dynamic_cast<const MeshForm&>(*scene.parts[0].form).mesh()))
          << round;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("no triangle with an area"), std::string::npos)
          << round << e.what();
    }
  }
}

}  // namespace
}  // namespace burin
