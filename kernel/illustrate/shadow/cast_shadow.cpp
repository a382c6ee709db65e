#include "cast_shadow.h"

#include <burin/base/parallel.h>
#include <burin/base/smoothstep.h>
#include <burin/mesh/chord_error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

/// mm of the light's sheet between places of an outline that are thrown at first.
constexpr double kStep = 1;
/// Halvings of such a step on the way to where a shadow jumps or bends.
constexpr int kHalvings = 9;
/// Paper mm: a shadow is straight where its middle lies so near that of its ends.
constexpr double kStraight = 0.008;
/// Paper mm between two places of a shadow that no place of the outline lies between: where they
/// are farther apart it has jumped.
constexpr double kJump = 0.1;
/// mm of the light's sheet beside an outline within which its own sheet may stand before it: there
/// the zero of the normals is not the fold of the triangles, which hide (kernel/visibility).
constexpr double kOwnFold = 0.1;
/// Cosine to the light below which a plane is not looked for a place.
constexpr double kEdgeOnLight = 0.02;
/// Outlines that a thread throws in a row.
constexpr std::size_t kGrain = 4;

/// Whether a triangle stands for something round: normals at its corners are not its own.
bool is_round(const ProxyMesh& proxy, std::uint32_t face) {
  constexpr double kOwn = 1 - 1e-6;  // a cosine, of 0.08 degrees
  const Vec3 normal = proxy.mesh.normal(face);
  return std::ranges::any_of(proxy.wedges[face], [&](std::uint32_t w) {
    return glm::dot(proxy.wedge_normal[w], normal) < kOwn;
  });
}

/// Throws outlines of what casts onto what receives.
class Thrower {
 public:
  Thrower(const Occluders& occluders, const Occluder& casters, const Occluder& receivers,
          const LightView& light, const Camera& camera, std::span<const Isophotes> tones)
      : casters_(casters),
        receivers_(receivers),
        proxies_(occluders.solid_proxies()),
        to_light_(light.camera.direction()),
        light_scale_(light.camera.scale()),
        camera_(camera),
        tones_(tones),
        far_(2 * occluders.solid().diagonal()),
        least_(16 * occluders.solid().resolution()) {}

  void add(const Curve3& outline, std::vector<Curve3>& out) const {
    Run run(outline, out);
    for (std::size_t i = 0; i < outline.segment_count(); ++i) {
      if (!outline.self_hidden.empty() && outline.self_hidden[i] != 0) {
        run.close();
        continue;
      }
      add_segment(outline, i, run);
    }
    run.close();
  }

 private:
  /// The line that is being made.
  class Run {
   public:
    Run(const Curve3& outline, std::vector<Curve3>& out) : outline_(outline), out_(out) {}
    void extend(Vec3 from, Vec3 to) {
      if (points_.empty()) points_.push_back(from);
      points_.push_back(to);
    }
    void close() {
      if (points_.size() > 1) {
        Curve3 curve;
        curve.kind = LineClass::Isophote;
        curve.source.part = outline_.source.part;
        curve.points = std::move(points_);
        out_.push_back(std::move(curve));
      }
      points_.clear();
    }

   private:
    const Curve3& outline_;
    std::vector<Curve3>& out_;
    std::vector<Vec3> points_;
  };

  /// A side of an outline.
  struct Side {
    Vec3 a, b;
    /// Square to it and to the light, where nothing stands.
    Vec3 open;
    /// Model mm to the open side within which its own facets may stand.
    double off;
    Vec3 at(double t) const { return glm::mix(a, b, t); }
  };
  /// A place of a side, and where its shadow falls; nowhere also where it is in shadow itself.
  struct Thrown {
    double t;
    std::optional<Vec3> at;
    /// Whether a shadow there is none that is seen.
    bool lost = false;
  };

  void add_segment(const Curve3& outline, std::size_t i, Run& run) const {
    const auto side = side_of(outline, i);
    if (!side) return;  // seen end-on: the shadow of a point
    const double length = light_scale_ * glm::length(reject(side->b - side->a, to_light_));
    const auto pieces = static_cast<std::size_t>(std::clamp(length / kStep, 0.0, 1e4)) + 1;
    Thrown before = thrown(*side, 0);
    for (std::size_t k = 1; k <= pieces; ++k) {
      const Thrown after = thrown(*side, static_cast<double>(k) / static_cast<double>(pieces));
      join(*side, before, after, kHalvings, run);
      before = after;
    }
  }

