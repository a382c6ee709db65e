#include "facet_atlas.h"

#include <burin/forms/charted/analytic_chart.h>
#include <burin/work_mesh/half_edges.h>

#include "facets.h"
#include "meet.h"
#include "patch_chart.h"

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
  /// The face that the input says; -1: it tells none apart.
  std::int32_t source = -1;
  auto key() const { return std::tuple(face, patch, patch < 0 ? facet : -1, cap, source); }
};

// Noises of the input within which a point lies on an axis.
constexpr double kPole = 4;

/// The plane of a facet over lengths in it.
class PlaneBox {
 public:
  explicit PlaneBox(const Facet& facet) {
    axes_.origin = facet.offset * facet.normal;
    axes_.z = facet.normal;
    axes_.x = any_orthogonal(facet.normal);
    axes_.y = glm::cross(axes_.z, axes_.x);
  }
  Vec2 parameters(Vec3 p) const {
    return {glm::dot(p - axes_.origin, axes_.x), glm::dot(p - axes_.origin, axes_.y)};
  }
  void extend_to(Vec2 uv) {
    low_ = glm::min(low_, uv);
    high_ = glm::max(high_, uv);
  }
  std::shared_ptr<const Chart> chart() const {
    const Vec2 beside = 0.1 * (high_ - low_);
    return plane_chart(axes_, {low_ - beside, high_ + beside});
  }

 private:
  ChartAxes axes_;
  Vec2 low_{1e300}, high_{-1e300};
};

/// The charts of the cells, and the model edges between them.
class CellAtlas final : public Atlas {
 public:
  CellAtlas(std::shared_ptr<const Facets> facets, std::shared_ptr<const Recognised> round,
            const std::vector<EdgeRecord>& edges)
      : facets_(std::move(facets)), round_(std::move(round)), meet_(*round_, *facets_) {
    for (const EdgeRecord& e : edges) source_edge_.push_back(e.source);
  }

  std::int32_t add(const Cell& cell) {
    const auto [entry, fresh] =
        numbers_.try_emplace(cell.key(), static_cast<std::int32_t>(cells_.size()));
    if (!fresh) return entry->second;
    cells_.push_back(cell);
    planes_.emplace_back();
    patches_.emplace_back();
    if (cell.patch >= 0) {
      patches_.back() = std::make_shared<PatchChart>(round_->patches[at(cell.patch)], cell.cap,
                                                     kPole * facets_->noise);
    } else {
      planes_.back().emplace(facets_->list[at(cell.facet)]);
    }
    return entry->second;
  }
  /// (u,v) of the corners of a triangle, side by side.
  std::array<Vec2, 3> add_triangle(std::int32_t face, const std::array<Vec3, 3>& corners);
  /// A half-edge of a triangle of `face` from `a` to `b`, with the face beyond it (or -1).
  std::int32_t add_coedge(std::int32_t face, std::int32_t beyond, Vec3 a, Vec3 b) {
    coedges_.push_back({face, beyond, a, b});
    coedges_.back().curve = curve(coedges_.back());
    return static_cast<std::int32_t>(coedges_.size() - 1);
  }
  /// After the last triangle.
  void close() {
    for (std::size_t f = 0; f < cells_.size(); ++f) {
      charts_.push_back(patches_[f] ? patches_[f] : planes_[f]->chart());
    }
    numbers_ = {};
  }

  const Cell& cell(std::int32_t face) const { return cells_[at(face)]; }
  /// Zero at the tip of a cone.
  Vec3 normal(std::int32_t face, Vec3 p) const {
    if (!patches_[at(face)]) return facets_->list[at(cell(face).facet)].normal;
    const Patch& patch = patches_[at(face)]->patch();
    const bool tip =
        patch.profile == Patch::Profile::Line && patch.axis.profile(p).x <= kPole * facets_->noise;
    return tip ? Vec3(0) : patch.normal_at(p);
  }

  std::size_t face_count() const override { return cells_.size(); }
  const Chart& chart(std::int32_t face) const override { return *charts_[at(face)]; }
  bool reversed(std::int32_t face) const override {
    return patches_[at(face)] && patches_[at(face)]->reversed();
  }
  Vec2 on_coedge(std::int32_t coedge, double t) const override {
    const Coedge& c = coedges_[at(coedge)];
    return parameters(c.face, c.curve == Coedge::Curve::Meets      ? meeting(c, t)
                              : c.curve == Coedge::Curve::Straight ? glm::mix(c.a, c.b, t)
                                                                   : on_circle(c, t));
  }
  std::int32_t source_face(std::int32_t face) const override {
    return cell(face).source < 0 ? cell(face).face : cell(face).source;
  }
  /// Those inside faces, where one chart ends, have no name.
  std::int32_t source_edge(std::int32_t edge) const override {
    return at(edge) < source_edge_.size() ? source_edge_[at(edge)] : -1;
  }

