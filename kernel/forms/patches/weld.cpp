#include "weld.h"

#include <burin/base/box.h>
#include <burin/base/disjoint_sets.h>
#include <burin/forms/charted/continuity.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace burin::detail {
namespace {

constexpr int kInterior = 9;  // points a direction inside a patch for its box and its volume

struct Sides {
  std::vector<SideCurve> curve;  // 4 * face + side
  std::vector<std::uint8_t> collapsed;
};

// Which two sides are one edge: b, or the side itself where it is alone.
struct Pairing {
  std::vector<std::size_t> partner;
  std::vector<SideMatch> match;  // of the side with the lower number
};

double part_size(const PatchAtlas& atlas, const std::vector<SideCurve>& curves) {
  Box3 box;
  for (const SideCurve& c : curves) {
    box.add(c.low);
    box.add(c.high);
  }
  for (std::size_t f = 0; f < atlas.face_count(); ++f) {
    const Chart& chart = atlas.chart(static_cast<std::int32_t>(f));
    const ParameterBox d = chart.domain();
    for (int i = 0; i < kInterior * kInterior; ++i) {
      const Vec2 x = (Vec2(i % kInterior, i / kInterior) + 0.5) / double{kInterior};
      box.add(chart.position(d.min + x * d.size()));
    }
  }
  const double size = box.diagonal();
  return size > 0 && std::isfinite(size) ? size : 1;
}

Sides find_sides(const PatchAtlas& atlas, double distance_share, double& size) {
  Sides sides;
  for (std::size_t f = 0; f < atlas.face_count(); ++f) {
    for (int s = 0; s < 4; ++s) {
      sides.curve.push_back(side_curve(atlas.chart(static_cast<std::int32_t>(f)), s));
    }
  }
  size = part_size(atlas, sides.curve);
  for (const SideCurve& c : sides.curve) {
    sides.collapsed.push_back(glm::distance(c.low, c.high) <= distance_share * size);
  }
  return sides;
}

// Sides in the order of their boxes along x: only those whose boxes overlap are compared.
Pairing pair_sides(const Sides& sides, double distance, const RunContext& context) {
  const std::size_t n = sides.curve.size();
  Pairing pairing{std::vector<std::size_t>(n), std::vector<SideMatch>(n)};
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = pairing.partner[i] = i;
  const auto low = [&](std::size_t i) { return sides.curve[i].low.x; };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::pair(low(i), i) < std::pair(low(j), j);
  });
  std::vector<std::pair<std::size_t, std::size_t>> near;
  for (std::size_t x = 0; x < n; ++x) {
    context.check();
    for (std::size_t y = x + 1; y < n; ++y) {
      const std::size_t i = order[x], j = order[y];
      if (low(j) > sides.curve[i].high.x + distance) break;
      if (!sides.collapsed[i] && !sides.collapsed[j]) near.push_back(std::minmax(i, j));
    }
  }
  std::sort(near.begin(), near.end());
  for (const auto& [i, j] : near) {
    if (pairing.partner[i] != i || pairing.partner[j] != j) continue;
    SideMatch m = match(sides.curve[i], sides.curve[j], distance);
    if (!m.found) continue;
    pairing.partner[i] = j;
    pairing.partner[j] = i;
    pairing.match[i] = std::move(m);
  }
  return pairing;
}

// Six times the volume below a face, seen from `center`.
double volume(const Chart& chart, Vec3 center) {
  const ParameterBox d = chart.domain();
  const Vec2 cell = d.size() / double{kInterior};
  double sum = 0;
  for (int i = 0; i < kInterior * kInterior; ++i) {
    const Vec2 x = Vec2(i % kInterior, i / kInterior) + 0.5;
    const SurfaceDerivatives s = chart.derivatives(d.min + x * cell);
    sum += glm::dot(s.p - center, glm::cross(s.u, s.v));
  }
  return sum * cell.x * cell.y;
}