  std::optional<Side> side_of(const Curve3& outline, std::size_t i) const {
    Side side{outline.points[i], outline.points[outline.next(i)], Vec3(0), least_};
    side.open = normalize_or(glm::cross(side.b - side.a, to_light_), Vec3(0));
    if (side.open == Vec3(0)) return std::nullopt;
    const std::int32_t face = outline.faces[i];
    Vec3 outward = outline.normals[i] + outline.normals[outline.next(i)];
    if (face >= 0) {
      const auto f = static_cast<std::uint32_t>(face);
      const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(outline.source.part)];
      side.off += 2 * chord_error(proxy, f);
      if (outline.kind == LineClass::Boundary) {
        outward = side.a - proxy.position(f, Vec3(1.0 / 3.0));
      }
    }
    if (glm::dot(side.open, outward) < 0) side.open = -side.open;
    return side;
  }

  Thrown thrown(const Side& side, double t) const {
    const Vec3 p = side.at(t);
    const auto lit = [&](double off) -> std::optional<Vec3> {
      const Vec3 beside = p + off * (side.open + to_light_);
      if (casters_.occluded(beside, to_light_, 0, far_)) return std::nullopt;
      return beside;
    };
    auto from = lit(side.off);
    if (!from) from = lit(side.off + kOwnFold / light_scale_);
    if (!from) return {t, {}};
    const auto hit = receivers_.first_hit(*from, -to_light_, 0, far_);
    if (!hit) return {t, {}};
    // Beside the outline something was met; the outline itself falls on the plane of that.
    const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(hit->where.part)];
    const Vec3 place = proxy.position(hit->where.face, hit->bary);
    const Vec3 normal = proxy.mesh.normal(hit->where.face);
    const bool lost = is_lost(hit->where, normal);
    const double slope = glm::dot(normal, to_light_);
    if (std::abs(slope) < kEdgeOnLight) return {t, place, lost};
    return {t, p - glm::dot(normal, p - place) / slope * to_light_, lost};
  }

  /// Whether a place has the darkest step all the same, or is one of a cut.
  bool is_lost(FaceRef where, Vec3 normal) const {
    // Of a round surface, by the cosine: how much more than its triangle a place of it may be lit.
    constexpr double kRound = 0.25, kFlat = 1e-3;
    const auto part = static_cast<std::size_t>(where.part);
    if (proxies_[part]->is_cut(where.face)) return true;
    const Isophotes& tone = tones_[part];
    if (!proxies_[part]->closed(where.face) && glm::dot(normal, to_light_) < 0) normal = -normal;
    const double more = is_round(*proxies_[part], where.face) ? kRound : kFlat;
    return glm::dot(normal, tone.light) / glm::length(tone.light) + more < tone.levels.front();
  }

  double on_paper(Vec3 a, Vec3 b) const { return glm::distance(a, b) * camera_.scale_at(a); }

  static void extend(const Thrown& a, const Thrown& b, Run& run) {
    if (a.lost && b.lost) return run.close();
    run.extend(*a.at, *b.at);
  }

  void join(const Side& side, const Thrown& a, const Thrown& b, int halvings, Run& run) const {
    if ((!a.at || a.lost) && (!b.at || b.lost)) return run.close();
    if (halvings == 0) {
      if (a.at && b.at && on_paper(*a.at, *b.at) < kJump) return extend(a, b, run);
      return run.close();
    }
    const Thrown m = thrown(side, 0.5 * (a.t + b.t));
    if (a.at && b.at && m.at && on_paper(*m.at, 0.5 * (*a.at + *b.at)) < kStraight) {
      return extend(a, b, run);
    }
    join(side, a, m, halvings - 1, run);
    join(side, m, b, halvings - 1, run);
  }

  const Occluder& casters_;
  const Occluder& receivers_;
  std::span<const ProxyMesh* const> proxies_;
  Vec3 to_light_;
  double light_scale_;
  const Camera& camera_;
  std::span<const Isophotes> tones_;
  double far_, least_;
};

}  // namespace

std::vector<Curve3> cast_shadows(const Occluders& occluders, const Occluders& casters,
                                 const LightView& light, const Camera& camera,
                                 std::span<const Isophotes> tones, const RunContext& context) {
  std::vector<const Occluder*> receivers{&occluders.solid()};
  // The light passes through parts that cast no shadow and have one themselves.
  if (&casters != &occluders) receivers.push_back(&casters.solid());
  std::vector<Curve3> out;
  for (const Occluder* onto : receivers) {
    const Thrower thrower(occluders, casters.solid(), *onto, light, camera, tones);
    const std::size_t n = light.outlines.size();
    std::vector<std::vector<Curve3>> of_each(n);
    parallel_for(
        n, kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) thrower.add(light.outlines[i], of_each[i]);
        },
        &context);
    for (std::vector<Curve3>& lines : of_each) std::ranges::move(lines, std::back_inserter(out));
  }
  return out;
}

bool in_shadow(const Occluders& occluders, const Occluder& casters, const ExactDepths& depths,
               const ViewHit& at, Vec3 to_light) {
  const FaceRef where{at.part, at.point.face};
  const ProxyMesh& proxy = *occluders.solid_proxies()[static_cast<std::size_t>(where.part)];
  Vec3 normal = proxy.mesh.normal(where.face);
  // Of sheets the side that the light falls on.
  if (!proxy.closed(where.face) && glm::dot(normal, to_light) < 0) normal = -normal;
  // A triangle that is itself hardly lit, though the round surface is, stands behind others of it.
  constexpr double kGrazing = 0.05, kSquare = 0.2;
  const double doubt = 1 - smoothstep(kGrazing, kSquare, glm::dot(normal, to_light));
  const double step = 4 * occluders.solid().resolution();
  const double off = step + doubt * 2 * chord_error(proxy, where.face);
  const Vec3 from = at.position + off * normal;
  const double far = 2 * occluders.solid().diagonal();
  if (!depths.needed()) return casters.occluded(from, to_light, 0, far);
  // Triangles of another part that stick out of this one, though its surface does not.
  const double reach = std::min(depths.reach(where, to_light), far);
  if (casters.occluded(from, to_light, reach, far)) return true;
  return casters.occluded_by(from, to_light, 0, reach, [&](const Hit& hit) {
    if (hit.where.part == where.part) return true;
    const double own = depths.depth(where, at.point.bary, at.position, from, to_light);
    return depths.depth(hit.where, hit.bary, from + hit.distance * to_light, from, to_light) >
           own + step + depths.flush(where, hit.where, to_light);
  });
}

}  // namespace burin::detail
