#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/surface/tangent_basis.h>

#include "../function/mapped_function.h"
#include "../function/project.h"
#include "../function/shape_operator.h"
#include "../mesher/delaunay/delaunay_mesher.h"
#include "../mesher/draft.h"
#include "../mesher/losses.h"
#include "../mesher/mesher.h"
#include "implicit_surface.h"
#include "view_cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace burin {
namespace {

// Paper mm that chords of contours may be off.
constexpr double kContourChord = 0.005;
// Nanoseconds of one core.
constexpr double kMeshBudget = 6e9, kContourBudget = 4e9;

// The farthest point of the surface in a direction, from the vertex that lies farthest: Newton for
// the place where the normal is the direction.
double support(const Survey& s, Vec3 start, Vec3 direction) {
  constexpr int kSteps = 6;
  const ImplicitFunction& f = s.function->piece_function(start);
  Vec3 p = start;
  for (int i = 0; i < kSteps; ++i) {
    const Gradient2 g = f.hessian(p);
    const Frame frame = implicit_frame(g, p, Vec3(0), 1e6 * s.mesh.size);
    const double up = glm::dot(frame.normal, direction);
    Vec3 step(0);
    for (const auto& [k, d] : {std::pair(frame.k1, frame.d1), std::pair(frame.k2, frame.d2)}) {
      if (k * up > 0) step += glm::dot(d, direction) / (k * up) * d;
    }
    if (!(glm::length(step) <= s.mesh.step)) return glm::dot(start, direction);
    const auto q = onto_surface(f, p + step, 2 * s.mesh.step, s.mesh.accuracy);
    if (!q) return glm::dot(start, direction);
    p = *q;
  }
  const bool real = std::abs(s.function->value(p)) <=
                        1e-9 * s.mesh.size * glm::length(s.function->gradient(p).gradient) &&
                    glm::distance(p, start) <= 2 * s.mesh.step;
  return real ? std::max(glm::dot(p, direction), glm::dot(start, direction))
              : glm::dot(start, direction);
}

// The vertices of triangles, each once, in the order in which triangles name them.
std::vector<Vec3> corners_of(const ExactMesh& mesh) {
  std::vector<Vec3> corners;
  std::vector<char> known(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      if (std::exchange(known[v], 1) == 0) corners.push_back(mesh.positions[v]);
    }
  }
  return corners;
}

// For what a mesh has lost: a share of what it has taken.
WorkBudget lost_budget(const ExactMesh& mesh) {
  constexpr double kShare = 0.2, kLeast = 1e8;
  return WorkBudget(std::max(kLeast, kShare * (kMeshBudget - mesh.budget.left())));
}

// As fine as wanted, or else as fine as it can be had.
ExactMesh affordable_mesh(const Survey& s, double step, MeshCounts& counts,
                          Diagnostics& diagnostics, const RunContext& context) {
  constexpr double kCoarser = 1.7;
  for (double at = step;; at *= kCoarser) {
    const bool coarse = at >= s.mesh.step;
    std::optional<ExactMesh> mesh;
    counts = {};
    try {
      mesh = coarse && at > step ? s.mesh
                                 : mesh_surface(s, at, WorkBudget(kMeshBudget), counts, context);
    } catch (const TooMuchWork&) {
      if (coarse) mesh = s.mesh;
    }
    if (!mesh) continue;
    if (mesh->step > step) {
      diagnostics.add(
          Severity::Warning, "implicit.budget", 1,
          fmt::format("the function takes so long that the triangles that hide lines are {:.3g} mm "
                      "long instead of {:.3g} mm",
                      mesh->step, step));
    }
    return std::move(*mesh);
  }
}

// The least that a tangent at a right angle to the unit vector `normal` grows.
double least_stretch(const Placement& placement, Vec3 normal) {
  const TangentBasis basis(normal);
  const Vec3 x = placement.vector(basis.x), y = placement.vector(basis.y);
  const double a = glm::dot(x, x), b = glm::dot(x, y), c = glm::dot(y, y);
  const double larger = 0.5 * (a + c) + std::hypot(0.5 * (a - c), b);
  return std::sqrt(std::max(a * c - b * b, 0.0) / larger);
}

