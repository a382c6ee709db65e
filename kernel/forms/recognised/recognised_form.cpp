#include <burin/base/affine.h>
#include <burin/contour_cut/contour_cut.h>
#include <burin/forms/charted/atlas_sampler.h>
#include <burin/forms/charted/charted_surface.h>
#include <burin/forms/charted/place_mesh.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/mesh/placed_mesh.h>
#include <burin/mesh/tips.h>

#include "facet_atlas.h"
#include "known.h"
#include "outermost.h"
#include "recognised_surface.h"
#include "walls.h"

#include <algorithm>
#include <set>
#include <utility>

namespace burin {

namespace {

/// The mesh where it was read, with the creases that it has where it stands: of other angles, where
/// it is stretched.
ProxyMesh with_placed_creases(const TriMesh& mesh, const Placement& placement,
                              const ProxyOptions& options, const RunContext& context) {
  if (is_similar(placement)) return build_proxy(mesh, options, context);
  // A mirror image has the same angles, and its triangles would run the other way.
  Placement by = placement;
  if (by.mirrors()) by.linear = -by.linear;
  ProxyMesh proxy = build_proxy(placed(mesh, by), options, context);
  proxy.mesh.positions = mesh.positions;
  const Placement back = inverse(by);
  for (Vec3& n : proxy.wedge_normal) n = placed_normal(back, n);
  return proxy;
}

/// Every triangle lies on a chart.
std::shared_ptr<const Surface> charted(recognised::FacetAtlas made, const Placement& placement,
                                       const RealiseOptions& options, const RunContext& context) {
  if (placement.moves()) made.mesh = placed(made.mesh, placement);
  Box3 box;
  for (const Vec3& p : made.mesh.positions) box.add(p);
  const PlacedAtlas atlas{made.atlas, placement, box.diagonal()};
  const bool found = !options.view ||
                     cut_along_contours(made.mesh, AtlasSampler(atlas), *options.view, {}, context);
  if (!found && options.diagnostics) add_contours_bounded(*options.diagnostics);
  return make_charted_surface(atlas, std::move(made.mesh), context);
}

/// Vertices and facets of the input that meet at tips.
using Tips = std::set<std::pair<std::uint32_t, std::int32_t>>;

Tips tips_of(const ProxyMesh& input, const recognised::Facets& facets) {
  Tips out;
  const std::vector<std::uint8_t> tips = wedges_at_tips(input);
  if (tips.empty()) return out;
  for (std::size_t t = 0; t < input.wedges.size(); ++t) {
    for (const std::uint32_t w : input.wedges[t]) {
      if (tips[w]) out.emplace(input.wedge_vertex[w], facets.of[t]);
    }
  }
  return out;
}

/// Parts the wedges of a proxy at tips, by the facets of its triangles.
void part_tips(ProxyMesh& proxy, const Tips& tips, const std::vector<std::int32_t>& facet) {
  std::vector<std::uint32_t> label(proxy.edge_kind.size(), 0);
  for (std::size_t h = 0; h < label.size(); ++h) {
    const std::uint32_t vertex = proxy.mesh.triangles[h / 3][h % 3];
    const std::int32_t f = facet[h / 3];
    if (f >= 0 && tips.contains({vertex, f})) label[h] = 1 + static_cast<std::uint32_t>(f);
  }
  part_wedges(proxy, label, [&](HalfEdge h) {
    return proxy.mesh.area(face_of(h)) * proxy.mesh.normal(face_of(h));
  });
}

/// Some facets stand for nothing that is known: the triangles are the surface, those of such facets
/// divided as MeshForm does, and contours are those of a mesh everywhere, so that one part has one
/// kind of contours.
std::shared_ptr<const Surface> partly_charted(recognised::FacetAtlas made,
                                              std::shared_ptr<const recognised::Recognised> round,
                                              const Tips& tips, const Placement& placement,
                                              const RealiseOptions& options, RunContext& context) {
  if (placement.moves()) made.mesh = placed(made.mesh, placement);
  std::vector<std::int32_t> patch, facet;
  for (const std::int32_t f : made.mesh.face) {
    patch.push_back(made.patch[static_cast<std::size_t>(f)]);
    facet.push_back(patch.back() < 0 ? made.facet[static_cast<std::size_t>(f)] : -1);
  }
  ProxyMesh proxy = assemble_proxy(proxy_draft(made.mesh, *made.atlas), context);
  made = {};
  proxy.on_contour.clear();
  if (!tips.empty()) part_tips(proxy, tips, facet);
  std::vector<std::uint8_t> exact;
  for (const std::int32_t p : patch) exact.push_back(p >= 0);
  RoundedSurface rounded = make_rounded_surface(std::move(proxy), exact, options, context);
  std::vector<std::int32_t> of;
  for (const std::uint32_t t : rounded.face_origin) of.push_back(patch[t]);
  return std::make_shared<recognised::RecognisedSurface>(
      std::move(rounded.surface), std::move(round), std::move(of), placement);
}

}  // namespace

struct RecognisedForm::Impl {
  Impl(TriMesh mesh, std::shared_ptr<const TextureMap> texture,
       std::shared_ptr<const std::vector<std::int32_t>> given)
      : form(std::move(mesh), std::move(texture), std::move(given)) {}

  MeshForm form;
  std::shared_ptr<const recognised::Facets> facets;
  std::shared_ptr<const recognised::Recognised> round;
  RecognisedFaces faces;
  bool too_coarse = false;
  /// Of a mesh without round faces: whether it has walls all the same, and no rounding.
  bool walls = false;

