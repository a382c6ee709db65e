#include <burin/base/error.h>
#include <burin/forms/charted/analytic_chart.h>
#include <burin/forms/charted/place_mesh.h>
#include <burin/forms/charted/refine.h>

#include "body_volumes.h"
#include "charts/surface_chart.h"
#include "charts/unroll_wires.h"
#include "contain.h"
#include "model_parts.h"
#include "name_faces.h"
#include "shape_bounds.h"
#include "triangles/chart_mesh_builder.h"
#include "triangles/fill_wires.h"
#include "triangles/isolate.h"
#include "triangles/loose_faces.h"
#include "triangles/make_manifold.h"
#include "triangles/mesher.h"
#include "triangles/stray_faces.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <TopExp_Explorer.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace burin {
namespace {

/// Tolerances of which the triangles are kept: a sheet with several views asks for some.
constexpr std::size_t kKept = 4;

}  // namespace

struct BrepModel::Impl {
  struct Tessellation {
    double tolerance = 0;
    std::shared_ptr<const BrepTriangles> mesh;
    /// Faces without triangles, and with some of them.
    std::vector<std::int32_t> unmeshed, in_part;
    std::vector<std::uint8_t> loose;
    std::string reason;
    bool complete = true;  // within the tolerance, not ended by triangle_bound
  };

  ModelParts parts;
  std::vector<std::int32_t> face_body;
  ShapeBounds bounds;
  double size = 0;
  // OCCT keeps triangulations in the shape: one mesher at a time.
  std::mutex mutex;
  bool outward = false;
  std::deque<Tessellation> kept;

  const Tessellation& tessellate(double tolerance, const Atlas& atlas, RunContext& context);
  Tessellation make(double tolerance, const Atlas& atlas, RunContext& context);
  bool turn_outward(const RawMesh& raw);
};

