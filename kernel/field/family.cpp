#include "family.h"

#include <burin/base/parallel.h>

#include "islands.h"
#include "multigrid.h"

#include <array>

namespace burin::field {
namespace {

constexpr std::size_t kGrain = 4096;

}  // namespace

std::vector<Vec2> choose_family(const ProxyMesh& proxy, const WedgeGraph& graph,
                                const std::vector<Vec2>& crosses, const Constraints& targets,
                                const RunContext& context) {
  const Links<Vec2>& links = graph.crosses;
  const std::size_t n = links.size();
  std::vector<Vec2> line(n, Vec2(1, 0));
  const auto for_wedges = [&](const auto& body) {
    parallel_for(
        n, kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t w = begin; w < end; ++w) body(w);
        },
        &context);
  };
  for_wedges([&](std::size_t w) {
    const double size = glm::length(crosses[w]);
    if (size > 0) line[w] = complex_sqrt(crosses[w] / size);
  });
  // One sign a wedge is left to choose. Signs that agree over a link have a positive coupling;
  // around an odd singularity they cannot all agree, and the smooth solution passes through zero.
  Links<double> signs;
  signs.first = links.first;
  signs.neighbour = links.neighbour;
  signs.stiffness.assign(n, 0);
  std::vector<double> pull(n, 0);
  signs.coupling.resize(links.coupling.size());
  for_wedges([&](std::size_t w) {
    for (std::uint32_t k = links.first[w]; k < links.first[w + 1]; ++k) {
      const std::uint32_t j = links.neighbour[k];
      const Vec2 r = wedge_turn(proxy, graph, j, static_cast<std::uint32_t>(w));
      const double agree = glm::dot(line[w], complex_mul(complex_square(r), line[j]));
      signs.coupling[k] = agree * glm::length(links.coupling[k]);
      signs.stiffness[w] += std::abs(signs.coupling[k]);
    }
    pull[w] = glm::dot(targets.line_pull[w], line[w]);
  });
  std::vector<double> sign =
      minimise(Hierarchy<double>(signs, context), targets.line_mass, pull, context);
  join_islands(signs, pull, sign);
  for_wedges([&](std::size_t w) {
    if (sign[w] < 0) line[w] = -line[w];
  });
  return line;
}

void match_flat_families(const ProxyMesh& proxy, const WedgeGraph& graph,
                         const std::vector<Vec2>& lines, FlatPatches& flats) {
  std::vector<double> votes(flats.patches.size(), 0);
  for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
    const std::int32_t p = flats.face_patch[h / 3];
    if (p < 0 || proxy.edge_kind[h] != EdgeKind::Smooth) continue;
    if (flats.face_patch[face_of(proxy.topology.opposite[h])] >= 0) continue;
    const std::array<std::uint32_t, 2> ends{proxy.wedges[h / 3][h % 3],
                                            proxy.wedges[h / 3][(h + 1) % 3]};
    const Vec3 a = proxy.wedge_position(ends[0]), b = proxy.wedge_position(ends[1]);
    const auto arms = flats.patches[static_cast<std::size_t>(p)].at(0.5 * (a + b));
    if (!arms) continue;
    for (const std::uint32_t w : ends) {
      const TangentBasis basis(proxy.wedge_normal[w], graph.axis[w]);
      const double cosine = glm::dot(basis.vector(complex_sqrt(lines[w])), arms->first);
      votes[static_cast<std::size_t>(p)] += glm::distance(a, b) * (2 * cosine * cosine - 1);
    }
  }
  for (std::size_t p = 0; p < votes.size(); ++p) {
    if (votes[p] < 0) flats.patches[p].swap_families();
  }
}

}  // namespace burin::field
