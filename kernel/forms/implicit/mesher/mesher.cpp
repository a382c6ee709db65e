#include "mesher.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include "../function/project.h"
#include "../function/shape_operator.h"
#include "boxes.h"
#include "hidden.h"
#include "pieces.h"
#include "specks.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace burin {
namespace {

// Steps of the first look along the longest side of the domain: everything larger than two of them
// is found.
constexpr double kSurveySteps = 128, kFewestSteps = 32;
// Where nothing is found: plates and lenses are thinner at times, and empty space costs little.
constexpr double kMostSteps = 1024;
// Nanoseconds of one core that a look may take.
constexpr double kLookBudget = 4e9;
// What may be spent on what lies between its samples: shares of what the look itself has taken, at
// least so many nanoseconds, to find the places and to mesh what is there.
constexpr double kHiddenShare = 0.1, kPiecesShare = 0.2, kHiddenLeast = 1e8, kPiecesLeast = 5e8;
// Vertices of a look: a surface that has more is noise, or finer than a drawing can show.
constexpr std::size_t kMaxVertices = 1'500'000;
constexpr double kCoarsest = 64, kFinestSteps = 1000;  // steps along the surface's longest side
// Triangles a square of one step: crossed cells twice, as surfaces slanted to the grid have 1.5.
constexpr double kTrianglesPerStep = 3;
constexpr double kEdgePerStep = 1.25;  // mean length of the longer edges

ExactMesh mesh_grid(const ImplicitFunction& f, const Grid& grid, double size, double smallest,
                    const WorkBudget& budget, MeshCounts& counts, const RunContext& context) {
  Nets nets = make_nets(grid, context);
  if (nets.vertices.size() > kMaxVertices) throw TooMuchWork();
  ExactMesh mesh =
      project_nets(f, std::move(nets), grid.layout(), size, budget, counts.strays, context);
  if (smallest > 0) counts.specks += drop_specks(mesh, smallest);
  cut_along_creases(mesh, f, context);
  return mesh;
}

// Mm; a step across it still keeps a ten-millionth of a mm in double.
constexpr double kFarthestBounds = 1e9;

bool finite(const Box3& b) {
  for (int a = 0; a < 3; ++a) {
    if (!(std::abs(b.min[a]) < kFarthestBounds) || !(std::abs(b.max[a]) < kFarthestBounds) ||
        !(b.min[a] < b.max[a])) {
      return false;
    }
  }
  return true;
}

bool reaches(const Box3& surface, const Box3& domain, double margin) {
  for (int a = 0; a < 3; ++a) {
    if (surface.min[a] < domain.min[a] + margin || surface.max[a] > domain.max[a] - margin) {
      return true;
    }
  }
  return false;
}

std::string shown(const Box3& b) {
  return fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}", b.min.x, b.min.y, b.min.z,
                     b.max.x, b.max.y, b.max.z);
}

[[noreturn]] void all_inside(const Box3& domain) {
  throw GeometryError(fmt::format(
      "the function is negative everywhere in {}: there is no surface; give a larger domain by "
      "`bounds`",
      shown(domain)));
}

bool any_within(const std::vector<Vec3>& points, const Box3& domain) {
  const double margin = 1e-6 * longest(domain);
  return std::ranges::any_of(points, [&](const Vec3& p) {
    Box3 at;
    at.add(p);
    return !reaches(at, domain, margin);
  });
}

class NoSurface : public GeometryError {
 public:
  using GeometryError::GeometryError;
};

[[noreturn]] void no_surface(const ImplicitFunction& f, const Grid& grid, const Box3& domain) {
  const double middle = f.value(domain.center());
  if (!grid.any_outside()) all_inside(domain);
  if (std::isnan(middle)) {
    throw GeometryError(fmt::format(
        "the function is not a number in {}: there is no surface; mind roots and logarithms of "
        "negative numbers",
        shown(domain)));
  }
  throw NoSurface(
      fmt::format("the function is nowhere negative in {}, looked at in steps of {:.3g} mm: there "
                  "is no surface; check the formula, its sign and `bounds`",
                  shown(domain), grid.layout().step));
}

// Roundings, signs and comparisons make steps: no normal, no curvature, nothing to draw.
void check_slope(const ExactMesh& mesh) {
  const auto level = std::ranges::count(mesh.normals, Vec3(0));
  if (2 * static_cast<std::size_t>(level) > mesh.normals.size()) {
    throw GeometryError(
        "the function has no slope where it changes its sign; give one that grows steadily from "
        "the inside out, like a distance");
  }
}

