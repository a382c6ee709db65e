#include <burin/base/error.h>
#include <burin/surface/composite_surface.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// `from`, raised by `by` where it is no "none".
template <class T>
void append_raised(std::vector<T>& to, const std::vector<T>& from, T by) {
  for (const T i : from) to.push_back(i < 0 ? i : i + by);
}

void append_raised(std::vector<Triangle>& to, const std::vector<Triangle>& from, std::size_t by) {
  const auto n = static_cast<std::uint32_t>(by);
  for (const Triangle& t : from) to.push_back({t[0] + n, t[1] + n, t[2] + n});
}

/// The array of a piece, or as many zeros where it has none.
template <class T>
void append_or_zeros(std::vector<T>& to, const std::vector<T>& from, std::size_t count) {
  if (from.empty()) {
    to.resize(to.size() + count, T(0));
  } else {
    append(to, from);
  }
}

void append(ProxyMesh& all, const ProxyMesh& p) {
  const auto faces = static_cast<std::int32_t>(all.mesh.triangles.size());
  const auto components = static_cast<std::int32_t>(all.topology.component_closed.size());
  append_raised(all.wedges, p.wedges, all.wedge_vertex.size());
  for (const std::uint32_t v : p.wedge_vertex) {
    all.wedge_vertex.push_back(v + static_cast<std::uint32_t>(all.mesh.positions.size()));
  }
  append_raised(all.mesh.triangles, p.mesh.triangles, all.mesh.positions.size());
  append(all.mesh.positions, p.mesh.positions);
  append_raised(all.topology.opposite, p.topology.opposite, 3 * faces);
  append_raised(all.topology.face_component, p.topology.face_component, components);
  append(all.topology.component_closed, p.topology.component_closed);
  append(all.edge_kind, p.edge_kind);
  append(all.wedge_normal, p.wedge_normal);
  append_raised(all.face_region, p.face_region, all.region_count);
  all.region_count += p.region_count;
  append(all.wedge_sagitta, p.wedge_sagitta);
  all.tolerance = std::max(all.tolerance, p.tolerance);
  append(all.source_face, p.source_face);
  const std::size_t half_edges = 3 * p.mesh.triangles.size();
  if (p.source_edge.empty()) {
    all.source_edge.resize(all.source_edge.size() + half_edges, -1);
  } else {
    append(all.source_edge, p.source_edge);
  }
  append_or_zeros(all.seam, p.seam, half_edges);
  append_or_zeros(all.on_contour, p.on_contour, p.wedge_vertex.size());
}

class CompositeSurface final : public Surface {
 public:
  explicit CompositeSurface(std::vector<std::shared_ptr<const Surface>> pieces)
      : pieces_(std::move(pieces)) {
    for (const auto& piece : pieces_) {
      first_face_.push_back(static_cast<std::uint32_t>(proxy_.mesh.triangles.size()));
      append(proxy_, piece->proxy());
    }
  }

  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override {
    const std::size_t i = piece_of(from.triangle);
    MarchStep step = pieces_[i]->march(inner(from, i), tangent, length);
    step.end.triangle += first_face_[i];
    return step;
  }
  Frame frame(const SurfacePoint& point) const override {
    const std::size_t i = piece_of(point.triangle);
    return pieces_[i]->frame(inner(point, i));
  }
  std::optional<Vec2> parameters(const SurfacePoint& point) const override {
    const std::size_t i = piece_of(point.triangle);
    return pieces_[i]->parameters(inner(point, i));
  }
  /// Loose faces beside exact ones are freeform faces of them.
  bool exact() const override {
    return std::ranges::any_of(pieces_, [](const auto& piece) { return piece->exact(); });
  }
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint& point) const override {
    const std::size_t i = piece_of(point.triangle);
    ProxyPoint p = pieces_[i]->to_proxy(inner(point, i));
    p.face += first_face_[i];
    return p;
  }
  SurfacePoint lift(const ProxyPoint& point) const override {
    const std::size_t i = piece_of(point.face);
    SurfacePoint p = pieces_[i]->lift({point.face - first_face_[i], point.bary});
    p.triangle += first_face_[i];
    return p;
  }
  Vec3 drawn_position(const SurfacePoint& point) const override {
    const std::size_t i = piece_of(point.triangle);
    return pieces_[i]->drawn_position(inner(point, i));
  }
  std::vector<Frame> wedge_frames(const RunContext& context) const override {
    std::vector<Frame> all;
    for (const auto& piece : pieces_) append(all, piece->wedge_frames(context));
    return all;
  }

 private:
  std::size_t piece_of(std::uint32_t triangle) const {
    const auto next = std::upper_bound(first_face_.begin(), first_face_.end(), triangle);
    return static_cast<std::size_t>(next - first_face_.begin() - 1);
  }
  SurfacePoint inner(SurfacePoint p, std::size_t i) const {
    p.triangle -= first_face_[i];
    return p;
  }

  std::vector<std::shared_ptr<const Surface>> pieces_;
  std::vector<std::uint32_t> first_face_;
  ProxyMesh proxy_;
};

}  // namespace

std::shared_ptr<const Surface> make_composite_surface(
    std::vector<std::shared_ptr<const Surface>> pieces) {
  if (pieces.empty()) throw GeometryError("a surface of no pieces");
  if (pieces.size() == 1) return std::move(pieces.front());
  return std::make_shared<CompositeSurface>(std::move(pieces));
}

}  // namespace burin
