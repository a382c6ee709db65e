// What the editable mesh under the cut costs, ours beside one of OpenMesh: both are made of the
// same triangles of a torus, take what a corner holds, and split every twentieth edge in the
// middle. No surface is evaluated in either.

#include <burin/base/run_context.h>
#include <burin/mesh/corners.h>

#include "../../kernel/contour_cut/cut_mesh.h"
#include "../../kernel/mesh/openmesh/openmesh_glm.h"

#include <benchmark/benchmark.h>
#include <burin_test/atlases.h>

#include <cmath>
#include <vector>

namespace burin {
namespace {

test::Charted torus(std::int64_t triangles) {
  const int n = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 4));
  return test::charted_torus(3, 1, 2 * n, n);
}

/// A surface that costs nothing.
class NoSurface final : public Sampler {
 public:
  std::size_t face_count() const override { return 1; }
  FaceKind kind(std::int32_t) const override { return FaceKind::Torus; }
  Vec2 domain_size(std::int32_t) const override { return Vec2(1); }
  Vec2 period(std::int32_t) const override { return Vec2(0); }
  SurfaceSample sample(std::int32_t, Vec2) const override { return {}; }
  Vec2 on_coedge(std::int32_t, double) const override { return Vec2(0); }
};

void work_mesh_own(benchmark::State& state) {
  const test::Charted shape = torus(state.range(0));
  const Camera camera = Camera::fit(
      [](const Mat3&) {
        return Box3{Vec3(-4), Vec3(4)};
      },
      {.direction = {1, -1, 1}});
  const NoSurface surface;
  const RunContext context;
  for (auto _ : state) {
    ChartMesh mesh = shape.mesh;
    CutMesh cut(mesh, surface, camera, context);
    const auto count = static_cast<HalfEdge>(cut.half_edge_count());
    for (HalfEdge h = 0; h < count; h += 20) {
      EdgePoint point;
      point.share = 0.5;
      point.position = 0.5 * (cut.position(h) + cut.position(next_in_face(h)));
      cut.split_edge(h, point);
    }
    benchmark::DoNotOptimize(mesh.triangles.size());
  }
}
BENCHMARK(work_mesh_own)->Arg(10000)->Arg(100000)->Arg(500000)->Unit(benchmark::kMillisecond);

/// What CutMesh holds of a corner and its edge.
struct Attributes {
  Vec2 uv{0};
  Vec3 normal{0};
  double g = 0, shift = 0;
  std::int32_t border = -1;
  std::uint8_t on_contour = 0, pole = 0;
};

void work_mesh_openmesh(benchmark::State& state) {
  const test::Charted shape = torus(state.range(0));
  for (auto _ : state) {
    OpenMeshTriMesh mesh;
    OpenMesh::HPropHandleT<Attributes> attributes;
    OpenMesh::FPropHandleT<std::int32_t> face;
    mesh.add_property(attributes);
    mesh.add_property(face);
    const ChartMesh& from = shape.mesh;
    mesh.reserve(from.positions.size(), 3 * from.triangles.size() / 2, from.triangles.size());
    for (const Vec3& p : from.positions) mesh.add_vertex(p);
    for (std::size_t f = 0; f < from.triangles.size(); ++f) {
      const Triangle& t = from.triangles[f];
      const auto at = [&](std::size_t k) { return OpenMesh::VertexHandle(static_cast<int>(t[k])); };
      const auto added = mesh.add_face(at(0), at(1), at(2));
      mesh.property(face, added) = from.face[f];
      // The half-edge into a corner holds what the corner holds.
      for (auto h = mesh.fh_iter(added); h.is_valid(); ++h) {
        const auto to = static_cast<std::uint32_t>(mesh.to_vertex_handle(*h).idx());
        const std::size_t k = to == t[0] ? 0 : to == t[1] ? 1 : 2;
        mesh.property(attributes, *h) = {from.uv[3 * f + k],     from.normal[3 * f + k],     0, 0,
                                         from.border[3 * f + k], from.on_contour[3 * f + k], 0};
      }
    }
    const int count = static_cast<int>(3 * from.triangles.size());
    for (int i = 0; i < count; i += 20) {
      const OpenMesh::EdgeHandle edge(i / 2);
      const auto h = mesh.halfedge_handle(edge, 0);
      const glm::dvec3 middle =
          0.5 * (mesh.point(mesh.from_vertex_handle(h)) + mesh.point(mesh.to_vertex_handle(h)));
      // It copies what half-edges and faces hold to the new ones.
      mesh.split_copy(edge, mesh.add_vertex(middle));
    }
    benchmark::DoNotOptimize(mesh.n_faces());
  }
}
BENCHMARK(work_mesh_openmesh)->Arg(10000)->Arg(100000)->Arg(500000)->Unit(benchmark::kMillisecond);

