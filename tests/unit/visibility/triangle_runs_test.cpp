#include <burin/base/rng.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>
#include <triangle_runs.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

TriMesh with_triangles_in_no_order(TriMesh mesh) {
  const Rng rng(5);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
    std::swap(mesh.triangles[i - 1], mesh.triangles[rng.bits(i) % i]);
  }
  return mesh;
}

TriangleRuns runs_of(const TriMesh& mesh) {
  const RunContext context;
  const Box3 box = mesh.bounds();
  return {mesh, {box.center(), 0.5 * box.diagonal()}, context};
}

TEST(TriangleRuns, HoldEachTriangleOnceInWhateverOrder) {
  for (const TriMesh& mesh :
       {test::torus(10, 3, 100, 50), with_triangles_in_no_order(test::torus(10, 3, 100, 50))}) {
    const TriangleRuns runs = runs_of(mesh);
    std::vector<int> seen(mesh.triangles.size(), 0);
    for (std::size_t run = 0; run < runs.size(); ++run) {
      for (std::uint32_t i = 0; i < runs.count(run); ++i) ++seen[runs.face(run, i)];
    }
    EXPECT_EQ(seen, std::vector<int>(mesh.triangles.size(), 1));
  }
}

// A tree over single triangles takes twice as long to ask.
TEST(TriangleRuns, AreLongWhereTrianglesStandInNoOrder) {
  const TriMesh mesh = test::torus(10, 3, 100, 50);
  const auto triangles = static_cast<double>(mesh.triangles.size());
  EXPECT_GT(triangles / static_cast<double>(runs_of(mesh).size()), 2.5);
  EXPECT_GT(triangles / static_cast<double>(runs_of(with_triangles_in_no_order(mesh)).size()), 2.0);
}

}  // namespace
}  // namespace burin::detail
