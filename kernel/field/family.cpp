#include "family.h"

#include <burin/base/parallel.h>
#include <burin/mesh/whole_faces.h>

#include "exact_faces.h"
#include "islands.h"
#include "links.h"
#include "multigrid.h"
#include "short_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace burin::field {
namespace {

// A wedge on the smooth border of a flat part, and how well the first arms of both agree there:
// between -length and length of the border.
struct FamilyBorder {
  std::size_t patch;
  std::uint32_t wedge;
  double agreement;
};

std::vector<FamilyBorder> find_family_borders(const ProxyMesh& proxy, const WedgeGraph& graph,
                                              const std::vector<Vec2>& lines,
                                              const FlatPatches& flats) {
  std::vector<FamilyBorder> borders;
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
      borders.push_back(
          {static_cast<std::size_t>(p), w, glm::distance(a, b) * (2 * cosine * cosine - 1)});
    }
  }
  return borders;
}

// A label of a flat part holds over this share of its extent from a border on: the weight of a
// border is its length over that distance, as for triangles.
constexpr double kReach = 0.25;
// Where nothing else decides, the first arm stays.
constexpr double kStay = 1e-6;

// Every flat part becomes a node behind those of the wedges.
void add_flats(const std::vector<FamilyBorder>& borders, const FlatPatches& flats,
               Links<double>& signs, std::vector<double>& pull, std::vector<double>& mass) {
  const std::size_t n = signs.size(), patches = flats.patches.size();
  std::vector<double> length(patches, 0);
  for (const FamilyBorder& b : borders) length[b.patch] += std::abs(b.agreement);
  std::vector<std::vector<std::pair<std::uint32_t, double>>> added(n + patches);
  for (const FamilyBorder& b : borders) {
    if (b.agreement == 0) continue;
    // The part's extent is about a quarter of its outline.
    const double coupling = b.agreement / (kReach * 0.25 * length[b.patch]);
    added[b.wedge].emplace_back(static_cast<std::uint32_t>(n + b.patch), coupling);
    added[n + b.patch].emplace_back(b.wedge, coupling);
  }
  Links<double> all;
  for (std::size_t i = 0; i < n + patches; ++i) {
    double stiffness = i < n ? signs.stiffness[i] : 0;
    if (i < n) {
      for (std::uint32_t k = signs.first[i]; k < signs.first[i + 1]; ++k) {
        all.neighbour.push_back(signs.neighbour[k]);
        all.coupling.push_back(signs.coupling[k]);
      }
    }
    for (const auto& [j, coupling] : added[i]) {
      all.neighbour.push_back(j);
      all.coupling.push_back(coupling);
      stiffness += std::abs(coupling);
    }
    all.first.push_back(static_cast<std::uint32_t>(all.neighbour.size()));
    all.stiffness.push_back(stiffness);
  }
  signs = std::move(all);
  pull.resize(n + patches, kStay);
  mass.resize(n + patches, kStay);
}

// A border that has next to nothing to say, such as a fillet all round a disc, which agrees with
// one arm as much as with the other but for chance, leaves its part the first arm: discs alike are
// drawn alike.
void keep_first_directions(const std::vector<FamilyBorder>& borders, std::size_t wedges,
                           std::vector<double>& sign) {
  constexpr double kNothing = 0.1;  // of the border's length
  std::vector<double> sum(sign.size() - wedges, 0), length(sum.size(), 0);
  for (const FamilyBorder& b : borders) {
    sum[b.patch] += (sign[b.wedge] < 0 ? -1 : 1) * b.agreement;
    length[b.patch] += std::abs(b.agreement);
  }
  for (std::size_t p = 0; p < sum.size(); ++p) {
    if (std::abs(sum[p]) < kNothing * length[p]) sign[wedges + p] = 1;
  }
}

// The curved faces of which everybody knows how lines run, smallest first: their triangles.
std::vector<std::vector<std::uint32_t>> ruled_faces(const ProxyMesh& proxy,
                                                    const std::vector<FaceKind>& kinds) {
  const std::vector<std::int32_t> whole = whole_faces(proxy);
  struct Ruled {
    double area = 0;
    std::vector<std::uint32_t> triangles;
  };
  std::map<std::int32_t, Ruled> found;
  for (std::uint32_t f = 0; f < kinds.size(); ++f) {
    if (!is_ruled(kinds[f])) continue;
    const std::int32_t face = proxy.source_face[f];
    Ruled& one = found[whole.empty() ? face : whole[static_cast<std::size_t>(face)]];
    one.area += proxy.mesh.area(f);
    one.triangles.push_back(f);
  }
  std::vector<Ruled> sorted;
  for (auto& [face, one] : found) sorted.push_back(std::move(one));
  std::ranges::stable_sort(sorted, {}, &Ruled::area);
  std::vector<std::vector<std::uint32_t>> faces;
  for (Ruled& one : sorted) faces.push_back(std::move(one.triangles));
  return faces;
}

