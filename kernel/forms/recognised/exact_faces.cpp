#include "exact_faces.h"

#include <burin/work_mesh/half_edges.h>
#include <burin/work_mesh/proxy_draft.h>

#include "meet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>

namespace burin::recognised {
namespace {

/// What triangles of one chart have in common.
struct Cell {
  std::int32_t patch = -1, facet = -1, face = -1;
  int cap = 0;
  auto key() const { return std::tuple(face, patch, patch < 0 ? facet : -1, cap); }
};

/// The plane of a facet over lengths in it.
struct PlaneChart {
  Vec3 origin, normal, e1, e2;

  explicit PlaneChart(const Facet& facet)
      : origin(facet.offset * facet.normal),
        normal(facet.normal),
        e1(any_orthogonal(facet.normal)),
        e2(glm::cross(facet.normal, e1)) {}
  Vec2 parameters(Vec3 p) const { return {glm::dot(p - origin, e1), glm::dot(p - origin, e2)}; }
  SurfaceSample sample(Vec2 uv) const {
    SurfaceSample s;
    s.position = origin + uv.x * e1 + uv.y * e2;
    s.normal = normal;
    s.u = e1;
    s.v = e2;
    return s;
  }
};

// Noises of the input within which a point lies on an axis.
constexpr double kPole = 4;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

/// The charts of the cells, and the model edges between them.
class ExactFaces::Surfaces final : public Sampler {
 public:
  Surfaces(const Facets& facets, const Recognised& round)
      : facets_(facets), round_(round), meet_(round, facets) {}

  std::int32_t add(const Cell& cell) {
    const auto [entry, fresh] =
        numbers_.try_emplace(cell.key(), static_cast<std::int32_t>(cells_.size()));
    if (!fresh) return entry->second;
    cells_.push_back(cell);
    sizes_.emplace_back(0);
    round_charts_.emplace_back();
    plane_charts_.emplace_back();
    if (cell.patch >= 0) {
      round_charts_.back().emplace(patch(cell), cell.cap, kPole * facets_.noise);
    } else {
      plane_charts_.back().emplace(facets_.list[at(cell.facet)]);
    }
    return entry->second;
  }
  /// (u,v) of the corners of a triangle, side by side.
  std::array<Vec2, 3> parameters(std::int32_t cell, const std::array<Vec3, 3>& corners);
  /// A half-edge of a triangle of `cell` from `a` to `b`, with the cell beyond it (or -1).
  std::int32_t add_coedge(std::int32_t cell, std::int32_t beyond, Vec3 a, Vec3 b) {
    coedges_.push_back({cell, beyond, a, b});
    return static_cast<std::int32_t>(coedges_.size() - 1);
  }

  const Cell& cell(std::int32_t face) const { return cells_[at(face)]; }
  const Patch* round(std::int32_t face) const {
    return cell(face).patch < 0 ? nullptr : &patch(cell(face));
  }
  /// Zero at the tip of a cone.
  Vec3 normal(std::int32_t face, Vec3 p) const {
    const Patch* patch = round(face);
    if (!patch) return facets_.list[at(cell(face).facet)].normal;
    const bool tip =
        patch->profile == Patch::Profile::Line && patch->axis.profile(p).x <= kPole * facets_.noise;
    return tip ? Vec3(0) : patch->normal_at(p);
  }

  std::size_t face_count() const override { return cells_.size(); }
  FaceKind kind(std::int32_t face) const override {
    return round(face) ? round(face)->kind : FaceKind::Plane;
  }
  Vec2 domain_size(std::int32_t face) const override { return sizes_[at(face)]; }
  Vec2 period(std::int32_t face) const override {
    const auto& chart = round_charts_[at(face)];
    return chart ? chart->period() : Vec2(0);
  }
  SurfaceSample sample(std::int32_t face, Vec2 uv) const override {
    const auto& chart = round_charts_[at(face)];
    return chart ? chart->sample(uv) : plane_charts_[at(face)]->sample(uv);
  }
  Vec2 on_coedge(std::int32_t coedge, double t) const override {
    const Coedge& c = coedges_[at(coedge)];
    Vec3 p = glm::mix(c.a, c.b, t);
    meet_(refs(c), p);
    return parameters(c.cell, p);
  }

 private:
  struct Coedge {
    std::int32_t cell, beyond;
    Vec3 a, b;
  };

  const Patch& patch(const Cell& cell) const { return round_.patches[at(cell.patch)]; }
  Vec2 parameters(std::int32_t face, Vec3 p) const {
    const auto& chart = round_charts_[at(face)];
    return chart ? chart->parameters(p) : plane_charts_[at(face)]->parameters(p);
  }
  SurfaceRef ref(std::int32_t face) const {
    return cell(face).patch >= 0 ? cell(face).patch : ~cell(face).facet;
  }
  /// The surfaces that an edge lies on; those of a smooth chain are one.
  std::vector<SurfaceRef> refs(const Coedge& c) const {
    if (c.beyond < 0 || ref(c.beyond) == ref(c.cell)) return {ref(c.cell)};
    const Patch *one = round(c.cell), *other = round(c.beyond);
    if (one && other && one->chain >= 0 && one->chain == other->chain) {
      return {std::min(ref(c.cell), ref(c.beyond))};
    }
    // The same for both sides, bit for bit.
    return {std::min(ref(c.cell), ref(c.beyond)), std::max(ref(c.cell), ref(c.beyond))};
  }

