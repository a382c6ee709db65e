#include "faces.h"

#include <burin/base/disjoint_sets.h>

#include "facets.h"
#include "meet.h"
#include "walls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace burin::recognised {
namespace {

// A plane goes over into a round surface where it continues the run of facets: their angle to it is
// no more than that between facets, and half of that to the surface itself.
constexpr double kAsFacets = 1.1, kAsSurface = 0.55;
// Cosine up to which the normals of a wall and of what bends away from it are those of one fan of
// triangles: twice the angle of smooth edges.
constexpr double kSameSide = 0.5;

/// The sets by numbers from 0 on, in the order of their first members.
std::vector<std::int32_t> numbered(DisjointSets& sets, std::size_t n) {
  std::vector<std::int32_t> number(n, -1);
  std::int32_t next = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t first = sets.find(i);
    number[i] = first == i ? next++ : number[first];
  }
  return number;
}

enum class Kind { Inside, Smooth, Tangent, Sharp };

class Divider {
 public:
  Divider(const ProxyMesh& proxy, const Facets& facets, const Recognised& round)
      : proxy_(proxy),
        facets_(facets),
        round_(round),
        meet_(round, facets),
        walls_(proxy, facets, round) {}

  Faces run() {
    const std::size_t n = proxy_.mesh.triangles.size();
    DisjointSets sets(n);
    std::vector<Kind> kinds(3 * n);
    for (std::size_t h = 0; h < 3 * n; ++h) {
      kinds[h] = kind(static_cast<HalfEdge>(h));
      const HalfEdge o = proxy_.topology.opposite[h];
      if (kinds[h] == Kind::Inside && o != kNoHalfEdge) {
        sets.join(static_cast<std::uint32_t>(h / 3), face_of(o));
      }
    }
    Faces out;
    FacetMesh& m = out.mesh;
    m.mesh = proxy_.mesh;
    m.face = numbered(sets, n);
    m.facet = facets_.of;
    for (std::size_t t = 0; t < n; ++t) {
      m.patch.push_back(round_.patch_of[static_cast<std::size_t>(facets_.of[t])]);
    }
    std::vector<std::uint8_t> flat(n, 1);
    std::vector<std::int32_t> first(n, -1);
    for (std::size_t t = 0; t < n; ++t) {
      std::int32_t& f = first[static_cast<std::size_t>(m.face[t])];
      if (f < 0) f = facets_.of[t];
      if (f != facets_.of[t]) flat[static_cast<std::size_t>(m.face[t])] = 0;
    }
    std::map<std::array<std::int32_t, 4>, std::int32_t> records;
    for (std::size_t h = 0; h < 3 * n; ++h) {
      m.edge.push_back(-1);
      const HalfEdge o = proxy_.topology.opposite[h];
      if (kinds[h] == Kind::Inside) continue;
      const std::int32_t a = m.face[h / 3], b = o == kNoHalfEdge ? -1 : m.face[face_of(o)];
      const auto exact = [&](std::size_t t) {
        return m.patch[t] >= 0 || flat[static_cast<std::size_t>(m.face[t])] != 0;
      };
      const bool sharp = kinds[h] == Kind::Sharp;
      // Where a freeform stretch goes over into a round one nobody drew an edge.
      const auto ball = [&](std::size_t t) {
        const Patch* p = patch(ref_of(static_cast<std::uint32_t>(t)));
        return p && p->kind == FaceKind::Sphere;
      };
      // Neither where facets of a sphere end in steps beside those of a fillet.
      const bool named =
          sharp || (exact(h / 3) && exact(face_of(o)) && !ball(h / 3) && !ball(face_of(o)));
      const auto [at, fresh] = records.try_emplace(
          {std::min(a, b), std::max(a, b), static_cast<std::int32_t>(kinds[h]), named},
          static_cast<std::int32_t>(records.size()));
      if (fresh) {
        out.edges.push_back({named ? at->second : -1, sharp});
        out.tangent.push_back(kinds[h] == Kind::Tangent &&
                              (m.patch[h / 3] >= 0 || m.patch[face_of(o)] >= 0));
      }
      m.edge.back() = at->second;
    }
    m.normal = corner_normals(m, kinds, flat);
    return out;
  }

 private:
  /// Those of MeshForm, but where a facet is a face of its own: it is as flat as it looks, up to
  /// its border, and what bends away from a wall begins with the wall's normal.
  std::vector<Vec3> corner_normals(const FacetMesh& m, const std::vector<Kind>& kinds,
                                   const std::vector<std::uint8_t>& flat) const {
    const auto is_flat = [&](std::size_t t) {
      return m.patch[t] < 0 && flat[static_cast<std::size_t>(m.face[t])] != 0;
    };
    std::map<std::uint32_t, Vec3> walls;
    for (std::size_t h = 0; h < kinds.size(); ++h) {
      if (kinds[h] != Kind::Tangent || !is_flat(h / 3)) continue;
      if (m.patch[face_of(proxy_.topology.opposite[h])] >= 0) continue;
      const Vec3 n = facet_normal(static_cast<std::uint32_t>(h / 3));
      walls.try_emplace(m.mesh.triangles[h / 3][h % 3], n);
      walls.try_emplace(m.mesh.triangles[h / 3][(h + 1) % 3], n);
    }
    std::vector<Vec3> normals;
    for (std::size_t h = 0; h < kinds.size(); ++h) {
      const std::size_t t = h / 3;
      normals.push_back(proxy_.wedge_normal[proxy_.wedges[t][h % 3]]);
      if (m.patch[t] >= 0) continue;
      if (is_flat(t)) {
        normals.back() = facet_normal(static_cast<std::uint32_t>(t));
        continue;
      }
      const auto wall = walls.find(m.mesh.triangles[t][h % 3]);
      if (wall != walls.end() && glm::dot(wall->second, normals.back()) > kSameSide) {
        normals.back() = wall->second;
      }
    }
    return normals;
  }

