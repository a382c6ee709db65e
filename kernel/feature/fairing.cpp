#include "fairing.h"

#include <burin/mesh/chord_error.h>

#include "paper_limits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace burin {

namespace {

/// Model mm that the exact line may lie beside a segment, by the triangle of that.
using Most = std::function<double(std::int32_t)>;

class Rounder {
 public:
  Rounder(const Curve3& curve, const Camera& camera, Most most, bool on_curve)
      : in_(curve),
        camera_(camera),
        most_(std::move(most)),
        far_enough_(on_curve ? kFarEnoughOnCurve : kFarEnough) {}

  Curve3 run() {
    Curve3 out = in_;
    out.points.clear();
    out.normals.clear();
    out.faces.clear();
    out.self_hidden.clear();
    for (std::size_t i = 0; i < in_.segment_count(); ++i) segment(i, out);
    if (!in_.closed) {
      out.points.push_back(in_.points.back());
      out.normals.push_back(in_.normals.back());
    }
    return out;
  }

 private:
  std::size_t size() const { return in_.points.size(); }

  // The nearest point before (step = -1) or after (+1) point i that is far enough away to tell a
  // direction: the ends of very short segments, at edges crossed close to a vertex, do not.
  std::optional<std::size_t> far_point(std::size_t i, int step, double length) const {
    for (std::size_t k = 1; k < std::min(size(), kFewPoints); ++k) {
      if (!in_.closed && (step < 0 ? k > i : i + k >= size())) return std::nullopt;
      const std::size_t j = step < 0 ? (i + size() - k) % size() : (i + k) % size();
      if (glm::distance(in_.points[j], in_.points[i]) >= far_enough_ * length) return j;
    }
    return std::nullopt;
  }

  // Whether the curve goes on from point i in much finer steps than a segment of this length.
  bool much_finer(std::size_t i, int step, double length) const {
    const std::size_t k = kFewPoints - 1;
    if (size() <= k || (!in_.closed && (step < 0 ? k > i : i + k >= size()))) return false;
    const std::size_t j = step < 0 ? (i + size() - k) % size() : (i + k) % size();
    return glm::distance(in_.points[j], in_.points[i]) < kFarEnough * length;
  }

  // The unit tangent at the end `i` of a segment towards its other end `other`; nothing at a
  // corner.
  std::optional<Vec3> tangent(std::size_t i, std::size_t other, int away) const {
    const Vec3 chord = in_.points[other] - in_.points[i];
    const double length = glm::length(chord);
    const auto j = far_point(i, away, length);
    if (!j) return std::nullopt;
    const Vec3 back = in_.points[i] - in_.points[*j];
    const double before = glm::length(back);
    if (glm::dot(chord, back) < kSmoothTurn * length * before) return std::nullopt;
    // Of the parabola through the three points.
    return normalize_or(back / before * length + chord / length * before, chord / length);
  }

  // Turns the tangents towards the segment until the cubic lies hardly farther from it than the
  // exact line may: beside segments of very different lengths they are guesses.
  void keep_near(Vec3 unit, double length, double most, Vec3& from, Vec3& to) const {
    constexpr double kMostOfOneEnd = 4.0 / 27;  // of s s t
    constexpr double kBeyond = 2;  // the sum is more than the cubic's, and the error an estimate
    const double off = kMostOfOneEnd * length * (glm::length(from - unit) + glm::length(to - unit));
    if (off <= kBeyond * most) return;
    from = unit + kBeyond * most / off * (from - unit);
    to = unit + kBeyond * most / off * (to - unit);
  }

  void segment(std::size_t i, Curve3& out) const {
    const std::size_t j = in_.next(i);
    const Vec3 p = in_.points[i], q = in_.points[j];
    const double length = glm::length(q - p);
    const auto at_p = tangent(i, j, -1), at_q = tangent(j, i, +1);
    std::size_t pieces = 1;
    // A missing end: the parabola that the other end asks for.
    const Vec3 unit = normalize_or(q - p, Vec3(1, 0, 0));
    Vec3 from = unit, to = unit;
    // Two points in one place have no direction.
    const bool straight = !(length > 0) || much_finer(i, -1, length) || much_finer(j, +1, length);
    if ((at_p || at_q) && !straight) {
      from = at_p ? *at_p : 2 * glm::dot(-*at_q, unit) * unit + *at_q;
      to = at_q ? -*at_q : 2 * glm::dot(*at_p, unit) * unit - *at_p;
      keep_near(unit, length, most_(in_.faces[i]), from, to);
      const double bulge = length * camera_.scale_at(p) / 8 * glm::length(to - from);
      pieces =
          static_cast<std::size_t>(std::clamp(std::ceil(std::sqrt(bulge / kRoundness)), 1.0, 16.0));
    }
    for (std::size_t k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(pieces), s = 1 - t;
      const Vec3 cubic =
          s * s * (1 + 2 * t) * p + t * t * (1 + 2 * s) * q + length * s * t * (s * from - t * to);
      out.points.push_back(k == 0 ? p : cubic);
      out.normals.push_back(
          k == 0 ? in_.normals[i]
                 : normalize_or(s * in_.normals[i] + t * in_.normals[j], in_.normals[i]));
      out.faces.push_back(in_.faces[i]);
      out.self_hidden.push_back(in_.self_hidden[i]);
    }
  }

  // Of the segment that is to be rounded. Points that lie on an exact curve tell its direction from
  // near by, and the better for it.
  static constexpr double kFarEnough = 0.25, kFarEnoughOnCurve = 0.1;
  // Where as many points lie nearer, the segment is a straight one beside a fine curve (a cone that
  // ends in a fillet).
  static constexpr std::size_t kFewPoints = 4;
  static constexpr double kSmoothTurn = 0.766;  // cosine of 40 degrees: a sharper turn is a corner

  const Curve3& in_;
  const Camera& camera_;
  Most most_;
  double far_enough_;
};

}  // namespace

void fair(Curve3& curve, const Camera& camera, const ProxyMesh& proxy) {
  if (curve.points.size() < 3) return;
  const double least = kUnseenBulge / camera.scale_at(curve.points.front());
  const auto most = [&](std::int32_t face) {
    return std::max(least, chord_error(proxy, static_cast<std::uint32_t>(face)));
  };
  curve = Rounder(curve, camera, most, false).run();
}

void fair(Curve3& curve, const Camera& camera, double most) {
  if (curve.points.size() < 3) return;
  curve = Rounder(
              curve, camera, [&](std::int32_t) { return most; }, std::isfinite(most))
              .run();
}

}  // namespace burin