void measure(Survey& s, const RunContext& context) {
  std::vector<double> curvature(s.mesh.positions.size());
  parallel_for(
      curvature.size(), 512,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Gradient2> g(end - begin);
        s.function->hessians(std::span(s.mesh.positions).subspan(begin, end - begin), g);
        for (std::size_t i = begin; i < end; ++i) {
          const double k = largest_curvature(g[i - begin]);
          curvature[i] =
              s.mesh.on_crease(static_cast<std::uint32_t>(i)) || !std::isfinite(k) ? 0 : k;
        }
      },
      &context);
  std::vector<double> sorted = curvature;
  const std::size_t at = sorted.size() * 49 / 50;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(at));
  s.small_radius = sorted[at] > 0 ? 1 / sorted[at] : std::numeric_limits<double>::infinity();
  TriMesh area;
  area.positions = s.mesh.positions;
  area.triangles = s.mesh.triangles;
  for (std::uint32_t t = 0; t < area.triangles.size(); ++t) s.area += area.area(t);
}

// Components around one corner of the grid each, which may be rims of something as large as a cell.
void add_chips(const std::vector<Box3>& chips, const GridLayout& layout,
               std::vector<HiddenPlace>& places) {
  constexpr double kRim = 1.0 / 16;  // steps
  for (const Box3& chip : chips) {
    const Box3 place{chip.center() - kRim * layout.step, chip.center() + kRim * layout.step};
    for (int k = 0; k < 8; ++k) {
      const Vec3 aside = layout.step * (Vec3(k & 1, (k >> 1) & 1, k >> 2) - 0.5);
      places.push_back({layout.cell_of(chip.center() + aside), place});
    }
  }
}

void look_between(Survey& s, const GridLayout& layout, const Box3& within,
                  const RunContext& context) {
  s.unseen.below = 2 * layout.step;
  if (!s.function->has_slopes()) {
    s.unseen.why = "a function without bounds of its slope over boxes is only sampled";
    s.unseen.severity = Severity::Info;
    return;
  }
  const double taken = kLookBudget - s.mesh.budget.left();
  HiddenPlaces hidden =
      find_hidden(*s.function, layout, within, s.mesh.positions,
                  WorkBudget(std::max(kHiddenLeast, kHiddenShare * taken)), context);
  // Single samples in so many places are those of a wall as thin as a cell.
  constexpr std::size_t kMostChips = 1000;
  const bool few = s.mesh.chips.size() <= kMostChips;
  if (few) add_chips(s.mesh.chips, layout, hidden.places);
  WorkBudget budget(std::max(kPiecesLeast, kPiecesShare * taken));
  const bool all = add_hidden_pieces(s, hidden.places, layout, budget, context);
  // What a drawing may show: as large as a 300th of the domain, however thin.
  constexpr double kShown = kSurveySteps / 300;
  if (!few || !all || longest_missing(s, hidden, layout) >= kShown * layout.step) {
    s.unseen.why = "there is more between the samples than can be meshed";
  } else if (!hidden.whole) {
    s.unseen.why = "to search between the samples beside walls and bends takes too long";
    s.unseen.severity = Severity::Info;
  } else {
    s.unseen.below = 0;
  }
}

