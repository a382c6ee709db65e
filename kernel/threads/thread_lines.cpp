#include <burin/mesh/cut_faces.h>
#include <burin/surface/tangent_basis.h>
#include <burin/threads/thread_lines.h>

#include "own_rays.h"
#include "runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace burin {
namespace {

using detail::OwnPlace;
using detail::OwnRays;

/// Sine of the angle between axis and view up to which a thread is seen along its axis.
constexpr double kEndOn = 0.02;
/// Of the radius: chord errors of the proxy, and shafts that are no exact cylinder.
constexpr double kSlack = 0.02;
/// Cosine between normal and axis from which a face is an end, no side: chamfers are below it.
constexpr double kEndFace = 0.95;
/// Of the radius: how far over a cut face a ray begins that asks whether it is there. Cut faces are
/// flat and exact.
constexpr double kOver = 1e-4;
/// Sine of the angle to an axis up to which a cut runs along it.
constexpr double kAlong = 1e-6;
/// Of the radius: how far beyond a thread's end its chamfer or its face may go on.
constexpr double kBeyond = 1.5;
/// How much farther a chamfer goes on for each mm that the thin lines are farther in: of 27 degrees
/// and more.
constexpr double kChamfer = 2;
/// Of the radius of the modelled cylinder: what the gap may take.
constexpr double kMostGap = 0.5;
/// Pieces of a straight line in which its ends are looked for, and of a circle.
constexpr int kPieces = 64, kRound = 180;

/// The lines of one thread.
class Lines {
 public:
  /// `thin`: the radius of the thin lines.
  Lines(const Thread& thread, double thin, std::int32_t part, const OwnRays& rays,
        const std::vector<CutFace>& cuts, const Camera& camera, std::vector<Curve3>& out)
      : thread_(thread),
        thin_(thin),
        beyond_(kChamfer * std::abs(thin - thread.thin())),
        part_(part),
        rays_(rays),
        cuts_(cuts),
        camera_(camera),
        out_(out) {}

  void draw() {
    outlines();
    for (const CutFace& cut : cuts_) in_cut(cut);
    draw_end(thread_.begin, -1, thread_.open_begin);
    draw_end(thread_.end, 1, thread_.open_end);
  }

 private:
  Vec3 at(double height) const { return thread_.axis.point + height * thread_.axis.along; }
  /// Chamfers go on where the thin lines are farther in than the thread.
  double begin() const { return thread_.begin - (thread_.open_begin ? beyond_ : 0); }
  double end() const { return thread_.end + (thread_.open_end ? beyond_ : 0); }
  double middle() const { return 0.5 * (thread_.begin + thread_.end); }

  bool seen_along(Vec3 point) const {
    return glm::length(glm::cross(camera_.to_viewer(point), thread_.axis.along)) < kEndOn;
  }

  /// The directions from the axis to the outlines of the cylinder of the thin lines.
  std::vector<Vec3> outline_directions() const {
    const Vec3 axis = thread_.axis.along, view = camera_.to_viewer(at(middle()));
    if (seen_along(at(middle()))) return {};
    if (!camera_.perspective()) {
      const Vec3 side = glm::normalize(glm::cross(axis, view));
      return {side, -side};
    }
    const Vec3 to_eye = thread_.axis.to(camera_.eye());
    const double away = glm::length(to_eye);
    if (away <= thin_) return {};
    // The planes through the eye that touch the cylinder.
    const double angle = std::acos(thin_ / away);
    const Vec3 near = to_eye / away, side = glm::cross(axis, near);
    return {std::cos(angle) * near + std::sin(angle) * side,
            std::cos(angle) * near - std::sin(angle) * side};
  }

  void outlines() {
    for (const Vec3& way : outline_directions()) {
      if (thread_.internal) {
        hidden_outline(way);
      } else {
        outline_over(way);
      }
    }
  }

  /// The place of the part's side that is seen over an outline.
  void outline_over(Vec3 way) {
    const Vec3 axis = thread_.axis.along, view = camera_.to_viewer(at(middle()));
    const double radius = thread_.modelled, thin = thin_;
    const double cosine = glm::dot(view, axis), sine = std::sqrt(1 - cosine * cosine);
    const double over = std::sqrt(std::max(0.0, radius * radius - thin * thin));
    const double slant = 2 * over * std::abs(cosine) / sine;
    detail::add_runs(
        begin() - slant, end() + slant, kPieces,
        [&](double height) -> std::optional<OwnPlace> {
          const Vec3 from = at(height) + thin * way;
          const auto place =
              rays_.out_of(from, camera_.to_viewer(from), 2 * (over / sine + kSlack * radius));
          if (!place || !on_side(*place)) return std::nullopt;
          return place;
        },
        line(LineClass::Thread), out_);
  }