// What every walk around vertices costs: the quadric that normals and curvature are fitted by, and
// the angle of each edge that creases are told by, ours (a flat array of opposites, corners dealt
// to vertices) beside OpenMesh's circulators, over a mesh that is there. Single thread.

struct Rings {
  TriMesh mesh;
  std::vector<Vec3> normals;  // of triangles
};

Rings rings(std::int64_t triangles) {
  test::Charted shape = torus(triangles);
  Rings out{{std::move(shape.mesh.positions), std::move(shape.mesh.triangles)}, {}};
  for (std::uint32_t f = 0; f < out.mesh.triangles.size(); ++f) {
    out.normals.push_back(out.mesh.normal(f));
  }
  return out;
}

/// The moments of a neighbour's offset, as a least-squares fit adds them up.
void add(glm::dmat3& moments, Vec3 offset) { moments += glm::outerProduct(offset, offset); }

void one_rings_own(benchmark::State& state) {
  const Rings r = rings(state.range(0));
  const Topology topology = build_topology(r.mesh, RunContext());
  const auto corners = corners_at(r.mesh.triangles, r.mesh.positions.size());
  for (auto _ : state) {
    double sum = 0;
    for (std::uint32_t v = 0; v < r.mesh.positions.size(); ++v) {
      glm::dmat3 moments(0);
      for (const HalfEdge h : corners[v]) {
        add(moments, r.mesh.positions[origin(r.mesh, next_in_face(h))] - r.mesh.positions[v]);
      }
      sum += moments[0][0] + moments[1][2];
    }
    for (std::size_t h = 0; h < topology.opposite.size(); ++h) {
      sum += glm::dot(r.normals[h / 3], r.normals[face_of(topology.opposite[h])]);
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(one_rings_own)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void one_rings_openmesh(benchmark::State& state) {
  const Rings r = rings(state.range(0));
  OpenMeshTriMesh mesh;
  mesh.reserve(r.mesh.positions.size(), 3 * r.mesh.triangles.size() / 2, r.mesh.triangles.size());
  for (const Vec3& p : r.mesh.positions) mesh.add_vertex(p);
  for (const Triangle& t : r.mesh.triangles) {
    const auto at = [&](std::size_t k) { return OpenMesh::VertexHandle(static_cast<int>(t[k])); };
    mesh.add_face(at(0), at(1), at(2));
  }
  for (auto _ : state) {
    double sum = 0;
    for (const auto v : mesh.vertices()) {
      glm::dmat3 moments(0);
      for (auto n = mesh.cvv_iter(v); n.is_valid(); ++n) {
        add(moments, mesh.point(*n) - mesh.point(v));
      }
      sum += moments[0][0] + moments[1][2];
    }
    for (const auto h : mesh.halfedges()) {
      const auto a = mesh.face_handle(h), b = mesh.opposite_face_handle(h);
      sum += glm::dot(r.normals[static_cast<std::size_t>(a.idx())],
                      r.normals[static_cast<std::size_t>(b.idx())]);
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(one_rings_openmesh)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace burin
