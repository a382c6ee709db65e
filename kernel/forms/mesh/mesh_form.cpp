#include <burin/base/parallel.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/curvature.h>
#include <burin/mesh/placed_mesh.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/reorder.h>
#include <burin/mesh/straight_corners.h>

#include "mesh_surface.h"
#include "round_facets.h"

#include <numeric>

namespace burin {

namespace {

/// Triangles that rounding may add: on a sheet of A4 full of them each is 0.3 mm wide.
constexpr std::size_t kMostPieces = 1'500'000;

/// Of the tolerance. Contours run where triangles turn away, which is off by more than their chords
/// are: with the whole of it twice the length of lines is contradicted by rays.
constexpr double kShare = 0.5;

void report_cut_short(Diagnostics& diagnostics) {
  diagnostics.add(
      Severity::Warning, "mesh.rounded_coarsely", 1,
      "facets of a mesh stay coarser than the sheet could show: an edge is halved at "
      "most eight times, and at most 1.5 million triangles are added; give a finer mesh");
}

/// The curvature of a mesh at places of it.
std::vector<Curvature> curvature_at(const MeshSurface& surface,
                                    const std::vector<ProxyPoint>& places,
                                    const RunContext& context) {
  constexpr std::size_t kGrain = 4096;
  std::vector<Curvature> out(places.size());
  parallel_for(
      places.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Frame f = surface.frame(surface.lift(places[i]));
          out[i] = {f.k1, f.k2, f.d1, f.d2, f.confidence};
        }
      },
      &context);
  return out;
}

}  // namespace

Box3 MeshForm::bounds(const Mat3& axes) const {
  // GLM stores columns: the rows of `axes` are the columns of its transpose, so v * axes^T = axes
  // v.
  const Vec3 x(axes[0][0], axes[1][0], axes[2][0]), y(axes[0][1], axes[1][1], axes[2][1]),
      z(axes[0][2], axes[1][2], axes[2][2]);
  Box3 box;
  for (const Vec3& p : mesh_.positions)
    box.add(Vec3(glm::dot(x, p), glm::dot(y, p), glm::dot(z, p)));
  return box;
}

std::shared_ptr<const Surface> MeshForm::realise(const RealiseOptions& options,
                                                 RunContext& context) const {
  return textured(realise_mesh(options, context), texture_);
}

std::shared_ptr<const Form> MeshForm::mapped(const Placement& by) const {
  return std::make_shared<MeshForm>(placed(mesh_, by), texture_ ? texture_->mapped(by) : nullptr,
                                    faces_);
}

ShapeMeasure MeshForm::measure(RunContext& context) const {
  return shape_measure(build_proxy(mesh_, {}, context));
}

std::shared_ptr<const Surface> MeshForm::realise_mesh(const RealiseOptions& options,
                                                      RunContext& context) const {
  context.begin_stage(RunStage::Build);
  TriMesh mesh = mesh_;
  if (!faces_) {  // faces are numbered by triangle
    if (!texture_) {
      remove_straight_corners(mesh, {.crease_angle = options.crease_angle}, context);
    }
    reorder_for_cache(mesh);
  }
  const ProxyOptions proxy_options{.crease_angle = options.crease_angle};
  ProxyMesh proxy = build_proxy(std::move(mesh), proxy_options, context);
  if (faces_) proxy.source_face = *faces_;
  auto surface = make_rounded_surface(std::move(proxy), {}, options, context).surface;
  context.end_stage();
  return surface;
}

RoundedSurface make_rounded_surface(ProxyMesh proxy, std::span<const std::uint8_t> exact,
                                    const RealiseOptions& options, RunContext& context) {
  auto rounded = round_facets(proxy, kShare * options.tolerance, kMostPieces, context, exact);
  if (rounded && rounded->cut_short && options.diagnostics) report_cut_short(*options.diagnostics);
  std::vector<Curvature> curvature;
  if (options.curvature) {
    context.begin_stage(RunStage::Curvature);
    curvature = estimate_curvature(proxy, {}, context);
  }
  if (!rounded) {
    std::vector<std::uint32_t> own(proxy.mesh.triangles.size());
    std::iota(own.begin(), own.end(), 0U);
    return {make_mesh_surface(std::move(proxy), curvature), std::move(own)};
  }
  if (options.curvature) {
    curvature =
        curvature_at(MeshSurface(std::move(proxy), curvature), rounded->wedge_origin, context);
  }
  return {std::make_shared<MeshSurface>(std::move(rounded->proxy), curvature, true),
          std::move(rounded->face_origin)};
}

std::shared_ptr<const Surface> make_mesh_surface(ProxyMesh proxy,
                                                 const std::vector<Curvature>& curvature) {
  return std::make_shared<MeshSurface>(std::move(proxy), curvature);
}

}  // namespace burin
