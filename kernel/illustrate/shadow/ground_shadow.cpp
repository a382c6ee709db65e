#include "ground_shadow.h"

#include <burin/area/partition.h>
#include <burin/drawing/bezier.h>
#include <burin/illustrate/ground.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

// mm of the light's sheet. Points so near the line through the others are left out.
constexpr double kShadowTolerance = 0.01;
// A line is looked at in pieces of this length.
constexpr double kPiece = 3;
// Where the light is looked for beside a line: in narrow gaps, and beyond facets that bulge.
constexpr std::array<double, 4> kBeside = {0.4, -0.4, 0.1, -0.1};
// Within which lines and rays agree on a border: chord errors.
constexpr double kShadowSlack = 0.04;

/// Whether the light meets nothing through a place of its sheet.
using Passes = std::function<bool(Vec2)>;

Passes passes_by(const Occluder& occluder, const Camera& from) {
  const double back = 2 * occluder.diagonal();
  return [&occluder, &from, back](Vec2 at) {
    const ViewRay ray = from.ray(at);
    return !occluder.occluded(ray.origin - back * ray.direction, ray.direction, 0, 2 * back);
  };
}

/// The lines of a light's sheet beside which it passes: few, of all outlines.
class Edges {
 public:
  explicit Edges(const Passes& passes) : passes_(passes) {}

  void add(std::span<const Vec2> line) {
    std::vector<Vec2> points;
    std::vector<bool> open, corner;  // of the piece that ends at a point; of the point
    for (const std::size_t i : simplify(line, kShadowTolerance)) {
      if (points.empty()) {
        points.push_back(line[i]);
        open.push_back(false);
        corner.push_back(true);
        continue;
      }
      const Vec2 a = points.back(), b = line[i];
      const auto n = static_cast<int>(std::clamp(glm::distance(a, b) / kPiece, 0.0, 1e3)) + 1;
      for (int k = 1; k <= n; ++k) {
        points.push_back(glm::mix(a, b, static_cast<double>(k) / n));
        open.push_back(is_open(points[points.size() - 2], points.back()));
        corner.push_back(k == n);
      }
    }
    keep(points, open, corner);
  }

  std::vector<BorderLine> get() const {
    std::vector<BorderLine> out;
    for (const std::vector<Vec2>& line : lines_) out.push_back({line});
    return out;
  }

 private:
  bool is_open(Vec2 a, Vec2 b) const {
    const double length = glm::distance(a, b);
    if (length <= 0) return false;
    const Vec2 across = Vec2(a.y - b.y, b.x - a.x) / length, middle = 0.5 * (a + b);
    return std::ranges::any_of(kBeside, [&](double off) { return passes_(middle + off * across); });
  }

  /// Open pieces, and those next to them, which may be so in part; straight ones as one.
  void keep(const std::vector<Vec2>& points, const std::vector<bool>& open,
            const std::vector<bool>& corner) {
    bool going_on = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool kept = open[i] || open[i - 1] || (i + 1 < points.size() && open[i + 1]);
      if (kept && !going_on) lines_.push_back({points[i - 1]});
      const bool straight_on = kept && going_on && !corner[i - 1];
      if (straight_on) lines_.back().back() = points[i];
      if (kept && !straight_on) lines_.back().push_back(points[i]);
      going_on = kept;
    }
  }

  const Passes& passes_;
  std::vector<std::vector<Vec2>> lines_;
};

/// Adds the stretches of an outline that something may be seen beside.
void add_outline(const Curve3& curve, const Camera& from, Edges& edges) {
  std::vector<Vec2> line;
  const auto end = [&] {
    if (line.size() > 1) edges.add(line);
    line.clear();
  };
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    if (!curve.self_hidden.empty() && curve.self_hidden[i] != 0) {
      end();
      continue;
    }
    if (line.empty()) line.push_back(from.to_paper(curve.points[i]));
    line.push_back(from.to_paper(curve.points[curve.next(i)]));
  }
  end();
}

/// What of a ring lies clearly before the viewer, who may stand in the shadow.
std::vector<Vec3> before_viewer(const std::vector<Vec3>& ring, const Camera& camera) {
  constexpr double kNearest = 0.98;  // of the way to the viewer
  if (!camera.perspective()) return ring;
  const double most = kNearest * camera.depth(camera.eye());
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double u = most - camera.depth(a), v = most - camera.depth(b);
    if (u >= 0) out.push_back(a);
    if ((u >= 0) != (v >= 0)) out.push_back(glm::mix(a, b, u / (u - v)));
  }
  return out;
}

/// Glass stands on the ground too.
double lowest(const Occluders& occluders) {
  Box3 bounds;
  for (const ProxyMesh* proxy : occluders.proxies()) bounds.add(proxy->mesh.bounds());
  return bounds.min.z;
}

}  // namespace

std::optional<Area> ground_shadow(const Occluders& occluders, const LightView& light,
                                  const Camera& camera, const RunContext& context) {
  const Vec3 to_light = light.camera.direction();
  if (!casts_ground_shadow(to_light, camera.direction())) return std::nullopt;
  const Passes passes = passes_by(occluders.solid(), light.camera);
  Edges edges(passes);
  for (const Curve3& curve : light.outlines) add_outline(curve, light.camera, edges);
  const auto label_at = [&](Vec2 at) { return AreaLabel{.part = passes(at) ? -1 : 0}; };
  const Paper& paper = light.camera.paper();
  const Box2 sheet{Vec2(0), Vec2(paper.width, paper.height)};
  const Partition parted =
      partition(sheet, edges.get(), label_at, {.slack = kShadowSlack, .rounds = 1}, context);
  const Placement down = onto_ground(to_light, lowest(occluders));
  Area shadow;
  for (const AreaRegion& region : parted.regions) {
    if (region.label.part < 0) continue;
    for (const AreaRing& ring : region.rings) {
      std::vector<Vec3> on_ground;
      for (const Vec2& p : parted.polygon(ring)) {
        on_ground.push_back(down.point(light.camera.ray(p).origin));
      }
      std::vector<Vec2> points;
      for (const Vec3& p : before_viewer(on_ground, camera)) points.push_back(camera.to_paper(p));
      if (points.size() > 2) shadow.rings.push_back(std::move(points));
    }
  }
  if (shadow.rings.empty()) return std::nullopt;
  return shadow;
}

}  // namespace burin::detail