// Families that change names in the middle of a cylinder, cone or torus do so beside it: all of the
// face takes the names that most of it has. A wedge between two such faces goes with the larger.
void settle_ruled_faces(const ProxyMesh& proxy, const WedgeGraph& graph,
                        const std::vector<FaceKind>& kinds, const Links<double>& signs,
                        std::vector<double>& sign, const RunContext& context) {
  std::vector<signed char> same(graph.axis.size(),
                                0);  // as the first wedge of the face; 0: not met
  for (const std::vector<std::uint32_t>& triangles : ruled_faces(proxy, kinds)) {
    context.check();
    std::vector<std::uint32_t> wedges;
    for (const std::uint32_t f : triangles) {
      for (std::size_t k = 0; k < 3; ++k) wedges.push_back(proxy.wedges[f][k]);
    }
    std::ranges::sort(wedges);
    wedges.erase(std::unique(wedges.begin(), wedges.end()), wedges.end());
    const auto of_face = [&](std::uint32_t w) { return std::ranges::binary_search(wedges, w); };
    for (const std::uint32_t start : wedges) {
      if (same[start] != 0) continue;
      std::vector<std::uint32_t> met{start};
      same[start] = 1;
      double names = 0, all = 0;
      for (std::size_t i = 0; i < met.size(); ++i) {
        const std::uint32_t w = met[i];
        names += (sign[w] < 0 ? -1 : 1) * same[w] * graph.area[w];
        all += graph.area[w];
        for (std::uint32_t k = signs.first[w]; k < signs.first[w + 1]; ++k) {
          const std::uint32_t j = signs.neighbour[k];
          if (j >= same.size() || same[j] != 0 || signs.coupling[k] == 0 || !of_face(j)) continue;
          same[j] = static_cast<signed char>(signs.coupling[k] < 0 ? -same[w] : same[w]);
          met.push_back(j);
        }
      }
      if (std::abs(names) == all) continue;
      for (const std::uint32_t w : met) sign[w] = names < 0 ? -same[w] : same[w];
    }
    for (const std::uint32_t w : wedges) same[w] = 0;
  }
}

}  // namespace

std::vector<Vec2> choose_family(const ProxyMesh& proxy, const WedgeGraph& graph,
                                const std::vector<Vec2>& crosses, const Constraints& targets,
                                const std::vector<FaceKind>& kinds, FlatPatches* flats,
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
  std::vector<double> mass = targets.line_mass;
  std::vector<FamilyBorder> borders;
  if (flats) {
    borders = find_family_borders(proxy, graph, line, *flats);
    add_flats(borders, *flats, signs, pull, mass);
  }
  std::vector<double> sign =
      minimise(Hierarchy<double>(signs, context), std::move(mass), pull, context);
  join_islands(signs, pull, sign);
  shorten_cuts(proxy, graph, signs, pull, sign, context);
  join_islands(signs, pull, sign);
  settle_ruled_faces(proxy, graph, kinds, signs, sign, context);
  if (flats) keep_first_directions(borders, n, sign);
  for_wedges([&](std::size_t w) {
    if (sign[w] < 0) line[w] = -line[w];
  });
  for (std::size_t p = 0; n + p < sign.size(); ++p) {
    if (sign[n + p] < 0) flats->patches[p].swap_families();
  }
  return line;
}

void match_flat_families(const ProxyMesh& proxy, const WedgeGraph& graph,
                         const std::vector<Vec2>& lines, FlatPatches& flats) {
  std::vector<double> votes(flats.patches.size(), 0);
  for (const FamilyBorder& border : find_family_borders(proxy, graph, lines, flats)) {
    votes[border.patch] += border.agreement;
  }
  for (std::size_t p = 0; p < votes.size(); ++p) {
    if (votes[p] < 0) flats.patches[p].swap_families();
  }
}

}  // namespace burin::field