 private:
  struct Coedge {
    std::int32_t face, beyond;
    Vec3 a, b;
    /// What surfaces that meet there have in common: rulings and circles about one axis need no
    /// search.
    enum class Curve : std::uint8_t { Straight, Circle, Meets };
    Curve curve = Curve::Meets;
  };

  Vec2 parameters(std::int32_t face, Vec3 p) const {
    return patches_[at(face)] ? patches_[at(face)]->parameters(p)
                              : planes_[at(face)]->parameters(p);
  }
  SurfaceRef ref(std::int32_t face) const {
    return cell(face).patch >= 0 ? cell(face).patch : ~cell(face).facet;
  }
  struct Refs {
    std::array<SurfaceRef, 2> list{};
    std::size_t count = 1;
  };
  Refs refs(const Coedge& c) const;
  Vec3 meeting(const Coedge& c, double t) const {
    const Refs on = refs(c);
    Vec3 p = glm::mix(c.a, c.b, t);
    meet_(std::span(on.list.data(), on.count), p);
    return p;
  }
  /// About the axis of the first round surface of an edge, which has one.
  Vec3 on_circle(const Coedge& c, double t) const;
  Coedge::Curve curve(const Coedge& c) const;
  const Patch* round_of(const Coedge& c) const {
    const Refs on = refs(c);
    // A patch stands behind a plane.
    const SurfaceRef last = on.list[on.count - 1];
    return last < 0 ? nullptr : &round_->patches[at(last)];
  }

  std::shared_ptr<const Facets> facets_;
  std::shared_ptr<const Recognised> round_;
  Meeting meet_;
  std::vector<Cell> cells_;
  std::vector<std::shared_ptr<PatchChart>> patches_;
  std::vector<std::optional<PlaneBox>> planes_;
  std::vector<std::shared_ptr<const Chart>> charts_;
  std::map<decltype(std::declval<Cell>().key()), std::int32_t> numbers_;
  std::vector<Coedge> coedges_;
  std::vector<std::int32_t> source_edge_;
};

/// The surfaces that an edge lies on; those of a smooth chain are one.
CellAtlas::Refs CellAtlas::refs(const Coedge& c) const {
  if (c.beyond < 0 || ref(c.beyond) == ref(c.face)) return {{ref(c.face)}};
  const auto &one = patches_[at(c.face)], &other = patches_[at(c.beyond)];
  if (one && other && one->patch().chain >= 0 && one->patch().chain == other->patch().chain) {
    return {{std::min(ref(c.face), ref(c.beyond))}};
  }
  // The same for both sides, bit for bit.
  return {{std::min(ref(c.face), ref(c.beyond)), std::max(ref(c.face), ref(c.beyond))}, 2};
}

Vec3 CellAtlas::on_circle(const Coedge& c, double t) const {
  const Axis& axis = round_of(c)->axis;
  const Vec3 p = glm::mix(c.a, c.b, t);
  const Vec2 rh = glm::mix(axis.profile(c.a), axis.profile(c.b), t);
  return axis.origin + rh.x * axis.outward(p) + rh.y * axis.direction;
}

CellAtlas::Coedge::Curve CellAtlas::curve(const Coedge& c) const {
  // Of the edge's length: what is nearer is the same curve, as far as marches can tell.
  constexpr double kSame = 1e-9;
  const auto same = [&](const auto& place) {
    for (const double t : {0.25, 0.5, 0.8}) {
      if (!(glm::distance(place(t), meeting(c, t)) <= kSame * glm::distance(c.a, c.b)))
        return false;
    }
    return true;
  };
  if (same([&](double t) { return glm::mix(c.a, c.b, t); })) return Coedge::Curve::Straight;
  const bool circle =
      round_of(c) && !round_of(c)->sheet && same([&](double t) { return on_circle(c, t); });
  return circle ? Coedge::Curve::Circle : Coedge::Curve::Meets;
}