// Turns faces so that those that meet agree; pairs that contradict are separated.
int orient(PatchAtlas& atlas, const Sides& sides, Pairing& pairing) {
  const std::size_t faces = atlas.face_count();
  std::vector<int> turned(faces, -1);
  int contradictions = 0;
  for (std::size_t root = 0; root < faces; ++root) {
    if (turned[root] >= 0) continue;
    std::vector<std::size_t> members{root};
    turned[root] = 0;
    bool closed = true;
    for (std::size_t m = 0; m < members.size(); ++m) {
      for (std::size_t i = 4 * members[m]; i < 4 * members[m] + 4; ++i) {
        const std::size_t j = pairing.partner[i];
        if (j == i) {
          closed = closed && sides.collapsed[i];
          continue;
        }
        const bool backward = pairing.match[std::min(i, j)].backward;
        const int wanted = turned[i / 4] ^ (backward ? 0 : 1);
        if (turned[j / 4] < 0) {
          turned[j / 4] = wanted;
          members.push_back(j / 4);
        } else if (turned[j / 4] != wanted) {
          pairing.partner[i] = i;
          pairing.partner[j] = j;
          closed = false;
          ++contradictions;
        }
      }
    }
    double sum = 0;
    const Vec3 center = sides.curve[4 * root].samples.front();
    for (const std::size_t f : members) {
      sum += (turned[f] ? -1 : 1) * volume(atlas.chart(static_cast<std::int32_t>(f)), center);
    }
    const bool inside_out = closed && sum < 0;
    for (const std::size_t f : members) {
      if ((turned[f] == 1) != inside_out) atlas.reverse(static_cast<std::int32_t>(f));
    }
  }
  return contradictions;
}

// Whether a smooth edge only divides one surface: curvature goes on over it all along.
bool divides(const PatchAtlas& atlas, const PatchEdge& edge) {
  constexpr int kPlaces = 9;
  const auto side = [&](std::int32_t coedge, double t) {
    const std::int32_t f = atlas.uses()[static_cast<std::size_t>(coedge)].face;
    const Vec2 uv = atlas.on_coedge(coedge, t);
    const Chart& chart = atlas.chart(f);
    const SurfaceDerivatives d = chart.derivatives(uv);
    return std::pair(d, chart_normal(d, atlas.reversed(f), uv, chart.domain().center()));
  };
  const double length =
      glm::distance(side(edge.coedge[0], 0).first.p, side(edge.coedge[0], 0.5).first.p) +
      glm::distance(side(edge.coedge[0], 0.5).first.p, side(edge.coedge[0], 1).first.p);
  if (!(length > 0)) return false;
  for (int i = 0; i < kPlaces; ++i) {
    const double t = (i + 0.5) / kPlaces;
    const auto [a, normal_a] = side(edge.coedge[0], t);
    const auto [b, normal_b] = side(edge.coedge[1], t);
    if (!bends_alike(a, normal_a, b, normal_b, length)) return false;
  }
  return true;
}

// The largest angle between both normals somewhere along the edge, against kSharpAngle.
ModelEdgeClass edge_kind(const PatchAtlas& atlas, const PatchEdge& edge) {
  if (edge.coedge[1] < 0) return ModelEdgeClass::Boundary;
  constexpr int kPlaces = 16;
  const double limit = std::cos(kSharpAngle * std::numbers::pi / 180);
  const auto normal = [&](std::int32_t coedge, double t) {
    const std::int32_t f = atlas.uses()[static_cast<std::size_t>(coedge)].face;
    const Vec2 uv = atlas.on_coedge(coedge, t);
    const Chart& chart = atlas.chart(f);
    return chart_normal(chart.derivatives(uv), atlas.reversed(f), uv, chart.domain().center());
  };
  for (int i = 0; i < kPlaces; ++i) {
    const double t = (i + 0.5) / kPlaces;
    const Vec3 a = normal(edge.coedge[0], t), b = normal(edge.coedge[1], t);
    if (a != Vec3(0) && b != Vec3(0) && glm::dot(a, b) < limit) return ModelEdgeClass::Sharp;
  }
  const auto face = [&](int k) {
    return atlas.uses()[static_cast<std::size_t>(edge.coedge[static_cast<std::size_t>(k)])].face;
  };
  const bool one = face(0) == face(1) || divides(atlas, edge);
  return one ? ModelEdgeClass::Seam : ModelEdgeClass::Smooth;
}

