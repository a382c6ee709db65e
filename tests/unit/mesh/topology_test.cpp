#include <burin/base/error.h>
#include <burin/base/rng.h>
#include <burin/mesh/topology.h>

#include <burin_test/irregular.h>
#include <gtest/gtest.h>

#include <numeric>

namespace burin {
namespace {

/// Larger than one slice of the parallel build.
TriMesh large() { return test::torus(10, 4, 600, 300); }

void expect_consistent(const TriMesh& mesh, const Topology& topology) {
  ASSERT_EQ(topology.opposite.size(), 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < topology.opposite.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    const HalfEdge o = topology.opposite[i];
    ASSERT_NE(o, kNoHalfEdge);
    ASSERT_EQ(topology.opposite[static_cast<std::size_t>(o)], h);
    ASSERT_EQ(origin(mesh, o), origin(mesh, next_in_face(h)));
    ASSERT_EQ(origin(mesh, h), origin(mesh, next_in_face(o)));
  }
  EXPECT_EQ(topology.component_closed, std::vector<std::uint8_t>{1});
}

TEST(Topology, OfALargeMeshIsWholeInAnyOrderOfItsTriangles) {
  const RunContext context;
  TriMesh mesh = large();
  expect_consistent(mesh, build_topology(mesh, context));
  const Rng rng(5);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
    std::swap(mesh.triangles[i - 1], mesh.triangles[rng.bits(i) % i]);
  }
  expect_consistent(mesh, build_topology(mesh, context));
}

TEST(Topology, RefusesAThirdTriangleAtAnEdgeOfAnotherSlice) {
  const RunContext context;
  TriMesh mesh = large();
  const Triangle first = mesh.triangles.front();
  mesh.positions.push_back({0, 0, 100});
  const auto top = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  mesh.triangles.push_back({first[0], first[1], top});
  EXPECT_THROW(build_topology(mesh, context), GeometryError);
  mesh.triangles.back() = {first[1], first[0], top};
  EXPECT_THROW(build_topology(mesh, context), GeometryError);
}

TEST(Topology, RefusesATriangleTurnedAgainstItsNeighboursInAnotherSlice) {
  const RunContext context;
  TriMesh mesh = large();
  std::rotate(mesh.triangles.begin(), mesh.triangles.begin() + 1, mesh.triangles.end());
  std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
  EXPECT_THROW(build_topology(mesh, context), GeometryError);
}

TEST(Topology, CountsComponentsAndTellsOpenOnes) {
  const RunContext context;
  TriMesh mesh = large();
  mesh.triangles.pop_back();
  mesh = test::joined(test::joined(mesh, large()), test::box({20, 0, 0}, {21, 1, 1}));
  const Topology topology = build_topology(mesh, context);
  EXPECT_EQ(topology.component_closed, (std::vector<std::uint8_t>{0, 1, 1}));
  EXPECT_EQ(topology.face_component.front(), 0);
  EXPECT_EQ(topology.face_component.back(), 2);
  EXPECT_EQ(std::ranges::count(topology.opposite, kNoHalfEdge), 3);
}

}  // namespace
}  // namespace burin