// One look at a given number of steps along the longest side of the domain.
Survey look(std::shared_ptr<const ImplicitFunction> function, Box3 at, bool given, double smallest,
            double steps, const RunContext& context) {
  constexpr int kEnlargements = 4;
  Survey s;
  s.function = std::move(function);
  WorkBudget budget(kLookBudget);
  for (int round = 0;; ++round) {
    const double step = longest(at) / steps;
    if (given) s.function = clip(s.function, at);
    const Grid grid(*s.function, make_layout(at, step), budget, context);
    if (grid.blocks().empty()) no_surface(*s.function, grid, at);
    MeshCounts counts;
    s.mesh = mesh_grid(*s.function, grid, longest(at), 0, budget, counts, context);
    check_slope(s.mesh);
    s.box = box_of(s.mesh.positions);
    if (smallest > 0) {
      s.smallest = smallest * largest_component(s.mesh);
      drop_specks(s.mesh, s.smallest);
    }
    if (s.mesh.triangles.empty()) no_surface(*s.function, grid, at);
    if (given && !any_within(s.mesh.positions, at)) all_inside(at);
    const bool cut = reaches(s.box, at, given ? 1e-9 * longest(at) : 0.0);
    if (given && cut) {
      s.diagnostics.add(Severity::Warning, "implicit.clipped", 1,
                        fmt::format("the surface reaches the domain {} and is cut there; a larger "
                                    "one can be given by `bounds`",
                                    shown(at)));
    }
    if (given || !cut) {
      measure(s, context);
      // Components of a given size are all that is wanted of measured data.
      if (smallest == 0) {
        const Box3 own = s.function->bounds();
        const bool holds = round == 0 || given;
        look_between(s, grid.layout(),
                     holds ? Box3{glm::max(at.min, own.min), glm::min(at.max, own.max)} : at,
                     context);
      }
      return s;
    }
    // Bounds that were derived and do not hold: solids that are no distances, offset far.
    if (round == kEnlargements) {
      given = true;
      continue;
    }
    at = {at.min - 0.25 * at.size(), at.max + 0.25 * at.size()};
  }
}

// By more and more steps, as far as that is affordable.
template <class Look>
std::optional<Survey> found_by_more(const Look& look_in) {
  for (double steps = 2 * kSurveySteps; steps <= kMostSteps; steps *= 2) {
    try {
      return look_in(steps);
    } catch (const NoSurface&) {
    } catch (const TooMuchWork&) {
      break;
    }
  }
  return std::nullopt;
}

}  // namespace

Survey survey(const std::shared_ptr<const ImplicitFunction>& function, const Box3& domain,
              bool given, double smallest, const RunContext& context) {
  Box3 at = domain;
  if (!given) at = {domain.min - 0.01 * domain.size(), domain.max + 0.01 * domain.size()};
  if (!finite(at)) {
    throw GeometryError(fmt::format(
        "the domain {} is empty, endless or reaches farther than {:g} mm from the origin",
        shown(at), kFarthestBounds));
  }
  const auto look_in = [&](double steps) {
    return look(function, at, given, smallest, steps, context);
  };
  for (double steps = kSurveySteps; steps >= kFewestSteps; steps /= 2) {
    try {
      Survey s = look_in(steps);
      if (steps < kSurveySteps) {
        s.diagnostics.add(
            Severity::Warning, "implicit.budget", 1,
            fmt::format("the function takes so long that the surface was looked for in steps of "
                        "{:.3g} mm only: smaller parts of it may be missing",
                        longest(at) / steps));
      }
      return s;
    } catch (const NoSurface&) {
      if (steps >= kSurveySteps) {
        if (auto s = found_by_more(look_in)) return std::move(*s);
      }
      throw;
    } catch (const TooMuchWork&) {
      // A function of many operations is looked at in fewer places.
    }
  }
  throw GeometryError(
      fmt::format("the surface is finer than {:.3g} mm or fills all of its domain, or the "
                  "function takes too long: give a smaller domain by `bounds` or simplify it",
                  2 * longest(at) / kSurveySteps));
}

ExactMesh mesh_surface(const Survey& survey, double step, WorkBudget budget, MeshCounts& counts,
                       const RunContext& context) {
  const Grid grid(*survey.function, make_layout(survey.box, step), budget, context);
  return mesh_grid(*survey.function, grid, longest(survey.box), survey.smallest, budget, counts,
                   context);
}

double choose_step(const Survey& survey, double tolerance, std::size_t max_triangles,
                   Diagnostics& diagnostics) {
  const double size = longest(survey.box);
  // Sagitta edge^2 / (8 r).
  const double wanted = std::sqrt(8 * survey.small_radius * tolerance) / kEdgePerStep;
  double step = std::min(wanted, size / kCoarsest);
  const double least =
      std::max(std::sqrt(kTrianglesPerStep * survey.area / static_cast<double>(max_triangles)),
               size / kFinestSteps);
  if (step < least) {
    step = std::min(least, size / kCoarsest);
    diagnostics.add(
        Severity::Info, "implicit.proxy_coarse", 1,
        fmt::format("the triangles that hide lines are {:.3g} mm long instead of {:.3g} mm, so "
                    "that there are not more than {}; lines and strokes are exact nevertheless",
                    step, wanted, max_triangles));
  }
  return step;
}

}  // namespace burin
