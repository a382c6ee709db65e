/// Edges of triangles that are flipped: neighbours, sides and corners stay in step.

#include <burin/work_mesh/half_edges.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace burin {
namespace {

TEST(FlipEdge, KeepsNeighboursSidesAndCorners) {
  const TriMesh sphere = test::ellipsoid({1, 2, 3}, 12, 8);
  const auto start = [&](const std::vector<Triangle>& triangles, HalfEdge h) {
    return triangles[face_of(h)][static_cast<std::size_t>(h % 3)];
  };
  const std::size_t sides = 3 * sphere.triangles.size();
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(sides); ++h) {
    std::vector<Triangle> triangles = sphere.triangles;
    std::vector<HalfEdge> opposite = pair_half_edges(triangles, sphere.positions.size());
    const HalfEdge o = opposite[static_cast<std::size_t>(h)];
    const std::uint32_t c = start(triangles, prev_in_face(h)),
                        d = start(triangles, prev_in_face(o));
    // At the poles an edge joins them already.
    bool joined = false;
    for (HalfEdge k = 0; k < static_cast<HalfEdge>(sides); ++k) {
      joined |= start(triangles, k) == c && start(triangles, next_in_face(k)) == d;
    }
    if (joined) continue;
    // Each side carries its two ends, each corner its vertex.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    std::vector<std::uint32_t> vertex;
    for (HalfEdge k = 0; k < static_cast<HalfEdge>(sides); ++k) {
      ends.push_back({start(triangles, k), start(triangles, next_in_face(k))});
      vertex.push_back(start(triangles, k));
    }
    const auto flipped = flip_edge(triangles, opposite, h);
    carry(flipped, &FlippedSide::side, ends, {0, 0});
    carry(flipped, &FlippedSide::corner, vertex);
    std::size_t fresh = 0;
    for (HalfEdge k = 0; k < static_cast<HalfEdge>(sides); ++k) {
      const auto at = static_cast<std::size_t>(k);
      const std::pair now(start(triangles, k), start(triangles, next_in_face(k)));
      EXPECT_EQ(vertex[at], now.first);
      if (ends[at] != now) ++fresh;
    }
    EXPECT_EQ(fresh, 2u) << "the new edge, from both sides";
    EXPECT_EQ(opposite, pair_half_edges(triangles, sphere.positions.size()));
  }
}

}  // namespace
}  // namespace burin
