#include <burin/base/bracketed_zero.h>
#include <burin/camera/facing.h>
#include <burin/feature/isophotes.h>
#include <burin/feature/light_normals.h>
#include <burin/feature/source_faces.h>

#include "fairing.h"
#include "paper_limits.h"
#include "zero_lines.h"
#include "zero_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

/// By how much levels are too high: as much as what is edge-on is turned away.
constexpr double kAboveLevel = kEdgeOn;

/// Steps towards the zero inside a triangle: each leaves a tenth of the way or less.
constexpr int kSettlings = 3, kBorderSettlings = 1;
/// Square of the cosines' difference below which a triangle is as light all over: there is nowhere
/// to step to.
constexpr double kLeastSlope = 1e-18;

/// normal . light - level.
class Isophote : public ZeroSet {
 public:
  Isophote(const ProxyMesh& proxy, const Camera& camera, const IsophoteOptions& options)
      : ZeroSet(proxy, camera),
        exact_(options.exact),
        border_(options.border),
        normals_(options.normals.empty() ? proxy.wedge_normal : options.normals) {}

  /// `back`: the light falls on the backs.
  void look(Vec3 light, double level, bool back) {
    light_ = back ? -light : light;
    level_ = level;
    for (std::size_t w = 0; w < g_.size(); ++w) {
      g_[w] = glm::dot(normals_[w], light_) - level_;
    }
  }
  /// Leaves out triangles that nobody can see.
  void leave_far_side(const FacingFunction& facing, bool back) {
    std::vector<bool> away(proxy_->wedge_normal.size());
    for (std::uint32_t w = 0; w < away.size(); ++w) {
      const Vec3& n = proxy_->wedge_normal[w];
      away[w] = facing(proxy_->wedge_position(w), back ? -n : n) <= 0;
    }
    decided_.assign(proxy_->wedges.size(), 0);
    for (std::size_t f = 0; f < decided_.size(); ++f) {
      const Triangle& w = proxy_->wedges[f];
      if (away[w[0]] && away[w[1]] && away[w[2]]) decided_[f] = -1;
    }
  }

  bool is_straight() const override { return border_; }
  bool is_straight(std::uint32_t face, double length) const override {
    if (!border_) return false;
    const Triangle& w = proxy_->wedges[face];
    const Vec3 &a = normals_[w[0]], &b = normals_[w[1]], &c = normals_[w[2]];
    const double bend = 1 - std::min({glm::dot(a, b), glm::dot(b, c), glm::dot(c, a)});
    // An arc of that bend is off its chord by an eighth of it.
    return length * std::sqrt(2 * std::max(bend, 0.0)) < 4 * kRoundness;
  }
  Vec3 between(const RoundedFacet& facet, Vec3 bary) const override {
    const std::uint32_t face = facet.face();
    const Triangle& w = proxy_->wedges[face];
    Vec3 across(g_[w[0]], g_[w[1]], g_[w[2]]);
    across -= (across.x + across.y + across.z) / 3;
    const double slope = glm::dot(across, across);  // of what is linear; the rest is small
    const int settlings = border_ ? kBorderSettlings : kSettlings;
    for (int k = 0; k < settlings && slope > kLeastSlope; ++k) {
      bary -= (glm::dot(normal_at(face, bary), light_) - level_) / slope * across;
      bary = glm::max(bary, Vec3(0));
      bary /= bary.x + bary.y + bary.z;
    }
    return exact_ ? exact_(face, bary).position : facet.at(bary);
  }

 protected:
  double zero_share(std::uint32_t a, std::uint32_t b, HalfEdge h) const override {
    const HalfEdge one = of_both(h);
    const bool back = origin(proxy_->mesh, one) != proxy_->wedge_vertex[a];
    const auto over = [&](double t) {
      const Vec3 normal = normal_at(face_of(one), bary_on(one, back ? 1 - t : t));
      return glm::dot(normal, light_) - level_;
    };
    return border_ ? bracketed_zero(over, g_[a], g_[b], {.bracket = 1e-4, .value = 1e-6})
                   : bracketed_zero(over, g_[a], g_[b], {.bracket = 1e-9, .value = 1e-12});
  }
  Vec3 on_edge(HalfEdge h, double t) const override {
    if (!exact_) return ZeroSet::on_edge(h, t);
    const HalfEdge one = of_both(h);
    const bool back = origin(proxy_->mesh, one) > origin(proxy_->mesh, next_in_face(one));
    return exact_(face_of(one), bary_on(one, back ? 1 - t : t)).position;
  }

