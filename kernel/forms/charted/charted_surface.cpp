#include <burin/base/parallel.h>
#include <burin/forms/charted/charted_surface.h>
#include <burin/mesh/nearest_side.h>

#include "cover_charts.h"
#include "locate.h"
#include "march.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t kPointGrain = 2048;

class ChartedSurface final : public Surface {
 public:
  ChartedSurface(PlacedAtlas atlas, ChartMesh mesh, const RunContext& context)
      : atlas_(std::move(atlas)),
        mesh_(std::move(mesh)),
        proxy_(assemble_proxy(proxy_draft(mesh_, *atlas_.atlas), context)),
        triangles_(atlas_, mesh_, proxy_.topology.opposite, context),
        lines_(*atlas_.atlas) {
    // The proxy has them now.
    mesh_.normal = {};
    mesh_.on_contour = {};
  }

  std::vector<SurfacePoint> cover(const CoverRequest& request,
                                  const RunContext& context) const override {
    return charts_cover(context)->points(request, context);
  }
  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override {
    return detail::March(atlas_, triangles_, lines_, length).run(from, tangent);
  }
  Frame frame(const SurfacePoint& point) const override;
  std::optional<Vec2> parameters(const SurfacePoint& point) const override {
    const ParameterBox domain = atlas_.atlas->chart(point.chart).domain();
    return (Vec2(point.coords) - domain.min) / domain.size();
  }
  bool exact() const override { return true; }
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint& point) const override;
  SurfacePoint lift(const ProxyPoint& point) const override;
  std::vector<Frame> wedge_frames(const RunContext& context) const override;

 private:
  /// The wedges' corners to ask for frames: for each wedge one of every face that it touches.
  struct WedgeCorner {
    std::uint32_t wedge = 0;
    HalfEdge corner = kNoHalfEdge;
  };
  std::vector<WedgeCorner> wedge_corners() const;
  Frame corner_frame(HalfEdge corner) const;
  std::shared_ptr<const detail::ChartsCover> charts_cover(const RunContext& context) const;

  PlacedAtlas atlas_;
  ChartMesh mesh_;
  ProxyMesh proxy_;
  detail::UvTriangles triangles_;
  detail::BreakLines lines_;
  // Made when it is first asked for: a drawing without strokes needs no bounds.
  mutable std::mutex cover_mutex_;
  mutable std::shared_ptr<const detail::ChartsCover> cover_;
};

std::shared_ptr<const detail::ChartsCover> ChartedSurface::charts_cover(
    const RunContext& context) const {
  {
    const std::lock_guard lock(cover_mutex_);
    if (cover_) return cover_;
  }
  // Not under the lock: while its loops wait, this thread may take a task that comes here, too.
  auto made = std::make_shared<const detail::ChartsCover>(atlas_, proxy_.mesh, triangles_, context);
  const std::lock_guard lock(cover_mutex_);
  if (!cover_) cover_ = std::move(made);
  return cover_;
}

Frame ChartedSurface::frame(const SurfacePoint& point) const {
  const Vec2 uv(point.coords.x, point.coords.y);
  const SurfaceDerivatives d = atlas_.derivatives(point.chart, uv);
  Vec3 normal = atlas_.normal(point.chart, uv, d);
  // The tip of a cone has none: that of the triangle stands in.
  if (normal == Vec3(0)) {
    normal = normalize_or(proxy_.mesh.normal(point.triangle), Vec3(0, 0, 1));
  }
  Frame f = chart_frame(d, normal, atlas_.kind(point.chart), atlas_.size);
  f.position = point.position;
  return f;
}

ProxyPoint ChartedSurface::to_proxy(const SurfacePoint& point) const {
  Vec2 uv(point.coords.x, point.coords.y);
  const std::uint32_t triangle = triangles_.locate(point.triangle, uv);
  const Vec3 b = triangles_.bary(triangle, uv);
  // Between a chord and the edge that it stands for.
  if (std::min({b.x, b.y, b.z}) < 0) {
    return {triangle, nearest_side(proxy_.mesh, triangle, point.position)};
  }
  return {triangle, b / (b.x + b.y + b.z)};
}

SurfacePoint ChartedSurface::lift(const ProxyPoint& point) const {
  const std::int32_t face = mesh_.face[point.face];
  const Vec2 uv = triangles_.uv(point.face, point.bary);
  return {face, Vec3(uv, 0), atlas_.position(face, uv), point.face};
}

std::vector<ChartedSurface::WedgeCorner> ChartedSurface::wedge_corners() const {
  std::vector<HalfEdge> first(proxy_.wedge_vertex.size(), kNoHalfEdge);
  std::vector<WedgeCorner> others;
  const auto count = static_cast<HalfEdge>(3 * proxy_.wedges.size());
  for (HalfEdge h = 0; h < count; ++h) {
    const std::uint32_t w = proxy_.wedges[face_of(h)][static_cast<std::size_t>(h % 3)];
    if (first[w] == kNoHalfEdge) {
      first[w] = h;
    } else if (mesh_.face[face_of(h)] != mesh_.face[face_of(first[w])]) {
      others.push_back({w, h});
    }
  }
  const auto face = [&](const WedgeCorner& c) { return mesh_.face[face_of(c.corner)]; };
  std::sort(others.begin(), others.end(), [&](const WedgeCorner& a, const WedgeCorner& b) {
    return std::tuple(a.wedge, face(a), a.corner) < std::tuple(b.wedge, face(b), b.corner);
  });
  const auto same = [&](const WedgeCorner& a, const WedgeCorner& b) {
    return a.wedge == b.wedge && face(a) == face(b);
  };
  others.erase(std::unique(others.begin(), others.end(), same), others.end());
  std::vector<WedgeCorner> all;
  all.reserve(first.size() + others.size());
  for (std::uint32_t w = 0; w < first.size(); ++w) all.push_back({w, first[w]});
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

Frame ChartedSurface::corner_frame(HalfEdge corner) const {
  Vec3 bary(0);
  bary[corner % 3] = 1;
  return frame(lift({face_of(corner), bary}));
}

std::vector<Frame> ChartedSurface::wedge_frames(const RunContext& context) const {
  const std::vector<WedgeCorner> corners = wedge_corners();
  std::vector<Frame> frames(corners.size());
  parallel_for(
      corners.size(), kPointGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          if (corners[i].corner != kNoHalfEdge) frames[i] = corner_frame(corners[i].corner);
        }
      },
      &context);
  // Faces that meet smoothly share a wedge: the one that knows its directions best speaks for it.
  const std::size_t wedges = proxy_.wedge_vertex.size();
  for (std::size_t i = wedges; i < corners.size(); ++i) {
    Frame& f = frames[corners[i].wedge];
    if (frames[i].confidence > f.confidence) f = frames[i];
  }
  frames.resize(wedges);
  return frames;
}

}  // namespace

ProxyDraft proxy_draft(const ChartMesh& mesh, const Atlas& atlas) {
  ProxyDraft draft = proxy_draft(mesh);
  for (std::int32_t& face : draft.source_face) face = atlas.source_face(face);
  for (std::int32_t& edge : draft.source_edge) edge = edge < 0 ? -1 : atlas.source_edge(edge);
  return draft;
}

std::shared_ptr<const Surface> make_charted_surface(PlacedAtlas atlas, ChartMesh realised,
                                                    const RunContext& context) {
  return std::make_shared<ChartedSurface>(std::move(atlas), std::move(realised), context);
}

}  // namespace burin
