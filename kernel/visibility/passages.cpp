#include "passages.h"

#include "probe.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burin {
namespace {

// Sine of the angle between two sheets from which one passes through the other; below it they are
// in contact, as for the lines of intersection.
constexpr double kTransversal = 0.24;
// Cosine between a sheet and the view below which it is seen edge-on.
constexpr double kEdgeOn = 0.05;
// Paper mm along the curve within which it gets clear of the sheet.
constexpr double kClearReach = 2;

class Finder {
 public:
  Finder(const Probe& probe, const Curve3& curve, const Track& track)
      : probe_(probe), curve_(curve), track_(track) {}

  std::vector<Passage> run() {
    for (std::size_t i = 0; i < curve_.segment_count(); ++i) cross(i);
    std::ranges::stable_sort(found_, {}, &Passage::at);
    return std::move(found_);
  }

 private:
  void cross(std::size_t segment) {
    const std::size_t next = curve_.next(segment);
    const Vec3 a = curve_.points[segment], d = curve_.points[next] - a;
    const double length = glm::length(d);
    if (!(length > probe_.occluder().resolution())) return;
    const Vec3 normal = normalize_or(curve_.normals[segment] + curve_.normals[next], Vec3(0));
    hits_.clear();
    probe_.occluder().occluded_by(a, d / length, 0, length, [&](const Hit& hit) {
      if (transversal(hit, normal) && !ends_at_cut(hit, a, normal)) hits_.push_back(hit);
      return false;
    });
    // They come in the order of the tree, which differs between processors.
    std::ranges::sort(hits_, {}, [](const Hit& hit) {
      return std::tuple(hit.distance, hit.where.part, hit.where.face);
    });
    for (const Hit& hit : hits_) add(segment, hit, hit.distance / length);
  }

  bool transversal(const Hit& hit, Vec3 normal) const {
    const Vec3 n = probe_.proxy(hit.where.part)->normal(hit.where.face, hit.bary);
    return glm::length(glm::cross(n, normal)) > kTransversal;
  }

  /// Whether it is a wall of a part that the plane of a hatching cuts, too: what of it was before
  /// the plane is gone, and the rest hides nothing there.
  bool ends_at_cut(const Hit& hit, Vec3 on_plane, Vec3 normal) const {
    if (curve_.kind != LineClass::Pattern) return false;
    const TriMesh& mesh = probe_.proxy(hit.where.part)->mesh;
    const double untold = kOnPlane * probe_.occluder().resolution();
    return std::ranges::all_of(mesh.triangles[hit.where.face], [&](std::uint32_t corner) {
      return glm::dot(mesh.positions[corner] - on_plane, normal) <= untold;
    });
  }

  void add(std::size_t segment, const Hit& hit, double share) {
    const ProxyMesh& proxy = *probe_.proxy(hit.where.part);
    const Vec3 at = proxy.position(hit.where.face, hit.bary);
    const Vec3 n = proxy.mesh.normal(hit.where.face);
    const double clear =
        kOnPlane * probe_.occluder().resolution() +
        probe_.chord_error(hit.where.part, static_cast<std::int32_t>(hit.where.face)) +
        probe_.chord_error(curve_.source.part, curve_.faces[segment]);
    const double after = side(segment, share, at, n, +1, clear);
    const double before = side(segment, share, at, n, -1, clear);
    if (!(before * after < 0)) return;
    const double facing = glm::dot(n, probe_.camera().to_viewer(at));
    Passage p{static_cast<double>(segment) + share};
    if (std::abs(facing) > kEdgeOn) {
      p.hidden_before = before * facing < 0;
      p.hidden_after = after * facing < 0;
    }
    found_.push_back(p);
  }

  /// On which side of the sheet's plane the curve gets clear of it, going forth or back; 0 where it
  /// does not, or ends before.
  double side(std::size_t segment, double share, Vec3 at, Vec3 n, int step, double clear) const {
    const std::size_t count = curve_.points.size();
    Vec2 from = track_.start(segment) + share * (track_.end(segment) - track_.start(segment));
    double travelled = 0;
    std::size_t i = step > 0 ? curve_.next(segment) : segment;
    for (std::size_t k = 0; k < count && travelled < kClearReach; ++k) {
      const double off = glm::dot(curve_.points[i] - at, n);
      if (std::abs(off) > clear) return off;
      const Vec2 here = track_.point(i);
      travelled += glm::distance(from, here);
      from = here;
      const bool last = step > 0 ? i + 1 == count : i == 0;
      if (last && !curve_.closed) return 0;
      i = step > 0 ? curve_.next(i) : (i == 0 ? count : i) - 1;
    }
    return 0;
  }

  const Probe& probe_;
  const Curve3& curve_;
  const Track& track_;
  std::vector<Hit> hits_;
  std::vector<Passage> found_;
};

}  // namespace

std::vector<Passage> find_passages(const Probe& probe, const Curve3& curve, const Track& track) {
  if (!lies_on_surface(curve) || curve.normals.empty() || curve.faces.empty()) return {};
  return Finder(probe, curve, track).run();
}

}  // namespace burin
