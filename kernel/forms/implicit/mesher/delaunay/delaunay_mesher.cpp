#include "delaunay_mesher.h"

#include <burin/base/disjoint_sets.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include "../../function/project.h"
#include "../specks.h"
#include "field.h"
#include "refine.h"
#include "sizing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace burin {
namespace {

// Times the vertices allowed, and times those expected: beyond that it does not end by itself.
constexpr double kBoundsMargin = 1.5, kSurplus = 3;
// Seeds nearer to one another than this share of the radius would make the triangles smaller than
// they need be.
constexpr double kSeedGap = 1.1;
// Vertices of a component that are seeds however near they are: a body of a few steps.
constexpr std::size_t kLeastSeeds = 24;

double longest(const Box3& b) {
  const Vec3 s = b.size();
  return std::max({s.x, s.y, s.z});
}

std::size_t component_count(const ExactMesh& mesh) {
  DisjointSets parts(mesh.positions.size());
  std::set<std::uint32_t> names;
  for (const Triangle& t : mesh.triangles) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  for (const Triangle& t : mesh.triangles) names.insert(parts.find(t[0]));
  return names.size();
}

bool is_tip(const ExactMesh& mesh, std::uint32_t v) {
  return !mesh.on_crease(v) && mesh.zero[v] != 0 && mesh.normals[v] == Vec3(0);
}

// Order along a curve that fills space.
std::vector<std::uint32_t> morton_order(const std::vector<Vec3>& points) {
  constexpr int kBits = 21;
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const double cells = ((1 << kBits) - 1) / std::max(longest(box), 1e-300);
  std::vector<std::uint64_t> keys(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::ivec3 c((points[i] - box.min) * cells);
    for (int bit = 0; bit < kBits; ++bit) {
      for (int a = 0; a < 3; ++a) {
        keys[i] |= static_cast<std::uint64_t>((c[a] >> bit) & 1) << (3 * bit + a);
      }
    }
  }
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return keys[i]; });
  return order;
}

// The places of a chain, each once; empty where no curve comes of it. Mesh_3 does not test what it
// is given: a curve of one place, as at a corner that two vertices found, ends in a crash.
std::vector<Vec3> curve_of(const ExactMesh& mesh, const std::vector<std::uint32_t>& chain) {
  std::vector<Vec3> curve;
  for (const std::uint32_t v : chain) {
    if (curve.empty() || curve.back() != mesh.positions[v]) curve.push_back(mesh.positions[v]);
  }
  const bool closed = curve.front() == curve.back();
  constexpr std::size_t kLine = 2, kLoop = 4;  // a loop begins and ends at the same place
  if (curve.size() < (closed ? kLoop : kLine)) curve.clear();
  return curve;
}

// Vertices of the coarse mesh, no two nearer than the radius there; some of each component.
class SeedChooser {
 public:
  SeedChooser(const ExactMesh& mesh, const Sizing& sizing)
      : mesh_(mesh), sizing_(sizing), seen_(mesh.positions.size(), 0) {}

  std::vector<Vec3> choose(const ImplicitFunction& f) {
    DisjointSets parts(mesh_.positions.size());
    for (const Triangle& t : mesh_.triangles) {
      parts.join(t[0], t[1]);
      parts.join(t[0], t[2]);
    }
    std::unordered_map<std::uint32_t, std::size_t> taken;  // of a component
    std::vector<std::uint8_t> covered(mesh_.positions.size(), 0);
    std::vector<Vec3> seeds;
    for (const std::uint32_t v : morton_order(mesh_.positions)) {
      if (sizing_.around(v).empty() || mesh_.on_crease(v) || is_tip(mesh_, v)) continue;
      std::size_t& count = taken[parts.find(v)];
      if (covered[v] && count >= kLeastSeeds) continue;
      ++count;
      seeds.push_back(moved(f, v, seeds.size()));
      for (const std::uint32_t w : disc(v, kSeedGap * sizing_.at_vertex(v))) covered[w] = 1;
    }
    return seeds;
  }

 private:
  // A little aside: points of a regular grid on a plane lie on common spheres by the dozen, and
  // those of the two faces of a plate above one another.
  Vec3 moved(const ImplicitFunction& f, std::uint32_t v, std::size_t n) const {
    constexpr double kAside = 0.2;  // steps
    const auto share = [&](double a) {
      const double x = a * static_cast<double>(n + 1);
      return x - std::floor(x) - 0.5;
    };
    // Irrational shares: evenly spread and the same every time.
    const Vec3 aside =
        kAside * mesh_.step * Vec3(share(0.8191725134), share(0.6710436067), share(0.5497004779));
    return onto_surface(f, mesh_.positions[v] + aside, mesh_.step, mesh_.accuracy)
        .value_or(mesh_.positions[v]);
  }

