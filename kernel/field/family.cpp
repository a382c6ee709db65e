#include "family.h"

#include <burin/base/parallel.h>

namespace burin::field {
namespace {

constexpr std::size_t kGrain = 4096;

}  // namespace

std::vector<Vec2> choose_family(const ProxyMesh& proxy, const WedgeGraph& graph,
                                const std::vector<Vec2>& crosses, const LabelTargets& targets,
                                const RunContext& context) {
  const System<Vec2>& links = graph.crosses;
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
  System<double> signs;
  signs.first = links.first;
  signs.neighbour = links.neighbour;
  signs.stiffness = links.stiffness;
  signs.mass.assign(n, 0);
  signs.pull.assign(n, 0);
  signs.coupling.resize(links.coupling.size());
  for_wedges([&](std::size_t w) {
    for (std::uint32_t k = links.first[w]; k < links.first[w + 1]; ++k) {
      const std::uint32_t j = links.neighbour[k];
      const Vec2 r = wedge_turn(proxy, graph, j, static_cast<std::uint32_t>(w));
      const double agree = glm::dot(line[w], complex_mul(complex_square(r), line[j]));
      signs.coupling[k] = agree * glm::length(links.coupling[k]);
    }
    signs.mass[w] = targets.weight[w];
    signs.pull[w] = glm::dot(targets.line[w], line[w]);
  });
  const std::vector<double> sign = minimise(signs, context);
  for_wedges([&](std::size_t w) {
    if (sign[w] < 0) line[w] = -line[w];
  });
  return line;
}

}  // namespace burin::field
