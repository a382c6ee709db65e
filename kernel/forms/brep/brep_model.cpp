#include <burin/base/error.h>

#include "chart_mesh_builder.h"
#include "contain.h"
#include "make_manifold.h"
#include "mesher.h"
#include "model_parts.h"
#include "refine.h"
#include "shape_bounds.h"
#include "turn_triangles.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <TopExp_Explorer.hxx>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <deque>
#include <utility>

namespace burin {
namespace {

/// Tolerances of which the triangles are kept: a sheet with several views asks for some.
constexpr std::size_t kKept = 4;

struct Tessellation {
  double tolerance = 0;
  std::shared_ptr<const ChartMesh> mesh;
  std::vector<std::int32_t> unmeshed;
};

}  // namespace

struct BrepModel::Impl {
  ModelParts parts;
  std::vector<std::int32_t> face_body;
  ShapeBounds bounds;
  double size = 0;
  // OCCT keeps triangulations in the shape: one mesher at a time.
  std::timed_mutex mutex;
  bool outward = false;
  std::deque<Tessellation> kept;

  const Tessellation& tessellate(double tolerance, const Atlas& atlas, RunContext& context);
  Tessellation make(double tolerance, const Atlas& atlas, RunContext& context);
  void turn_outward(RawMesh& raw);
};

BrepModel::BrepModel(const TopoDS_Shape& shape) : impl_(std::make_unique<Impl>()) {
  ModelParts& parts = impl_->parts;
  const std::string failure = contained([&] {
    parts.shape = BRepBuilderAPI_Copy(shape, false, false).Shape();
    collect_parts(parts);
  });
  if (!failure.empty()) {
    throw GeometryError(
        fmt::format("the shape is broken (OCCT: {}); repair it and export it again", failure));
  }
  if (parts.faces.empty()) throw GeometryError("the shape has no faces; there is nothing to draw");
  orient_faces(parts);
  parts.edge_class = classify_edges(parts);
  impl_->face_body.assign(parts.faces.size(), -1);
  for (std::size_t b = 0; b < parts.bodies.size(); ++b) {
    for (const std::int32_t f : parts.bodies[b]) {
      std::int32_t& body = impl_->face_body[static_cast<std::size_t>(f)];
      if (body < 0) body = static_cast<std::int32_t>(b);
    }
  }
  impl_->bounds = ShapeBounds(parts);
  impl_->size = bounds(Mat3(1)).diagonal();
}

BrepModel::~BrepModel() = default;

const TopoDS_Shape& BrepModel::shape() const { return impl_->parts.shape; }
std::size_t BrepModel::face_count() const { return impl_->parts.faces.size(); }
const Chart& BrepModel::chart(std::int32_t face) const {
  return *impl_->parts.faces[static_cast<std::size_t>(face)].chart;
}
bool BrepModel::reversed(std::int32_t face) const {
  return impl_->parts.faces[static_cast<std::size_t>(face)].reversed;
}
Vec2 BrepModel::on_coedge(std::int32_t coedge, double t) const {
  return impl_->parts.coedges[static_cast<std::size_t>(coedge)].curve.at(t);
}
double BrepModel::size() const { return impl_->size; }

Tessellation BrepModel::Impl::make(double tolerance, const Atlas& atlas, RunContext& context) {
  Tessellation made;
  made.tolerance = tolerance;
  mesh_shape(parts, tolerance, context);
  RawMesh raw = build_chart_mesh(parts, made.unmeshed);
  clear_mesh(parts);
  turn_outward(raw);
  refine(raw, make_manifold(raw.mesh, face_body), atlas, tolerance, context);
  raw.mesh.normal.assign(raw.mesh.uv.size(), Vec3(0));
  raw.mesh.on_contour.assign(raw.mesh.uv.size(), 0);
  made.mesh = std::make_shared<const ChartMesh>(std::move(raw.mesh));
  return made;
}

/// Once for a model: solids and closed shells of negative volume are turned inside out.
void BrepModel::Impl::turn_outward(RawMesh& raw) {
  if (std::exchange(outward, true)) return;
  std::vector<std::uint8_t> turned(parts.faces.size(), 0);
  const std::vector<double> volume = body_volumes(raw.mesh, face_body, parts.bodies.size());
  for (std::size_t b = 0; b < volume.size(); ++b) {
    if (volume[b] >= 0) continue;
    for (const std::int32_t f : parts.bodies[b]) turned[static_cast<std::size_t>(f)] = 1;
  }
  for (std::size_t f = 0; f < turned.size(); ++f) parts.faces[f].reversed ^= turned[f] != 0;
  turn_triangles(raw.mesh, turned, raw.pole);
}

const Tessellation& BrepModel::Impl::tessellate(double tolerance, const Atlas& atlas,
                                                RunContext& context) {
  for (const Tessellation& t : kept) {
    if (t.tolerance == tolerance) return t;
  }
  if (kept.size() == kKept) kept.pop_front();
  kept.push_back(make(tolerance, atlas, context));
  return kept.back();
}

std::shared_ptr<const ChartMesh> BrepModel::tessellate(double tolerance, RunContext& context,
                                                       Diagnostics* diagnostics) const {
  std::unique_lock lock(impl_->mutex, std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(20))) context.check();
  const Tessellation& t = impl_->tessellate(tolerance, *this, context);
  if (t.mesh->triangles.empty()) {
    throw GeometryError("none of the faces could be turned into triangles; repair the shape");
  }
  if (diagnostics && !t.unmeshed.empty()) {
    diagnostics->add(Severity::Warning, "brep.face_not_meshed",
                     static_cast<std::int64_t>(t.unmeshed.size()),
                     fmt::format("left out, because OCCT cannot mesh them: face{} {}",
                                 t.unmeshed.size() > 1 ? "s" : "", fmt::join(t.unmeshed, ", ")));
  }
  return t.mesh;
}

Box3 BrepModel::bounds(const Mat3& axes) const { return impl_->bounds.box(impl_->parts, axes); }

BrepCounts BrepModel::counts() const {
  const ModelParts& parts = impl_->parts;
  BrepCounts n;
  for (TopExp_Explorer s(parts.shape, TopAbs_SOLID); s.More(); s.Next()) ++n.solids;
  for (TopExp_Explorer s(parts.shape, TopAbs_SHELL); s.More(); s.Next()) ++n.shells;
  n.faces = static_cast<std::int64_t>(parts.faces.size());
  n.edges = static_cast<std::int64_t>(parts.edges.size());
  for (std::size_t e = 0; e < parts.edges.size(); ++e) {
    const ModelEdge& edge = parts.edges[e];
    n.free_edges += edge.coedges.size() == 1 && !edge.degenerate &&
                    parts.edge_class[e] == ModelEdgeClass::Boundary;
  }
  n.closed = n.free_edges == 0;
  return n;
}

std::shared_ptr<const BrepModel> make_brep_model(const TopoDS_Shape& shape) {
  return std::make_shared<const BrepModel>(shape);
}

}  // namespace burin