  // The vertices around `v` within the distance.
  const std::vector<std::uint32_t>& disc(std::uint32_t v, double distance) {
    ++round_;
    disc_.assign(1, v);
    seen_[v] = round_;
    for (std::size_t i = 0; i < disc_.size(); ++i) {
      for (const std::uint32_t w : sizing_.around(disc_[i])) {
        if (seen_[w] == round_) continue;
        if (!(glm::distance(mesh_.positions[v], mesh_.positions[w]) < distance)) continue;
        seen_[w] = round_;
        disc_.push_back(w);
      }
    }
    return disc_;
  }

  const ExactMesh& mesh_;
  const Sizing& sizing_;
  std::vector<std::uint32_t> seen_, disc_;
  std::uint32_t round_ = 0;
};

// Refined vertices put exactly onto the surface and its creases, with what is known there.
class Finisher {
 public:
  Finisher(const Survey& survey, const CreaseChains& chains)
      : survey_(survey), coarse_(survey.mesh), finder_(survey.mesh, chains, survey.mesh.step) {
    for (std::uint32_t v = 0; v < coarse_.positions.size(); ++v) {
      if (is_tip(coarse_, v)) tips_.push_back(v);
    }
  }

  ExactMesh finish(RefinedMesh refined, std::size_t& stray, const RunContext& context) const {
    ExactMesh mesh;
    mesh.size = longest(survey_.box);
    mesh.accuracy = coarse_.accuracy;
    take_in_order(mesh, refined);
    measure_edges(mesh);
    const std::size_t n = mesh.positions.size();
    mesh.normals.resize(n);
    mesh.pieces.resize(n);
    mesh.crease.assign(n, -1);
    mesh.zero.assign(n, 0);
    mesh.side.assign(mesh.triangles.size(), nullptr);
    std::vector<Placed> placed(n);
    parallel_for(
        n, 256,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t v = begin; v < end; ++v) {
            placed[v] = place(mesh, static_cast<std::uint32_t>(v), refined.dimension[v]);
          }
        },
        &context);
    const ImplicitFunction& f = *survey_.function;
    for (std::uint32_t v = 0; v < n; ++v) {
      Placed& p = placed[v];
      mesh.positions[v] = p.position;
      mesh.pieces[v] = f.piece(p.position);
      mesh.normals[v] = p.tip ? Vec3(0) : normalize_or(f.gradient(p.position).gradient, Vec3(0));
      mesh.zero[v] = p.tip;
      stray += p.stray;
      if (p.sides.sides.empty()) continue;
      mesh.normals[v] = p.sides.sides.front().normal;
      mesh.crease[v] = static_cast<std::int32_t>(mesh.creases.size());
      mesh.creases.push_back(std::move(p.sides));
    }
    return mesh;
  }

 private:
  struct Placed {
    Vec3 position{0};
    CreaseVertex sides;
    bool tip = false, stray = false;
  };

  static void take_in_order(ExactMesh& mesh, RefinedMesh& refined) {
    const std::vector<std::uint32_t> order = morton_order(refined.positions);
    std::vector<std::uint32_t> name(order.size());
    std::vector<std::uint8_t> dimension;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      name[order[i]] = i;
      mesh.positions.push_back(refined.positions[order[i]]);
      dimension.push_back(refined.dimension[order[i]]);
    }
    refined.dimension = std::move(dimension);
    mesh.triangles = std::move(refined.triangles);
    for (Triangle& t : mesh.triangles) {
      for (std::uint32_t& v : t) v = name[v];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
    std::ranges::sort(mesh.triangles);
  }

  static void measure_edges(ExactMesh& mesh) {
    std::vector<double> sum(mesh.positions.size(), 0), lengths;
    std::vector<int> count(mesh.positions.size(), 0);
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double l = glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
        sum[t[k]] += l;
        ++count[t[k]];
        lengths.push_back(l);
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) {
      mesh.spacing.push_back(count[v] > 0 ? sum[v] / count[v] : 0);
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    mesh.step = *middle;
  }

  Placed place(const ExactMesh& mesh, std::uint32_t v, int dimension) const {
    const ImplicitFunction& f = *survey_.function;
    Placed out;
    out.position = mesh.positions[v];
    if (dimension < 2) {
      for (const std::uint32_t tip : tips_) {
        if (coarse_.positions[tip] != out.position) continue;
        out.tip = true;
        return out;
      }
      if (on_chain(mesh, dimension, out)) return out;
    }
    if (const auto q = onto_surface(f, out.position, mesh.spacing[v], mesh.accuracy)) {
      out.position = *q;
    } else {
      out.stray = !on_surface(mesh, out.position);
    }
    return out;
  }

  bool on_chain(const ExactMesh& mesh, int dimension, Placed& out) const {
    ChainFinder::Place at;
    if (!finder_.find(out.position, at)) return false;
    const auto& own = coarse_.creases[static_cast<std::size_t>(coarse_.crease[at.nearest])];
    if (dimension == 0 || coarse_.positions[at.nearest] == out.position) {
      out.position = coarse_.positions[at.nearest];
      out.sides = own;
      return true;
    }
    const auto sides = common_sides(coarse_, at.from, at.to);
    const double reach = glm::distance(coarse_.positions[at.from], coarse_.positions[at.to]);
    std::optional<Meeting> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        auto m = find_crease(mesh, *survey_.function, *sides[i].piece, *sides[j].piece,
                             out.position, reach);
        if (!m || glm::distance(m->position, out.position) >= least) continue;
        least = glm::distance(m->position, out.position);
        best = std::move(m);
      }
    }
    if (best) {
      out.position = best->position;
      out.sides = std::move(best->sides);
    } else {
      out.sides = own;
      out.stray = !on_surface(mesh, out.position);
    }
    return true;
  }

  bool on_surface(const ExactMesh& mesh, Vec3 p) const {
    const Gradient1 g = survey_.function->gradient(p);
    return std::abs(g.value) <= 1e-9 * mesh.size * glm::length(g.gradient);
  }

  const Survey& survey_;
  const ExactMesh& coarse_;
  ChainFinder finder_;
  std::vector<std::uint32_t> tips_;
};

}  // namespace