  bool on_side(const OwnPlace& place) const {
    const double height = glm::dot(place.point - thread_.axis.point, thread_.axis.along);
    return height >= begin() && height <= end() &&
           std::abs(glm::dot(place.normal, thread_.axis.along)) < kEndFace &&
           glm::length(thread_.axis.to(place.point)) < (1 + kSlack) * thread_.modelled &&
           !rays_.proxy().is_cut(static_cast<std::uint32_t>(place.triangle));
  }

  /// Whether a point about a hole lies within the part.
  bool beside_hole(Vec3 axis_point, Vec3 way) const {
    const double thin = thin_;
    const auto place =
        rays_.out_of(axis_point + thin * way, -way, thin - (1 - kSlack) * thread_.modelled);
    return place && !rays_.proxy().is_cut(static_cast<std::uint32_t>(place->triangle));
  }

  void hidden_outline(Vec3 way) {
    detail::add_runs(
        begin(), end(), kPieces,
        [&](double height) -> std::optional<OwnPlace> {
          if (!beside_hole(at(height), way)) return std::nullopt;
          return OwnPlace{.point = at(height) + thin_ * way};
        },
        line(LineClass::Thread), out_);
  }

  /// The place of a cut face at a point.
  std::optional<OwnPlace> on_cut(const CutFace& cut, Vec3 point) const {
    const double over = kOver * thin_;
    auto place = rays_.first(point + over * cut.normal, -cut.normal, 2 * over);
    if (!place || !rays_.proxy().is_cut(static_cast<std::uint32_t>(place->triangle))) {
      return std::nullopt;
    }
    place->point = point;
    return place;
  }

  void in_cut(const CutFace& cut) {
    const double slope = glm::dot(cut.normal, thread_.axis.along);
    if (std::abs(slope) < kAlong) return along_cut(cut);
    round_in_cut(cut, slope);
  }

  /// A cut along the axis: two lines, and where the thread ends within the part a piece from each
  /// to the modelled cylinder.
  void along_cut(const CutFace& cut) {
    const double off = glm::dot(cut.normal, cut.point - thread_.axis.point);
    const double thin = thin_, modelled = thread_.modelled;
    if (std::abs(off) >= thin) return;
    const Vec3 foot = off * cut.normal;
    const Vec3 side = glm::normalize(glm::cross(thread_.axis.along, cut.normal));
    const double out = std::sqrt(thin * thin - off * off);
    const double in = std::sqrt(std::max(0.0, modelled * modelled - off * off));
    for (const double sense : {1.0, -1.0}) {
      const Vec3 way = foot + sense * out * side;
      detail::add_runs(
          begin(), end(), kPieces, [&](double height) { return on_cut(cut, at(height) + way); },
          line(LineClass::Thread), out_);
      for (const auto& [height, open] :
           {std::pair(thread_.begin, thread_.open_begin), {thread_.end, thread_.open_end}}) {
        if (open) continue;
        const Vec3 from = at(height) + foot;
        detail::add_runs(
            std::min(in, out), std::max(in, out), 8,
            [&](double r) { return on_cut(cut, from + sense * r * side); },
            line(LineClass::ThreadEnd), out_);
      }
    }
  }

  /// Three quarters of what a cut across the axis meets.
  void round_in_cut(const CutFace& cut, double slope) {
    const double height = glm::dot(cut.normal, cut.point - thread_.axis.point) / slope;
    round(LineClass::Thread, height, [&](Vec3 way) -> std::optional<OwnPlace> {
      const Vec3 out = thin_ * way;
      const double h = height - glm::dot(cut.normal, out) / slope;
      if (h <= begin() || h >= end()) return std::nullopt;
      return on_cut(cut, at(h) + out);
    });
  }