BrepModel::BrepModel(const TopoDS_Shape& shape, const ChartMaker& make_chart, FirstNumbers first)
    : impl_(std::make_unique<Impl>()), first_(first) {
  ModelParts& parts = impl_->parts;
  const std::string failure = contained([&] {
    parts.shape = unroll_wires(BRepBuilderAPI_Copy(shape, false, false).Shape());
    collect_parts(parts, shape, make_chart ? make_chart : ChartMaker(make_surface_chart));
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
  // Loose faces have no triangle over a chart, but whoever lists all charts meets them.
  static const std::shared_ptr<const Chart> none = plane_chart({}, {Vec2(0), Vec2(1)});
  const ModelFace& f = impl_->parts.faces[static_cast<std::size_t>(face)];
  return f.chart ? *f.chart : *none;
}
bool BrepModel::reversed(std::int32_t face) const {
  return impl_->parts.faces[static_cast<std::size_t>(face)].reversed;
}
Vec2 BrepModel::on_coedge(std::int32_t coedge, double t) const {
  return impl_->parts.coedges[static_cast<std::size_t>(coedge)].curve.at(t);
}
double BrepModel::size() const { return impl_->size; }

/// Triangles of faces that have none together with the others: those that they came with, or of
/// their own. `unmeshed` keeps the faces for which there are none either.
LooseTriangles triangles_apart(const ModelParts& parts, std::vector<std::int32_t>& unmeshed,
                               double tolerance, RunContext& context) {
  LooseTriangles loose;
  std::erase_if(unmeshed, [&](std::int32_t f) {
    const ModelFace& face = parts.faces[static_cast<std::size_t>(f)];
    LooseTriangles found = face.given;
    if (found.empty()) found = mesh_alone(parts, f, tolerance, context);
    if (found.empty()) survived([&] { found = fill_wires(parts, f, tolerance); });
    if (face.reversed) {
      for (Triangle& t : found.triangles) std::swap(t[1], t[2]);
    }
    loose.append(found);
    return !found.empty();
  });
  return loose;
}

BrepModel::Impl::Tessellation BrepModel::Impl::make(double tolerance, const Atlas& atlas,
                                                    RunContext& context) {
  Tessellation made;
  made.tolerance = tolerance;
  made.in_part = mesh_shape(parts, tolerance, context);
  RawMesh raw = build_chart_mesh(parts, made.unmeshed);
  clear_mesh(parts);
  const std::vector<std::int32_t> none = made.unmeshed;
  LooseTriangles loose = triangles_apart(parts, made.unmeshed, tolerance, context);
  StrayFaces strays, found;
  const auto take_strays = [&] {
    strays.add(found);
    if (!found.marked.empty()) loose.append(take_loose(raw.mesh, found.marked, &raw.pole));
    return !found.marked.empty();
  };
  // Before the work, where the charts can be asked, and after it.
  survived([&] { found = find_stray_faces(raw, atlas, size, context); });
  take_strays();
  RawMesh refined;
  LooseTriangles parted;
  Isolated isolated;
  do {
    isolated = isolate(parts.faces.size(), [&](const std::vector<std::uint8_t>& out) {
      refined = raw;
      parted = take_loose(refined.mesh, out, &refined.pole);
      made.complete =
          refine(refined, make_manifold(refined.mesh, face_body), atlas,
                 {.tolerance = tolerance, .most = triangle_bound(size, tolerance)}, context);
      found = find_stray_faces(refined, atlas, size, context);
    });
  } while (take_strays());
  // What was taken apart before would still be turned in.
  if (turn_outward(refined)) return make(tolerance, atlas, context);
  made.loose = isolated.out;
  made.reason =
      !isolated.reason.empty() ? isolated.reason
      : !strays.marked.empty()
          ? fmt::format("their edges lie up to {:.3g} mm beside their surfaces", strays.distance)
          : "they cannot be meshed with their neighbours";
  for (std::size_t f = 0; f < strays.marked.size(); ++f) made.loose[f] |= strays.marked[f];
  std::erase_if(made.in_part,
                [&](std::int32_t f) { return std::ranges::find(none, f) != none.end(); });
  for (const std::int32_t f : none) made.loose[static_cast<std::size_t>(f)] = 1;
  for (const std::int32_t f : made.unmeshed) made.loose[static_cast<std::size_t>(f)] = 0;
  loose.append(parted);
  refined.mesh.normal.assign(refined.mesh.uv.size(), Vec3(0));
  refined.mesh.on_contour.assign(refined.mesh.uv.size(), 0);
  made.mesh = std::make_shared<const BrepTriangles>(
      BrepTriangles{std::move(refined.mesh), std::move(loose)});
  return made;
}

/// Once for a model: solids and closed shells of negative volume are turned inside out. Of a thin
/// wall only triangles that are near to both of its sides tell the sign. Whether any was turned.
bool BrepModel::Impl::turn_outward(const RawMesh& raw) {
  if (std::exchange(outward, true)) return false;
  std::vector<std::uint8_t> turned(parts.faces.size(), 0);
  const std::vector<double> volume = body_volumes(raw.mesh, face_body, parts.bodies.size());
  for (std::size_t b = 0; b < volume.size(); ++b) {
    if (volume[b] >= 0) continue;
    for (const std::int32_t f : parts.bodies[b]) turned[static_cast<std::size_t>(f)] = 1;
  }
  for (std::size_t f = 0; f < turned.size(); ++f) parts.faces[f].reversed ^= turned[f] != 0;
  return std::ranges::find(turned, 1) != turned.end();
}

const BrepModel::Impl::Tessellation& BrepModel::Impl::tessellate(double tolerance,
                                                                 const Atlas& atlas,
                                                                 RunContext& context) {
  for (const Tessellation& t : kept) {
    if (t.tolerance == tolerance) return t;
  }
  if (kept.size() == kKept) kept.pop_front();
  kept.push_back(make(tolerance, atlas, context));
  return kept.back();
}

std::shared_ptr<const BrepTriangles> BrepModel::tessellate(double tolerance, RunContext& context,
                                                           Diagnostics* diagnostics) const {
  std::unique_lock lock(impl_->mutex, std::defer_lock);
  while (!lock.try_lock()) {  // no wait with a limit: ThreadSanitizer of clang 14 does not know it
    context.check();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const Impl::Tessellation& t = impl_->tessellate(tolerance, *this, context);
  if (t.mesh->triangles.empty() && t.mesh->loose.empty()) {
    throw GeometryError("none of the faces could be turned into triangles; repair the shape");
  }
  name_loose_faces(t.loose, t.reason, *this, diagnostics);
  if (diagnostics && !t.unmeshed.empty()) {
    diagnostics->add(Severity::Warning, "brep.face_not_meshed",
                     static_cast<std::int64_t>(t.unmeshed.size()),
                     "left out, because OCCT cannot mesh them: " + face_list(t.unmeshed, *this));
  }
  if (diagnostics && !t.in_part.empty()) {
    diagnostics->add(
        Severity::Warning, "brep.face_in_part", static_cast<std::int64_t>(t.in_part.size()),
        "drawn in part, because OCCT cannot mesh them whole: " + face_list(t.in_part, *this));
  }
  if (diagnostics && !t.complete) {
    add_triangles_bounded(*diagnostics, t.mesh->triangles.size(), t.mesh->tolerance, tolerance);
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

std::shared_ptr<const BrepModel> make_brep_model(const TopoDS_Shape& shape, FirstNumbers first) {
  return std::make_shared<const BrepModel>(shape, ChartMaker(), first);
}

}  // namespace burin