// The mesh of a function where `placement` takes it: with what is written of pieces of `function`.
ExactMesh placed(ExactMesh mesh, const Placement& placement, const MappedFunction& function) {
  const double most = stretch(placement);
  const auto pieces = [&](const ImplicitFunction*& piece) {
    if (piece) piece = &function.mapped(*piece);
  };
  const Mat3 turned = glm::transpose(glm::inverse(placement.linear));
  const auto turn = [&](Vec3& normal) { normal = normalize_or(turned * normal, Vec3(0)); };
  if (!is_similar(placement)) {
    // Triangles are narrower one way: vertices that are drawn onto contours keep to that.
    std::vector<double> spacing;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      spacing.push_back(mesh.step_at(v) * least_stretch(placement, mesh.normals[v]));
    }
    mesh.spacing = std::move(spacing);
  } else {
    for (double& s : mesh.spacing) s *= most;
  }
  Box3 box;
  for (Vec3& p : mesh.positions) box.add(p = placement.point(p));
  for (Vec3& n : mesh.normals) turn(n);
  for (CreaseVertex& crease : mesh.creases) {
    for (CreaseVertex::Side& side : crease.sides) pieces(side.piece), turn(side.normal);
  }
  for (const ImplicitFunction*& side : mesh.side) pieces(side);
  if (placement.mirrors()) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  mesh.step *= most, mesh.accuracy *= most;
  mesh.size = box.diagonal();
  return mesh;
}

// Triangles off the surface: what is thinner than a step, and was not seen whole.
struct Misses {
  std::int64_t triangles = 0;
  double farthest = 0, sum = 0;  // model mm
};

Misses find_misses(const ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context) {
  constexpr double kOff = 0.15;  // steps: a chord of a bend as narrow as a step
  Misses m;
  if (!f.has_pieces()) return m;
  for (const double d : deviations(mesh, f, context)) {
    if (d <= kOff * mesh.step) continue;
    ++m.triangles;
    m.farthest = std::max(m.farthest, d);
    m.sum += d;
  }
  return m;
}

}  // namespace

struct ImplicitForm::Impl {
  Survey survey;
  /// The vertices of its triangles, each once: bounds are asked for again and again.
  std::vector<Vec3> corners;
  ImplicitProxyOptions options;

  ExactMesh mesh(double tolerance, MeshCounts& counts, Diagnostics& diagnostics,
                 RunContext& context) const;

 private:
  ExactMesh nets(double step, MeshCounts& counts, Diagnostics& diagnostics,
                 const RunContext& context) const;
};

// Whether a wedge shows in a grid depends on where the grid's planes lie: where it does not, grids
// of other steps are tried.
ExactMesh ImplicitForm::Impl::nets(double step, MeshCounts& counts, Diagnostics& diagnostics,
                                   const RunContext& context) const {
  ExactMesh best = affordable_mesh(survey, step, counts, diagnostics, context);
  Misses misses = find_misses(best, *survey.function, context);
  WorkBudget budget = best.budget;
  const double first = best.step, triangles = static_cast<double>(best.triangles.size());
  for (const double times : {0.9, 0.8, 1.2}) {
    if (misses.triangles == 0) break;
    if (triangles > times * times * static_cast<double>(options.max_triangles)) continue;
    MeshCounts own;
    try {
      ExactMesh other = mesh_surface(survey, times * first, budget, own, context);
      budget = other.budget;
      const Misses left = find_misses(other, *survey.function, context);
      if (left.sum >= misses.sum) continue;
      best = std::move(other);
      misses = left;
      counts = own;
    } catch (const TooMuchWork&) {
      break;
    }
  }
  if (misses.triangles > 0) {
    diagnostics.add(
        Severity::Warning, "implicit.thin", misses.triangles,
        fmt::format("triangles beside wedges and ribs that are thinner than a triangle lie up to "
                    "{:.2g} mm off the surface: lines there may be off by as much; `mesher "
                    "delaunay` may find them",
                    misses.farthest));
  }
  return best;
}

ExactMesh ImplicitForm::Impl::mesh(double tolerance, MeshCounts& counts, Diagnostics& diagnostics,
                                   RunContext& context) const {
  Diagnostics of_nets;
  const double step = choose_step(survey, tolerance, options.max_triangles, of_nets);
  bool graded = options.mesher == Mesher::Delaunay;
  if (options.mesher == Mesher::Auto && !of_nets.empty()) {
    // More would take longer than the drawing.
    constexpr double kQuick = 0.25;
    graded = 2 * delaunay_outlook(survey, tolerance, context).vertices <=
             kQuick * static_cast<double>(options.max_triangles);
  }
  if (graded) {
    try {
      auto made =
          mesh_delaunay(survey, tolerance, options.max_triangles, counts, diagnostics, context);
      if (made) return std::move(*made);
    } catch (const TooMuchWork&) {
    }
    counts = {};
  }
  diagnostics.append(of_nets);
  return nets(step, counts, diagnostics, context);
}