  void draw_end(double height, double out, bool open) {
    const double length = thread_.end - thread_.begin;
    if (open) {
      const bool along = seen_along(at(height));
      const double within = std::min(0.5 * length, thin_);
      const double far = within + kBeyond * thread_.modelled;
      return round(LineClass::Thread, height, [&](Vec3 way) -> std::optional<OwnPlace> {
        const auto place =
            rays_.out_of(at(height - out * within) + thin_ * way, out * thread_.axis.along, far);
        const bool there =
            place && !rays_.proxy().is_cut(static_cast<std::uint32_t>(place->triangle));
        // Across a chamfer it is a line among others, but for who looks along the axis.
        const bool flat = there && std::abs(glm::dot(place->normal, thread_.axis.along)) > kEndFace;
        if (!there || !(flat || along)) return std::nullopt;
        return place;
      });
    }
    // At the end itself a ray may meet a shoulder.
    const double before = height - out * 1e-6 * length;
    round(LineClass::ThreadEnd, height, [&](Vec3 way) { return on_wall(height, before, way); });
    if (!thread_.internal) return;
    round(LineClass::ThreadEnd, height, [&](Vec3 way) -> std::optional<OwnPlace> {
      if (!beside_hole(at(before), way)) return std::nullopt;
      return OwnPlace{.point = at(height) + thin_ * way};
    });
  }

  /// The place of the modelled cylinder in a direction from the axis.
  std::optional<OwnPlace> on_wall(double height, double before, Vec3 way) const {
    const double thin = thin_, out = thread_.internal ? -1 : 1;
    const double far = std::abs(thread_.modelled - thin) + kSlack * thread_.modelled;
    auto place = rays_.out_of(at(before) + thin * way, out * way, far);
    if (!place || rays_.proxy().is_cut(static_cast<std::uint32_t>(place->triangle))) {
      return std::nullopt;
    }
    place->point = at(height) + thread_.modelled * way;
    place->normal = out * way;
    return place;
  }

  /// Of a thread three quarters of a circle, from where the quarter that is open ends; else all.
  template <class Place>
  void round(LineClass kind, double height, const Place& place) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const Vec3 axis = thread_.axis.along;
    const Vec3 towards = camera_.to_viewer(at(height));
    const Vec3 normal = glm::dot(axis, towards) < 0 ? -axis : axis;
    const Vec3 corner = reject(camera_.right() + camera_.up(), normal);
    // Where the corner of the sheet lies along the axis its right side does not.
    const Vec3 open = glm::length(corner) > kEndOn ? corner : reject(camera_.right(), normal);
    const TangentBasis across(normal, glm::normalize(open));
    const double from = kind == LineClass::Thread ? kTurn / 8 : 0;
    detail::add_runs(
        from, kTurn - from, kRound,
        [&](double angle) {
          return place(across.vector({std::cos(angle), std::sin(angle)}));
        },
        line(kind), out_, kind == LineClass::ThreadEnd);
  }

  Curve3 line(LineClass kind) const {
    Curve3 curve;
    curve.kind = kind;
    curve.source = {.part = part_, .face = thread_.face};
    return curve;
  }

  const Thread& thread_;
  double thin_, beyond_;
  std::int32_t part_;
  const OwnRays& rays_;
  const std::vector<CutFace>& cuts_;
  const Camera& camera_;
  std::vector<Curve3>& out_;
};

/// The radius of the thin lines; nothing where the sheet has no room for them.
std::optional<double> thin_on_sheet(const Thread& thread, double gap, const Camera& camera) {
  const Vec3 middle = thread.axis.point + 0.5 * (thread.begin + thread.end) * thread.axis.along;
  const double least = gap / camera.scale_at(middle);
  if (least > kMostGap * thread.modelled) return std::nullopt;
  return thread.internal ? std::max(thread.thin(), thread.modelled + least)
                         : std::min(thread.thin(), thread.modelled - least);
}

}  // namespace

std::vector<Curve3> thread_lines(std::span<const DrawnThreads> threads,
                                 std::span<const ProxyMesh* const> proxies, const Camera& camera,
                                 Diagnostics& diagnostics, const RunContext& context) {
  std::vector<Curve3> out;
  std::int64_t small = 0;
  for (std::size_t part = 0; part < threads.size(); ++part) {
    const ProxyMesh& proxy = *proxies[part];
    if (threads[part].threads.empty() || proxy.mesh.triangles.empty()) continue;
    const OwnRays rays(proxy, context);
    const std::vector<CutFace> cuts = cut_faces(proxy);
    for (const Thread& thread : threads[part].threads) {
      context.check();
      if (thread.face < 0 || !(thread.end > thread.begin)) continue;
      const auto thin = thin_on_sheet(thread, threads[part].gap, camera);
      if (!thin) {
        ++small;
        continue;
      }
      Lines(thread, *thin, static_cast<std::int32_t>(part), rays, cuts, camera, out).draw();
    }
  }
  if (small > 0) {
    diagnostics.add(Severity::Info, "threads.small", small,
                    fmt::format("{} thread{} too small on paper for thin lines and {} none", small,
                                small == 1 ? " is" : "s are", small == 1 ? "has" : "have"));
  }
  return out;
}

}  // namespace burin