void add_edges(PatchComplex& complex, const Sides& sides, Pairing& pairing) {
  PatchAtlas& atlas = *complex.atlas;
  complex.coedge.assign(atlas.face_count(), {-1, -1, -1, -1});
  for (std::size_t i = 0; i < sides.curve.size(); ++i) {
    const std::size_t j = pairing.partner[i];
    if (sides.collapsed[i] || j < i) continue;
    PatchEdge edge;
    const auto id = static_cast<std::int32_t>(complex.edges.size());
    const auto use = [&](std::size_t side, bool backward, std::vector<double> table) {
      const auto coedge = static_cast<std::int32_t>(atlas.uses().size());
      complex.coedge[side / 4][side % 4] = coedge;
      const std::int32_t master = edge.coedge[0] < 0 ? coedge : edge.coedge[0];
      atlas.uses().push_back({static_cast<std::int32_t>(side / 4), static_cast<int>(side % 4), id,
                              backward, master, std::move(table)});
      return coedge;
    };
    edge.coedge[0] = use(i, false, {});
    if (j != i) {
      edge.coedge[1] = use(j, pairing.match[i].backward, std::move(pairing.match[i].table));
    }
    edge.kind = edge_kind(atlas, edge);
    complex.edges.push_back(edge);
  }
}

void add_vertices(PatchComplex& complex, const Sides& sides, const Pairing& pairing,
                  double distance) {
  const std::size_t n = sides.curve.size();
  const auto end = [](std::size_t side) { return side - side % 4 + (side + 1) % 4; };
  DisjointSets sets(n);
  const auto join = [&](std::size_t a, std::size_t b) {
    sets.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const SideCurve& c = sides.curve[i];
    const bool loop = glm::distance(c.samples.front(), c.samples.back()) <= distance;
    if (sides.collapsed[i] || loop) join(i, end(i));
    const std::size_t j = pairing.partner[i];
    if (j <= i) continue;
    const bool backward = pairing.match[i].backward;
    join(i, backward ? end(j) : j);
    join(end(i), backward ? j : end(j));
  }
  std::vector<std::uint32_t> id(n, 0);
  complex.corner.resize(n / 4);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t root = sets.find(static_cast<std::uint32_t>(i));
    if (root == i) {
      id[i] = static_cast<std::uint32_t>(complex.vertices.size());
      complex.vertices.push_back(sides.curve[i].samples.front());
    }
    complex.corner[i / 4][i % 4] = id[root];
  }
}

}  // namespace

PatchComplex weld(const ChartList& patches, double tolerance, const RunContext& context) {
  PatchComplex complex;
  complex.atlas = std::make_shared<PatchAtlas>(split_at_kinks(mend_poles(patches, tolerance)));
  const Sides sides = find_sides(*complex.atlas, tolerance, complex.size);
  Pairing pairing = pair_sides(sides, tolerance * complex.size, context);
  complex.contradictions = orient(*complex.atlas, sides, pairing);
  add_vertices(complex, sides, pairing, tolerance * complex.size);
  add_edges(complex, sides, pairing);
  for (PatchEdge& edge : complex.edges) {
    const SideUse& use = complex.atlas->uses()[static_cast<std::size_t>(edge.coedge[0])];
    const auto& corners = complex.corner[static_cast<std::size_t>(use.face)];
    const auto side = static_cast<std::size_t>(use.side);
    edge.vertex = {corners[side], corners[(side + 1) % 4]};
  }
  return complex;
}

}  // namespace burin::detail