  bool is_mesh() const { return faces.total() == 0 && !walls; }
};

RecognisedForm::RecognisedForm(TriMesh mesh, const RunContext& context,
                               std::shared_ptr<const TextureMap> texture,
                               std::shared_ptr<const std::vector<std::int32_t>> faces)
    : impl_(std::make_shared<Impl>(std::move(mesh), std::move(texture), std::move(faces))) {
  const TriMesh& m = impl_->form.mesh();
  const Topology topology = build_topology(m, context);
  impl_->facets =
      std::make_shared<const recognised::Facets>(recognised::find_facets(m, topology, context));
  // Of the size: the sagitta of 48 facets around a cylinder of a quarter of it is 30 times as much.
  constexpr double kMostNoise = 2e-5;
  impl_->too_coarse = impl_->facets->noise > kMostNoise * m.bounds().diagonal();
  if (impl_->too_coarse) return;
  impl_->round = std::make_shared<const recognised::Recognised>(recognised::join_profiles(
      m, *impl_->facets, recognised::find_bands(m, *impl_->facets, context), context));
  impl_->faces = recognised::count_faces(m, topology, *impl_->facets, *impl_->round);
}
RecognisedForm::RecognisedForm(TriMesh mesh, const KnownSurfaces& known, const RunContext& context)
    : impl_(std::make_shared<Impl>(std::move(mesh), nullptr, nullptr)) {
  const TriMesh& m = impl_->form.mesh();
  const Topology topology = build_topology(m, context);
  recognised::KnownFacets found = recognised::known_facets(m, topology, known, context);
  impl_->facets = std::make_shared<const recognised::Facets>(std::move(found.facets));
  impl_->round = std::make_shared<const recognised::Recognised>(
      recognised::join_profiles(m, *impl_->facets, std::move(found.bands), context));
  impl_->faces = recognised::count_faces(m, topology, *impl_->facets, *impl_->round);
  const auto flat = [](std::int32_t s) { return s == KnownSurfaces::kMeantFlat; };
  if (impl_->faces.total() > 0 || !std::ranges::all_of(known.of, flat)) return;
  const recognised::Walls walls(with_placed_creases(m, {}, {}, context), *impl_->facets,
                                *impl_->round);
  bool any_wall = false, any_rounding = false;
  for (std::size_t f = 0; f < impl_->facets->list.size(); ++f) {
    any_wall = any_wall || walls.is_wall(static_cast<std::int32_t>(f));
    any_rounding = any_rounding || walls.goes_on(static_cast<std::int32_t>(f));
  }
  // Facets of a rounding that nothing recognises are divided by MeshForm alone.
  impl_->walls = any_wall && !any_rounding;
}
RecognisedForm::RecognisedForm(std::shared_ptr<Impl> impl, const Placement& placement)
    : impl_(std::move(impl)), placement_(placement) {}
RecognisedForm::~RecognisedForm() = default;

std::shared_ptr<const Form> RecognisedForm::mapped(const Placement& by) const {
  const Placement place = after(by, placement_);
  if (impl_->is_mesh()) return impl_->form.mapped(place);
  return std::shared_ptr<const Form>(new RecognisedForm(impl_, place));
}

const TriMesh& RecognisedForm::mesh() const { return impl_->form.mesh(); }
RecognisedFaces RecognisedForm::faces() const { return impl_->faces; }

bool RecognisedForm::is_mesh() const { return impl_->is_mesh(); }

bool RecognisedForm::too_coarse() const { return impl_->too_coarse; }

ShapeMeasure RecognisedForm::measure(RunContext& context) const {
  if (placement_.moves()) return impl_->form.mapped(placement_)->measure(context);
  return impl_->form.measure(context);
}

Box3 RecognisedForm::bounds(const Mat3& axes) const {
  Box3 box = bounds_as_read(axes * placement_.linear);
  const Vec3 shift = axes * placement_.offset;
  box.min += shift, box.max += shift;
  return box;
}

Box3 RecognisedForm::bounds_as_read(const Mat3& axes) const {
  Box3 box = impl_->form.bounds(axes);
  if (impl_->faces.total() == 0) return box;
  constexpr double kChord = 2e-4;  // of the size
  recognised::add_outermost(box, axes, mesh(), *impl_->round, *impl_->facets,
                            kChord * mesh().bounds().diagonal(), RunContext());
  return box;
}

std::shared_ptr<const Surface> RecognisedForm::realise(const RealiseOptions& options,
                                                       RunContext& context) const {
  if (impl_->is_mesh()) return impl_->form.realise(options, context);
  context.begin_stage(RunStage::Build);
  const ProxyOptions proxy_options{.crease_angle = options.crease_angle};
  const ProxyMesh input = with_placed_creases(mesh(), placement_, proxy_options, context);
  const double tolerance = options.tolerance / stretch(placement_);
  recognised::Faces faces = recognised::find_faces(input, *impl_->facets, *impl_->round);
  recognised::FacetMesh refined = faces.mesh;
  if (impl_->form.faces()) refined.source = *impl_->form.faces();
  recognised::refine(refined, *impl_->round, *impl_->facets, tolerance, context);
  recognised::FacetAtlas made =
      recognised::make_facet_atlas(refined, faces, impl_->facets, impl_->round, tolerance, context);
  refined = {};
  faces = {};
  auto surface = made.exact
                     ? charted(std::move(made), placement_, options, context)
                     : partly_charted(std::move(made), impl_->round, tips_of(input, *impl_->facets),
                                      placement_, options, context);
  context.end_stage();
  const auto& texture = impl_->form.texture();
  if (!texture || !placement_.moves()) return textured(std::move(surface), texture);
  return textured(std::move(surface), texture->mapped(placement_));
}

}  // namespace burin
