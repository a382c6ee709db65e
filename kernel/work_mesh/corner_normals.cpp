#include <burin/base/parallel.h>
#include <burin/mesh/corners.h>
#include <burin/work_mesh/chart_mesh.h>

#include <algorithm>
#include <utility>

namespace burin {

namespace {

constexpr std::size_t kVertexGrain = 256;

class WedgeNormals {
 public:
  WedgeNormals(ChartMesh& mesh, const FaceNormal& of_face, const std::vector<HalfEdge>& opposite)
      : mesh_(mesh), of_face_(of_face), opposite_(opposite) {}

  /// Gives the wedge of `start` its normal and returns its corners.
  const std::vector<HalfEdge>& set(HalfEdge start) {
    collect(start);
    std::ranges::sort(wedge_, {}, [&](HalfEdge h) { return std::pair(face(h), h); });
    Vec3 sum(0), first(0);
    std::size_t faces = 0;
    for (auto from = wedge_.begin(); from != wedge_.end();) {
      const auto to =
          std::find_if(from, wedge_.end(), [&](HalfEdge h) { return face(h) != face(*from); });
      const Vec3 n = of_face_({from, to});
      if (n != Vec3(0) && faces++ == 0) first = n;
      sum += n;
      from = to;
    }
    const Vec3 normal = faces > 1 ? normalize_or(sum, first) : first;
    for (const HalfEdge h : wedge_) {
      mesh_.normal[static_cast<std::size_t>(h)] = normal;
      mesh_.on_contour[static_cast<std::size_t>(h)] = normal == Vec3(0);
    }
    return wedge_;
  }

 private:
  std::int32_t face(HalfEdge h) const { return mesh_.face[face_of(h)]; }

  HalfEdge over(HalfEdge h) const {
    const HalfEdge o = opposite_[static_cast<std::size_t>(h)];
    return sharp_edge(mesh_, o, static_cast<std::size_t>(h)) ? kNoHalfEdge : o;
  }

  void collect(HalfEdge start) {
    wedge_.clear();
    HalfEdge h = start;
    do {
      wedge_.push_back(h);
      h = over(prev_in_face(h));
    } while (h != kNoHalfEdge && h != start);
    if (h == start) return;
    for (h = over(start); h != kNoHalfEdge; h = over(h)) {
      h = next_in_face(h);
      wedge_.push_back(h);
    }
  }

  ChartMesh& mesh_;
  const FaceNormal& of_face_;
  const std::vector<HalfEdge>& opposite_;
  std::vector<HalfEdge> wedge_;
};

}  // namespace

void set_corner_normals(ChartMesh& mesh, const FaceNormal& of_face, const RunContext& context) {
  const std::size_t n = 3 * mesh.triangles.size();
  mesh.normal.assign(n, Vec3(0));
  mesh.on_contour.assign(n, 0);
  const std::vector<HalfEdge> opposite = chart_mesh_opposites(mesh);
  const auto corners = corners_at(mesh.triangles, mesh.positions.size());
  std::vector<std::uint8_t> done(n, 0);
  parallel_for(
      mesh.positions.size(), kVertexGrain,
      [&](std::size_t begin, std::size_t end) {
        WedgeNormals normals(mesh, of_face, opposite);
        for (std::size_t v = begin; v < end; ++v) {
          for (const HalfEdge corner : corners[v]) {
            if (done[static_cast<std::size_t>(corner)]) continue;
            for (const HalfEdge h : normals.set(corner)) {
              done[static_cast<std::size_t>(h)] = 1;
            }
          }
        }
      },
      &context);
}

}  // namespace burin