DelaunayOutlook delaunay_outlook(const Survey& survey, double tolerance,
                                 const RunContext& context) {
  const CreaseChains chains = chain_creases(survey.mesh, *survey.function);
  return {Sizing(survey.mesh, *survey.function, chains, tolerance, context).expected_vertices()};
}

std::optional<ExactMesh> mesh_delaunay(const Survey& survey, double tolerance,
                                       std::size_t most_triangles, MeshCounts& counts,
                                       Diagnostics& diagnostics, RunContext& context) {
  const ExactMesh& coarse = survey.mesh;
  const CreaseChains chains = chain_creases(coarse, *survey.function);
  Sizing sizing(coarse, *survey.function, chains, tolerance, context);
  const double most = 0.5 * static_cast<double>(most_triangles);
  if (sizing.expected_vertices() > most) {
    const double times = std::sqrt(sizing.expected_vertices() / most);
    sizing.enlarge(times);
    diagnostics.add(Severity::Info, "implicit.proxy_coarse", 1,
                    fmt::format("the triangles that hide lines are {:.3g} times as large as the "
                                "tolerance asks, so that there are not more than {}; lines and "
                                "strokes are exact nevertheless",
                                times, most_triangles));
  }
  RefineInput input;
  const double margin = 0.05 * longest(survey.box);
  input.box = {survey.box.min - margin, survey.box.max + margin};
  input.seeds = SeedChooser(coarse, sizing).choose(*survey.function);
  for (const auto& chain : chains) {
    if (auto curve = curve_of(coarse, chain); !curve.empty()) {
      input.curves.push_back(std::move(curve));
    }
  }
  for (std::uint32_t v = 0; v < coarse.positions.size(); ++v) {
    if (is_tip(coarse, v)) input.corners.push_back(coarse.positions[v]);
  }
  input.distance = sizing.tolerance();
  input.least_edge = 0.05 * sizing.least();
  input.most_vertices = static_cast<std::size_t>(
                            std::min(kBoundsMargin * most, kSurplus * sizing.expected_vertices())) +
                        1000;
  FunctionField field(*survey.function, input.box, sizing, input.most_vertices, context);
  const auto failed = [&](const std::string& why) {
    diagnostics.add(
        Severity::Info, "implicit.delaunay_failed", 1,
        fmt::format("graded triangles could not be made ({}); even ones are used", why));
  };
  RefinedMesh refined;
  try {
    refined = refine_surface(input, field);
  } catch (const Error&) {
    throw;
  } catch (const BudgetSpent&) {
    failed("refinement does not end");
    return std::nullopt;
  } catch (const std::exception& e) {
    std::string why = e.what();
    std::ranges::replace(why, '\n', ' ');
    failed(why);
    return std::nullopt;
  }
  if (refined.full) {
    failed(fmt::format("{} vertices are not enough", input.most_vertices));
    return std::nullopt;
  }
  if (!refined.manifold) {
    failed("the surface is not closed");
    return std::nullopt;
  }
  ExactMesh mesh = Finisher(survey, chains).finish(std::move(refined), counts.strays, context);
  if (survey.smallest > 0) counts.specks += drop_specks(mesh, survey.smallest);
  const std::size_t wanted = component_count(coarse), got = component_count(mesh);
  if (got != wanted) {
    failed(fmt::format("{} of {} bodies and hollows were found", got, wanted));
    return std::nullopt;
  }
  cut_along_creases(mesh, *survey.function, context);
  return mesh;
}

}  // namespace burin