 private:
  /// The same for both triangles at an edge.
  HalfEdge of_both(HalfEdge h) const {
    const HalfEdge other = proxy_->topology.opposite[static_cast<std::size_t>(h)];
    return other == kNoHalfEdge ? h : std::min(h, other);
  }
  Vec3 normal_at(std::uint32_t face, Vec3 bary) const {
    return exact_ ? exact_(face, bary).normal : light_normal(*proxy_, normals_, face, bary);
  }

  Vec3 light_{0};
  double level_ = 0;
  const ExactAt& exact_;
  bool border_;
  std::span<const Vec3> normals_;
};

double paper_length(const Camera& camera, const Curve3& curve) {
  double length = 0;
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    length += glm::distance(camera.to_paper(curve.points[i]),
                            camera.to_paper(curve.points[curve.next(i)]));
  }
  return length;
}

/// Marks what faces away, from the very points where that changes.
void hide_far_side(const FacingFunction& facing, double sign, Curve3& curve) {
  Curve3 out = curve;
  out.points.clear(), out.normals.clear(), out.faces.clear(), out.self_hidden.clear();
  const auto g = [&](std::size_t i) { return facing(curve.points[i], sign * curve.normals[i]); };
  const auto add = [&](Vec3 point, Vec3 normal, std::size_t segment, bool hidden) {
    out.points.push_back(point);
    out.normals.push_back(normal);
    out.faces.push_back(curve.faces[segment]);
    out.self_hidden.push_back(hidden ? 1 : 0);
  };
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    const std::size_t j = curve.next(i);
    const double a = g(i), b = g(j);
    const bool crosses = (a > 0) != (b > 0) && a != 0 && b != 0;
    add(curve.points[i], curve.normals[i], i, crosses ? a < 0 : a + b <= 0);
    if (!crosses) continue;
    const double t = a / (a - b);
    add(glm::mix(curve.points[i], curve.points[j], t),
        normalize_or(glm::mix(curve.normals[i], curve.normals[j], t), curve.normals[i]), i, b < 0);
  }
  if (!curve.closed) {
    out.points.push_back(curve.points.back());
    out.normals.push_back(curve.normals.back());
  }
  curve = std::move(out);
}

}  // namespace

std::vector<double> even_levels(std::size_t steps) {
  std::vector<double> levels;
  for (std::size_t i = 1; i < steps; ++i) {
    levels.push_back(static_cast<double>(i) / static_cast<double>(steps) + kAboveLevel);
  }
  return levels;
}

std::int32_t step_of(const Isophotes& isophotes, Vec3 normal) {
  const double light = glm::dot(normal, isophotes.light) / glm::length(isophotes.light);
  return static_cast<std::int32_t>(std::ranges::lower_bound(isophotes.levels, light) -
                                   isophotes.levels.begin());
}

std::vector<Curve3> trace_isophotes(const ProxyMesh& proxy, std::int32_t part,
                                    const Isophotes& isophotes, const Camera& camera,
                                    const RunContext& context, const IsophoteOptions& options) {
  const Vec3 light = normalize_or(isophotes.light, camera.direction());
  const FacingFunction facing(camera);
  const auto& closed = proxy.topology.component_closed;
  const bool any_open = std::ranges::find(closed, 0) != closed.end();
  std::vector<Curve3> out;
  if (isophotes.levels.empty() || proxy.mesh.triangles.empty()) return out;
  Isophote zeros(proxy, camera, options);
  if (options.border) zeros.leave_far_side(facing, false);
  for (const double level : isophotes.levels) {
    for (const bool back : {false, true}) {
      if (back && !any_open) continue;
      if (options.border && any_open) zeros.leave_far_side(facing, back);
      zeros.look(light, level, back);
      trace_zeros(zeros, true, context, [&](ZeroLine&& line) {
        if (back && proxy.closed(line.first_face)) return;
        Curve3 curve = line.take_curve(zeros, LineClass::Isophote, part);
        std::vector<std::uint8_t> none(curve.faces.size(), 0);
        follow_surface(zeros, line.chords, curve, none);
        if (curve.closed && paper_length(camera, curve) < kSpeckLength) return;
        if (!options.exact && !options.border) fair(curve, camera, proxy);
        hide_far_side(facing, back ? -1 : 1, curve);
        if (!options.border && !proxy.source_face.empty()) {
          curve.source.face = main_face(source_faces(curve, proxy, camera));
        }
        out.push_back(std::move(curve));
      });
    }
  }
  return out;
}

}  // namespace burin
