#include <burin/base/rng.h>
#include <burin/mesh/reorder.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace burin {
namespace {

using FaceCorners = std::array<std::array<double, 3>, 3>;

std::multiset<FaceCorners> shape_of(const TriMesh& m) {
  std::multiset<FaceCorners> result;
  for (const Triangle& t : m.triangles) {
    FaceCorners c;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = m.positions[t[k]];
      c[k] = {p.x, p.y, p.z};
    }
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    result.insert(c);
  }
  return result;
}

TriMesh shuffled(const TriMesh& m) {
  std::vector<std::uint32_t> order(m.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const Rng rng(3);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[rng.bits(i) % i]);
  TriMesh result = m;
  for (std::size_t v = 0; v < order.size(); ++v) result.positions[order[v]] = m.positions[v];
  for (Triangle& t : result.triangles) t = {order[t[0]], order[t[1]], order[t[2]]};
  return result;
}

double mean_span(const TriMesh& m) {
  double sum = 0;
  for (const Triangle& t : m.triangles) {
    sum += std::max({t[0], t[1], t[2]}) - std::min({t[0], t[1], t[2]});
  }
  return sum / static_cast<double>(m.triangles.size());
}

TEST(Reorder, LeavesAnOrderlyMeshAlone) {
  TriMesh m = test::torus(10, 3, 400, 200);
  const TriMesh before = m;
  EXPECT_FALSE(reorder_for_cache(m));
  EXPECT_EQ(m.triangles, before.triangles);
}

TEST(Reorder, SortsAScatteredMeshAndKeepsItsShape) {
  const TriMesh m = test::torus(10, 3, 400, 200);
  TriMesh sorted = shuffled(m);
  const double scattered = mean_span(sorted);
  EXPECT_TRUE(reorder_for_cache(sorted));
  EXPECT_LT(mean_span(sorted), 0.05 * scattered);
  EXPECT_EQ(shape_of(sorted), shape_of(m));
}

TEST(Reorder, GivesTheSameOrderFarAwayAndAtAnyScale) {
  const TriMesh m = shuffled(test::torus(10, 3, 400, 200));
  TriMesh a = m, b = test::mapped(m, [](Vec3 p) { return p * 1024.0; });
  reorder_for_cache(a);
  reorder_for_cache(b);
  EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace
}  // namespace burin