std::array<Vec2, 3> CellAtlas::add_triangle(std::int32_t face, const std::array<Vec3, 3>& corners) {
  std::array<Vec2, 3> uv;
  for (std::size_t k = 0; k < 3; ++k) uv[k] = parameters(face, corners[k]);
  PatchChart* chart = patches_[at(face)].get();
  if (chart) {
    const Vec2 middle = parameters(face, (corners[0] + corners[1] + corners[2]) / 3.0);
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
  for (const Vec2 p : uv) chart ? chart->extend_to(p) : planes_[at(face)]->extend_to(p);
  return uv;
}

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

/// Each triangle gets its chart, and its corners their parameters.
void add_cells(CellAtlas& atlas, ChartMesh& mesh, const FacetMesh& m, const Recognised& round,
               const RunContext& context) {
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
    if (t % kBatch == 0) context.check();
    const std::array<Vec3, 3> p = corners_of(m.mesh, t);
    Cell cell{m.patch[t], m.facet[t], m.face[t]};
    if (cell.patch >= 0) {
      cell.cap = PatchChart::cap_at(round.patches[at(cell.patch)], (p[0] + p[1] + p[2]) / 3.0);
    }
    if (!m.source.empty()) cell.source = m.source[t];
    mesh.face.push_back(atlas.add(cell));
    for (const Vec2 uv : atlas.add_triangle(mesh.face.back(), p)) mesh.uv.push_back(uv);
  }
  atlas.close();
}

/// Edges between faces, and those inside of them where one chart ends.
void add_borders(CellAtlas& atlas, ChartMesh& mesh, const FacetMesh& m,
                 const std::vector<EdgeRecord>& edges, const RunContext& context) {
  for (const EdgeRecord& e : edges) {
    mesh.edge_class.push_back(e.sharp ? ModelEdgeClass::Sharp : ModelEdgeClass::Smooth);
  }
  const auto inside = static_cast<std::int32_t>(mesh.edge_class.size());
  mesh.edge_class.push_back(ModelEdgeClass::Smooth);
  const std::vector<HalfEdge> opposite = pair_half_edges(m.mesh.triangles, m.mesh.positions.size());
  mesh.border.assign(opposite.size(), -1);
  for (std::size_t h = 0; h < opposite.size(); ++h) {
    if (h % (3 * kBatch) == 0) context.check();
    const HalfEdge o = opposite[h];
    const std::int32_t face = mesh.face[h / 3], beyond = o < 0 ? -1 : mesh.face[face_of(o)];
    if (m.edge[h] < 0 && face == beyond) continue;
    const std::uint32_t from = m.mesh.triangles[h / 3][h % 3],
                        to = m.mesh.triangles[h / 3][(h + 1) % 3];
    // Both sides count from the lower vertex on.
    const auto [low, high] = std::minmax(from, to);
    const std::int32_t coedge =
        atlas.add_coedge(face, beyond, m.mesh.positions[low], m.mesh.positions[high]);
    mesh.border[h] = static_cast<std::int32_t>(mesh.borders.size());
    mesh.borders.push_back({m.edge[h] < 0 ? inside : m.edge[h], coedge, from == low ? 0.0 : 1.0,
                            from == low ? 1.0 : 0.0});
  }
}

}  // namespace

FacetAtlas make_facet_atlas(const FacetMesh& m, const Faces& faces,
                            const std::shared_ptr<const Facets>& facets,
                            const std::shared_ptr<const Recognised>& round, double tolerance,
                            const RunContext& context) {
  auto atlas = std::make_shared<CellAtlas>(facets, round, faces.edges);
  FacetAtlas out;
  out.exact = !has_freeform(m);
  out.mesh.positions = m.mesh.positions;
  out.mesh.triangles = m.mesh.triangles;
  out.mesh.tolerance = tolerance;
  add_cells(*atlas, out.mesh, m, *round, context);
  add_borders(*atlas, out.mesh, m, faces.edges, context);
  const std::map<std::uint32_t, EdgeNormal> edges = edge_normals(m, faces, *facets, *round);
  const auto of_face = [&](std::span<const HalfEdge> corners) {
    const std::size_t t = face_of(corners.front());
    if (m.patch[t] < 0) return mean_of(m.normal, corners);
    const std::uint32_t v = m.mesh.triangles[t][static_cast<std::size_t>(corners.front() % 3)];
    const Vec3 n = atlas->normal(out.mesh.face[t], m.mesh.positions[v]);
    const auto edge = edges.find(v);
    if (edge == edges.end() || edge->second.patch == m.patch[t]) return n;
    const double turn = std::max(round->patches[at(m.patch[t])].turn, edge->second.turn);
    return go_over(turn, n, edge->second.normal) ? edge->second.normal : n;
  };
  set_corner_normals(out.mesh, of_face, context);
  for (std::size_t f = 0; f < atlas->face_count(); ++f) {
    out.patch.push_back(atlas->cell(static_cast<std::int32_t>(f)).patch);
    out.facet.push_back(atlas->cell(static_cast<std::int32_t>(f)).facet);
  }
  out.atlas = std::move(atlas);
  return out;
}

}  // namespace burin::recognised