  SurfaceRef ref_of(std::uint32_t t) const {
    const std::int32_t f = facets_.of[t];
    const std::int32_t p = round_.patch_of[static_cast<std::size_t>(f)];
    return p >= 0 ? p : ~f;
  }
  const Patch* patch(SurfaceRef r) const {
    return r < 0 ? nullptr : &round_.patches[static_cast<std::size_t>(r)];
  }

  Kind kind(HalfEdge h) const {
    const HalfEdge o = proxy_.topology.opposite[static_cast<std::size_t>(h)];
    if (o == kNoHalfEdge) return Kind::Sharp;
    const SurfaceRef a = ref_of(face_of(h)), b = ref_of(face_of(o));
    const Patch *pa = patch(a), *pb = patch(b);
    if (a == b) return Kind::Inside;
    if (!pa && !pb) {
      const bool smooth = proxy_.edge_kind[static_cast<std::size_t>(h)] == EdgeKind::Smooth;
      return smooth ? between(~a, ~b) : Kind::Sharp;
    }
    const bool chain = pa && pb && pa->chain >= 0 && pa->chain == pb->chain;
    if (chain && !pa->sheet) return Kind::Inside;
    const Vec3 middle = 0.5 * (proxy_.mesh.positions[origin(proxy_.mesh, h)] +
                               proxy_.mesh.positions[origin(proxy_.mesh, o)]);
    const double angle = std::acos(
        std::clamp(glm::dot(meet_.normal(a, middle), meet_.normal(b, middle)), -1.0, 1.0));
    const double facets = std::acos(
        std::clamp(glm::dot(facet_normal(face_of(h)), facet_normal(face_of(o))), -1.0, 1.0));
    const double turn = std::max(pa ? pa->turn : 0, pb ? pb->turn : 0);
    // A sheet that comes back to where it began may meet itself there in an edge.
    if (chain) return angle <= kDegree ? Kind::Inside : Kind::Sharp;
    if (angle <= kDegree) return pa && pb ? Kind::Smooth : Kind::Tangent;
    if (angle > kAsSurface * turn || facets > kAsFacets * turn) return Kind::Sharp;
    return pa && pb ? Kind::Smooth : Kind::Tangent;
  }

  /// Facets that meet at a small angle.
  Kind between(std::int32_t a, std::int32_t b) const {
    const bool wall_a = walls_.is_wall(a), wall_b = walls_.is_wall(b);
    if (!wall_a && !wall_b) return Kind::Inside;
    if (wall_a && wall_b) return Kind::Sharp;
    return walls_.goes_on(wall_a ? b : a) ? Kind::Tangent : Kind::Sharp;
  }

  Vec3 facet_normal(std::uint32_t t) const {
    return facets_.list[static_cast<std::size_t>(facets_.of[t])].normal;
  }

  const ProxyMesh& proxy_;
  const Facets& facets_;
  const Recognised& round_;
  Meeting meet_;
  Walls walls_;
};

}  // namespace

Faces find_faces(const ProxyMesh& proxy, const Facets& facets, const Recognised& round) {
  return Divider(proxy, facets, round).run();
}

RecognisedFaces count_faces(const TriMesh& mesh, const Topology& topology, const Facets& facets,
                            const Recognised& round) {
  DisjointSets sets(mesh.triangles.size());
  const auto patch = [&](std::uint32_t t) {
    return round.patch_of[static_cast<std::size_t>(facets.of[t])];
  };
  const auto kind = [&](std::int32_t p) { return round.patches[static_cast<std::size_t>(p)].kind; };
  const auto chain = [&](std::int32_t p) {
    return round.patches[static_cast<std::size_t>(p)].chain;
  };
  for (std::size_t h = 0; h < topology.opposite.size(); ++h) {
    const HalfEdge o = topology.opposite[h];
    if (o == kNoHalfEdge) continue;
    const auto t = static_cast<std::uint32_t>(h / 3);
    const std::int32_t a = patch(t), b = patch(face_of(o));
    if (a < 0 || b < 0) continue;
    if (a == b || (chain(a) >= 0 && chain(a) == chain(b) && kind(a) == kind(b))) {
      sets.join(t, face_of(o));
    }
  }
  RecognisedFaces n;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (patch(t) < 0 || sets.find(t) != t) continue;
    const FaceKind k = kind(patch(t));
    const bool sheet = round.patches[static_cast<std::size_t>(patch(t))].sheet != nullptr;
    ++(sheet                     ? n.swept
       : k == FaceKind::Cylinder ? n.cylinders
       : k == FaceKind::Cone     ? n.cones
       : k == FaceKind::Sphere   ? n.spheres
       : k == FaceKind::Torus    ? n.tori
                                 : n.revolved);
  }
  return n;
}

bool go_over(double turn, Vec3 one, Vec3 other) {
  return glm::dot(one, other) >= std::cos(std::max(kAsSurface * turn, kDegree));
}

void FacetMesh::add(Triangle t, std::size_t like, const std::int32_t (&edges)[3],
                    const Vec3 (&normals)[3], const FacetMesh& from) {
  mesh.triangles.push_back(t);
  patch.push_back(from.patch[like]);
  facet.push_back(from.facet[like]);
  face.push_back(from.face[like]);
  if (!from.source.empty()) source.push_back(from.source[like]);
  for (std::size_t k = 0; k < 3; ++k) {
    edge.push_back(edges[k]);
    normal.push_back(normals[k]);
  }
}

}  // namespace burin::recognised
