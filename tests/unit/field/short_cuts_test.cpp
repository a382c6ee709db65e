/// Cuts between names of families on a square whose labels are given.

#include "short_cuts.h"

#include <burin/mesh/proxy_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin::field {
namespace {

/// A square of 20 x 20 cells in which labels change over a line from (10.3, 1.3) to (10.3, 18.7):
/// its ends, 1.3 from the border, are odd singularities.
struct Square {
  static constexpr std::uint32_t kSide = 20;
  ProxyMesh proxy;
  WedgeGraph graph;
  Links<double> links;

  Square() : proxy(build_proxy(grid(), {}, RunContext())) {
    graph =
        build_wedge_graph(proxy, std::vector<std::uint8_t>(proxy.wedges.size(), 0), RunContext());
    links.first = graph.crosses.first;
    links.neighbour = graph.crosses.neighbour;
    links.stiffness = graph.crosses.stiffness;
    for (std::uint32_t w = 0; w < links.size(); ++w) {
      for (std::uint32_t k = links.first[w]; k < links.first[w + 1]; ++k) {
        links.coupling.push_back(crosses_line(w, links.neighbour[k]) ? -1 : 1);
      }
    }
  }

  bool crosses_line(std::uint32_t u, std::uint32_t v) const {
    constexpr double kX = 10.3, kLow = 1.3, kHigh = 18.7;
    const Vec3 a = proxy.wedge_position(u), b = proxy.wedge_position(v);
    if ((a.x < kX) == (b.x < kX)) return false;
    const double y = a.y + (kX - a.x) / (b.x - a.x) * (b.y - a.y);
    return y > kLow && y < kHigh;
  }

  int links_cut(const std::vector<double>& sign) const {
    int cut = 0;
    for (std::uint32_t w = 0; w < links.size(); ++w) {
      for (std::uint32_t k = links.first[w]; k < links.first[w + 1]; ++k) {
        cut += links.coupling[k] * sign[w] * sign[links.neighbour[k]] < 0;
      }
    }
    return cut / 2;
  }

 private:
  static TriMesh grid() {
    TriMesh mesh;
    for (std::uint32_t j = 0; j <= kSide; ++j) {
      for (std::uint32_t i = 0; i <= kSide; ++i) mesh.positions.emplace_back(i, j, 0);
    }
    for (std::uint32_t j = 0; j < kSide; ++j) {
      for (std::uint32_t i = 0; i < kSide; ++i) {
        const std::uint32_t v = j * (kSide + 1) + i, up = v + kSide + 1;
        mesh.triangles.push_back({v, v + 1, up + 1});
        mesh.triangles.push_back({v, up + 1, up});
      }
    }
    return mesh;
  }
};

TEST(ShortCuts, EndAtTheBorderWhereThatIsNearer) {
  const Square square;
  std::vector<double> sign(square.links.size(), 1);
  ASSERT_GT(square.links_cut(sign), 30);
  shorten_cuts(square.proxy, square.graph, square.links,
               std::vector<double>(square.links.size(), 0), sign, RunContext());
  EXPECT_LE(square.links_cut(sign), 8);
  for (const double s : sign) EXPECT_EQ(s * s, 1);
}

TEST(ShortCuts, DoNotOutweighWhatIsWantedAllOver) {
  const Square square;
  std::vector<double> sign(square.links.size(), 1);
  const int before = square.links_cut(sign);
  std::vector<double> pull;
  for (const double area : square.graph.area) pull.push_back(10 * area / (20.0 * 20.0));
  shorten_cuts(square.proxy, square.graph, square.links, pull, sign, RunContext());
  EXPECT_EQ(square.links_cut(sign), before);
}

}  // namespace
}  // namespace burin::field