ImplicitForm::ImplicitForm(std::shared_ptr<const ImplicitFunction> function,
                           std::optional<Box3> domain, const RunContext& context,
                           double smallest_part, const ImplicitProxyOptions& proxy) {
  if (!(smallest_part >= 0 && smallest_part < 1)) {
    throw UsageError("the smallest part is a share from 0 to below 1 of the largest one");
  }
  const std::shared_ptr<const ImplicitFunction> shared = std::move(function);
  const Box3 own = shared->bounds();
  auto impl = std::make_unique<Impl>();
  impl->options = proxy;
  if (!domain) {
    for (int a = 0; a < 3; ++a) {
      if (!std::isfinite(own.min[a]) || !std::isfinite(own.max[a])) {
        throw GeometryError(
            "the function has no bounds of its own; give its domain by `bounds "
            "x0,y0,z0,x1,y1,z1`");
      }
      if (!(own.min[a] < own.max[a])) {
        throw GeometryError(
            "the function is nowhere negative: there is no surface; check the formula, and whether "
            "solids that are to be cut meet");
      }
    }
  }
  impl->survey = survey(shared, domain.value_or(own), domain.has_value(), smallest_part, context);
  impl->corners = corners_of(impl->survey.mesh);
  impl_ = std::move(impl);
}

ImplicitForm::ImplicitForm(std::shared_ptr<const Impl> impl, const Placement& placement)
    : impl_(std::move(impl)), placement_(placement) {}
ImplicitForm::~ImplicitForm() = default;

std::shared_ptr<const Form> ImplicitForm::mapped(const Placement& by) const {
  return std::shared_ptr<const Form>(new ImplicitForm(impl_, after(by, placement_)));
}

Box3 ImplicitForm::bounds(const Mat3& axes) const {
  Box3 box = bounds_as_read(axes * placement_.linear);
  const Vec3 shift = axes * placement_.offset;
  box.min += shift, box.max += shift;
  return box;
}

Box3 ImplicitForm::bounds_as_read(const Mat3& axes) const {
  const Survey& s = impl_->survey;
  Box3 box;
  for (int a = 0; a < 3; ++a) {
    const Vec3 row(axes[0][a], axes[1][a], axes[2][a]);
    const auto along = [&](const Vec3& p) { return glm::dot(p, row); };
    const Vec3 low = std::ranges::min(impl_->corners, {}, along);
    const Vec3 high = std::ranges::max(impl_->corners, {}, along);
    const double length = glm::length(row);
    box.min[a] = -support(s, low, -row / length) * length;
    box.max[a] = support(s, high, row / length) * length;
  }
  return box;
}

std::shared_ptr<const Surface> ImplicitForm::realise(const RealiseOptions& options,
                                                     RunContext& context) const {
  context.begin_stage(RunStage::Build);
  const Survey& s = impl_->survey;
  Diagnostics diagnostics = s.diagnostics;
  MeshCounts counts;
  const double tolerance = options.tolerance / stretch(placement_);
  ExactMesh mesh = impl_->mesh(tolerance, counts, diagnostics, context);
  Unseen unseen = s.unseen;
  if (s.smallest == 0 && !add_lost_pieces(mesh, s, tolerance, lost_budget(mesh), context)) {
    constexpr double kLost = 6;  // steps, as losses.cpp looks for
    if (kLost * mesh.step > unseen.below)
      unseen = {kLost * mesh.step, "there are too many to mesh"};
  }
  if (unseen.below > 0) {
    diagnostics.add(
        unseen.severity, "implicit.may_miss", 1,
        fmt::format("pieces of the surface smaller or thinner than {:.2g} mm may be missing: {}; "
                    "`bounds` around a part of the surface finds smaller ones",
                    unseen.below * stretch(placement_), unseen.why));
  }
  std::shared_ptr<const ImplicitFunction> function = s.function;
  if (placement_.moves()) {
    auto there = std::make_shared<const MappedFunction>(s.function, placement_);
    mesh = placed(std::move(mesh), placement_, *there);
    function = std::move(there);
  }
  if (counts.strays > 0) {
    diagnostics.add(Severity::Warning, "implicit.not_on_surface",
                    static_cast<std::int64_t>(counts.strays),
                    "places where the function jumps or has no slope: the surface is not exact "
                    "there");
  }
  if (counts.specks > 0) {
    diagnostics.add(Severity::Info, "implicit.specks", static_cast<std::int64_t>(counts.specks),
                    fmt::format("components smaller than {:.3g} mm were left out", s.smallest));
  }
  if (options.view) {
    try {
      mesh.budget = WorkBudget(kContourBudget);
      cut_for_view(mesh, *function, *options.view, kContourChord, context);
    } catch (const TooMuchWork&) {
      diagnostics.add(Severity::Warning, "implicit.budget", 1,
                      "the contours are too many to be found exactly: they follow the triangles");
    }
  }
  ProxyMesh proxy = assemble_proxy(make_draft(mesh, *function, context), context);
  if (options.diagnostics) options.diagnostics->append(diagnostics);
  context.end_stage();
  return std::make_shared<ImplicitSurface>(function, std::move(proxy), std::move(mesh.side),
                                           mesh.step, mesh.size);
}

}  // namespace burin
