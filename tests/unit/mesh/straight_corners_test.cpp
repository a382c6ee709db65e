// Corners that a cut left in the middle of straight edges.
#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/straight_corners.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace burin {
namespace {

std::size_t removed(TriMesh& mesh, std::vector<std::int32_t>* of = nullptr) {
  return remove_straight_corners(mesh, {}, RunContext(), of);
}

/// Puts a corner on the edge between two corners, at a share of it.
void divide(TriMesh& mesh, std::uint32_t a, std::uint32_t b, double share) {
  const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(glm::mix(mesh.positions[a], mesh.positions[b], share));
  for (std::size_t t = 0, n = mesh.triangles.size(); t < n; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle old = mesh.triangles[t];
      const std::uint32_t p = old[k], q = old[(k + 1) % 3];
      if (std::minmax(p, q) != std::minmax(a, b)) continue;
      mesh.triangles[t] = {p, middle, old[(k + 2) % 3]};
      mesh.triangles.push_back({middle, q, old[(k + 2) % 3]});
      break;
    }
  }
}

double volume(const TriMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum +=
        glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6;
  }
  return sum;
}

TEST(StraightCorners, OnTheRimOfACylinderTheyGo) {
  const TriMesh whole = test::cylinder(10, 20, 16);
  for (const double share : {1e-4, 0.3, 0.5}) {
    TriMesh mesh = whole;
    divide(mesh, 1, 3, share);
    std::vector<std::int32_t> of(mesh.triangles.size(), 7);
    EXPECT_EQ(removed(mesh, &of), 1u) << share;
    EXPECT_EQ(mesh.positions.size(), whole.positions.size());
    EXPECT_EQ(mesh.triangles.size(), whole.triangles.size());
    EXPECT_EQ(of.size(), whole.triangles.size());
    EXPECT_NEAR(volume(mesh), volume(whole), 1e-9);
    const ProxyMesh proxy = build_proxy(mesh, {}, RunContext());
    EXPECT_TRUE(
        std::ranges::none_of(proxy.topology.opposite, [](HalfEdge h) { return h == kNoHalfEdge; }));
  }
}

TEST(StraightCorners, ARowOfThemGoes) {
  TriMesh mesh = test::cylinder(10, 20, 16);
  divide(mesh, 1, 3, 0.6);
  divide(mesh, 1, 34, 0.5);
  divide(mesh, 34, 3, 0.2);
  EXPECT_EQ(removed(mesh), 3u);
}

TEST(StraightCorners, WhereNothingRoundIsTheyStay) {
  TriMesh box = test::box({0, 0, 0}, {30, 20, 10});
  const auto corners = static_cast<std::uint32_t>(box.positions.size());
  divide(box, box.triangles[0][0], box.triangles[0][1], 0.4);
  EXPECT_EQ(removed(box), 0u);
  EXPECT_EQ(box.positions.size(), corners + 1);
  // The facets of a cylinder continue straight along its axis.
  TriMesh cylinder = test::cylinder(10, 20, 16);
  divide(cylinder, 0, 1, 0.5);
  EXPECT_EQ(removed(cylinder), 0u);
}

TEST(StraightCorners, AFineMeshKeepsAll) {
  for (TriMesh mesh : {test::torus(10, 4, 400, 200), test::ellipsoid({10, 7, 5}, 300, 150)}) {
    const std::size_t triangles = mesh.triangles.size();
    EXPECT_EQ(removed(mesh), 0u);
    EXPECT_EQ(mesh.triangles.size(), triangles);
  }
}

TEST(StraightCorners, FacesThatAreToldApartStay) {
  TriMesh mesh = test::cylinder(10, 20, 16);
  divide(mesh, 1, 3, 0.3);
  std::vector<std::int32_t> of(mesh.triangles.size());
  for (std::size_t t = 0; t < of.size(); ++t) of[t] = static_cast<std::int32_t>(t);
  EXPECT_EQ(removed(mesh, &of), 0u);
}

}  // namespace
}  // namespace burin