  const Facets& facets_;
  const Recognised& round_;
  Meeting meet_;
  std::vector<Cell> cells_;
  std::vector<Vec2> sizes_;
  std::vector<std::optional<PatchChart>> round_charts_;
  std::vector<std::optional<PlaneChart>> plane_charts_;
  std::map<decltype(std::declval<Cell>().key()), std::int32_t> numbers_;
  std::vector<Coedge> coedges_;
};

std::array<Vec2, 3> ExactFaces::Surfaces::parameters(std::int32_t cell,
                                                     const std::array<Vec3, 3>& corners) {
  std::array<Vec2, 3> uv;
  for (std::size_t k = 0; k < 3; ++k) uv[k] = parameters(cell, corners[k]);
  const auto& chart = round_charts_[at(cell)];
  if (chart) {
    const Vec2 middle = parameters(cell, (corners[0] + corners[1] + corners[2]) / 3.0);
    const Vec2 period = chart->period();
    for (std::size_t k = 0; k < 3; ++k) {
      for (int i = 0; i < 2; ++i) {
        if (period[i] > 0) uv[k][i] += period[i] * std::round((middle[i] - uv[k][i]) / period[i]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (chart->at_pole(corners[k])) uv[k].x = 0.5 * (uv[(k + 1) % 3].x + uv[(k + 2) % 3].x);
    }
  }
  const Vec2 size =
      glm::max(glm::max(uv[0], uv[1]), uv[2]) - glm::min(glm::min(uv[0], uv[1]), uv[2]);
  sizes_[at(cell)] = glm::max(sizes_[at(cell)], size);
  return uv;
}

namespace {

/// Whether some face is made of several facets that nothing round was found for.
bool has_freeform(const FacetMesh& m) {
  std::map<std::int32_t, std::int32_t> first;
  for (std::size_t t = 0; t < m.face.size(); ++t) {
    if (m.patch[t] >= 0) continue;
    if (first.try_emplace(m.face[t], m.facet[t]).first->second != m.facet[t]) return true;
  }
  return false;
}

/// What counts at a vertex between surfaces that go over smoothly: the normal of that with the
/// longest triangles. They run along its rulings, and what is not right at one end is not right
/// along them.
struct EdgeNormal {
  double reach;
  std::int32_t patch;
  Vec3 normal;
  double turn;  // Patch::turn
};

double longest_side(const TriMesh& mesh, std::size_t t) {
  const auto& p = mesh.positions;
  const Triangle& c = mesh.triangles[t];
  return std::max({glm::distance(p[c[0]], p[c[1]]), glm::distance(p[c[1]], p[c[2]]),
                   glm::distance(p[c[2]], p[c[0]])});
}

/// By vertex; planes before all.
std::map<std::uint32_t, EdgeNormal> edge_normals(const FacetMesh& m, const Faces& faces,
                                                 const Facets& facets, const Recognised& round) {
  constexpr double kAlike = 1.01;
  std::map<std::uint32_t, EdgeNormal> out;
  for (std::size_t h = 0; h < m.edge.size(); ++h) {
    if (m.edge[h] < 0 || faces.edges[at(m.edge[h])].sharp) continue;
    const std::int32_t number = m.patch[h / 3];
    const Patch* patch = number < 0 ? nullptr : &round.patches[at(number)];
    if (!patch && !faces.tangent[at(m.edge[h])]) continue;
    const Triangle& t = m.mesh.triangles[h / 3];
    const double reach = patch ? longest_side(m.mesh, h / 3) : 1e300;
    for (const std::uint32_t v : {t[h % 3], t[(h + 1) % 3]}) {
      const EdgeNormal mine{
          reach, number,
          patch ? patch->normal_at(m.mesh.positions[v]) : facets.list[at(m.facet[h / 3])].normal,
          patch ? patch->turn : 0};
      const auto [known, fresh] = out.try_emplace(v, mine);
      EdgeNormal& best = known->second;
      if (fresh) continue;
      const bool farther = reach > kAlike * best.reach;
      if (farther || (kAlike * reach > best.reach && number < best.patch)) best = mine;
    }
  }
  return out;
}

Vec3 mean_of(const std::vector<Vec3>& normals, std::span<const HalfEdge> corners) {
  Vec3 sum(0);
  for (const HalfEdge h : corners) sum += normals[at(h)];
  return normalize_or(sum, normals[at(corners.front())]);
}

std::array<Vec3, 3> corners_of(const TriMesh& mesh, std::size_t t) {
  const Triangle& tri = mesh.triangles[t];
  return {mesh.positions[tri[0]], mesh.positions[tri[1]], mesh.positions[tri[2]]};
}

constexpr std::size_t kBatch = 4096;  // triangles between two looks at whether to go on

}  // namespace

ExactFaces::ExactFaces(const FacetMesh& m, const Faces& faces, const Facets& facets,
                       const Recognised& round, double tolerance, const RunContext& context)
    : faces_(faces),
      surfaces_(std::make_unique<Surfaces>(facets, round)),
      exact_(!has_freeform(m)) {
  mesh_.positions = m.mesh.positions;
  mesh_.triangles = m.mesh.triangles;
  mesh_.tolerance = tolerance;
  add_cells(m, round, context);
  add_borders(m, context);
  const std::map<std::uint32_t, EdgeNormal> edges = edge_normals(m, faces, facets, round);
  const auto of_face = [&](std::span<const HalfEdge> corners) {
    const std::size_t t = face_of(corners.front());
    if (m.patch[t] < 0) return mean_of(m.normal, corners);
    const std::uint32_t v = m.mesh.triangles[t][static_cast<std::size_t>(corners.front() % 3)];
    const Vec3 n = surfaces_->normal(mesh_.face[t], m.mesh.positions[v]);
    const auto edge = edges.find(v);
    if (edge == edges.end() || edge->second.patch == m.patch[t]) return n;
    const double turn = std::max(round.patches[at(m.patch[t])].turn, edge->second.turn);
    return go_over(turn, n, edge->second.normal) ? edge->second.normal : n;
  };
  set_corner_normals(mesh_, of_face, context);
}

/// Each triangle gets its chart, and its corners their parameters.
void ExactFaces::add_cells(const FacetMesh& m, const Recognised& round, const RunContext& context) {
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
    if (t % kBatch == 0) context.check();
    const std::array<Vec3, 3> p = corners_of(m.mesh, t);
    Cell cell{m.patch[t], m.facet[t], m.face[t]};
    if (cell.patch >= 0) {
      cell.cap = PatchChart::cap_at(round.patches[at(cell.patch)], (p[0] + p[1] + p[2]) / 3.0);
    }
    mesh_.face.push_back(surfaces_->add(cell));
    for (const Vec2 uv : surfaces_->parameters(mesh_.face.back(), p)) mesh_.uv.push_back(uv);
  }
}

/// Edges between faces, and those inside of them where one chart ends.
void ExactFaces::add_borders(const FacetMesh& m, const RunContext& context) {
  for (const EdgeRecord& e : faces_.edges) {
    mesh_.edge_class.push_back(e.sharp ? ModelEdgeClass::Sharp : ModelEdgeClass::Smooth);
  }
  const auto inside = static_cast<std::int32_t>(mesh_.edge_class.size());
  mesh_.edge_class.push_back(ModelEdgeClass::Smooth);
  const std::vector<HalfEdge> opposite = pair_half_edges(m.mesh.triangles, m.mesh.positions.size());
  mesh_.border.assign(opposite.size(), -1);
  for (std::size_t h = 0; h < opposite.size(); ++h) {
    if (h % (3 * kBatch) == 0) context.check();
    const HalfEdge o = opposite[h];
    const std::int32_t cell = mesh_.face[h / 3], beyond = o < 0 ? -1 : mesh_.face[face_of(o)];
    if (m.edge[h] < 0 && cell == beyond) continue;
    const std::uint32_t from = m.mesh.triangles[h / 3][h % 3],
                        to = m.mesh.triangles[h / 3][(h + 1) % 3];
    // Both sides count from the lower vertex on.
    const auto [low, high] = std::minmax(from, to);
    const std::int32_t coedge =
        surfaces_->add_coedge(cell, beyond, m.mesh.positions[low], m.mesh.positions[high]);
    mesh_.border[h] = static_cast<std::int32_t>(mesh_.borders.size());
    mesh_.borders.push_back({m.edge[h] < 0 ? inside : m.edge[h], coedge, from == low ? 0.0 : 1.0,
                             from == low ? 1.0 : 0.0});
  }
}

ExactFaces::~ExactFaces() = default;

bool ExactFaces::cut(const Camera& camera, const RunContext& context) {
  cut_ = true;
  return cut_along_contours(mesh_, *surfaces_, camera, {}, context);
}

std::vector<std::int32_t> ExactFaces::patches() const {
  std::vector<std::int32_t> out;
  for (const std::int32_t f : mesh_.face) out.push_back(surfaces_->cell(f).patch);
  return out;
}

ProxyMesh ExactFaces::proxy(const RunContext& context) && {
  ProxyDraft draft = proxy_draft(mesh_);
  for (std::int32_t& edge : draft.source_edge) {
    const bool record = edge >= 0 && at(edge) < faces_.edges.size();
    edge = record ? faces_.edges[at(edge)].source : -1;
  }
  for (std::int32_t& face : draft.source_face) face = surfaces_->cell(face).face;
  mesh_ = {};
  ProxyMesh proxy = assemble_proxy(std::move(draft), context);
  if (!cut_) proxy.on_contour.clear();
  return proxy;
}

}  // namespace burin::recognised
