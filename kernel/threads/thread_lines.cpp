#include <burin/base/short_list.h>
#include <burin/camera/view_grid.h>
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
#include <set>
#include <string>
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
/// A chamfer's circle is at least this wide, of the cylinder of a screw, and at most this of the
/// thread in a hole; a chamfer is no steeper than 50 degrees to the end face.
constexpr double kLeastChamfer = 0.5, kMostChamfer = 1.1, kSteepest = 1.2;
/// Part of a mean normal that points from the axis or to it where a face is a chamfer, no bore.
constexpr double kOutwards = 0.1;
/// Pieces of a straight line in which its ends are looked for, and of a circle.
constexpr int kPieces = 64, kRound = 180;

bool is_along(Vec3 to_viewer, const Thread& thread) {
  return glm::length(glm::cross(to_viewer, thread.axis.along)) < kEndOn;
}

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

  bool seen_along(Vec3 point) const { return is_along(camera_.to_viewer(point), thread_); }

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
    // Who looks along the axis is not shown where the thread ends.
    if (seen_along(at(height))) return;
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

/// Whether a crease is the circle in which the chamfer of an open end meets the face there.
bool is_chamfer_circle(const Curve3& line, const Thread& thread, double end, double out) {
  if (line.kind != LineClass::Crease || line.normals.size() != line.points.size()) return false;
  const double sense = thread.internal ? -1 : 1;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec3 across = thread.axis.to(line.points[i]);
    const double radius = glm::length(across);
    const double high =
        out * (glm::dot(line.points[i] - thread.axis.point, thread.axis.along) - end);
    const double least =
        thread.internal ? (1 + kSlack) * thread.modelled : kLeastChamfer * thread.modelled;
    const double most =
        thread.internal ? kMostChamfer * thread.major : (1 - kSlack) * thread.modelled;
    if (radius < least || radius > most) return false;
    const double slant = kSteepest * std::abs(radius - thread.thin()) + kSlack * thread.modelled;
    if (std::abs(high) > slant) return false;
    if (sense * glm::dot(line.normals[i], across) < kOutwards * radius) return false;
  }
  return true;
}

/// ISO 6410 leaves out the circle of a chamfer where one looks along the axis: it would lie beside
/// the three quarters of a circle.
void leave_out_chamfers(std::span<const DrawnThreads> threads, const Camera& camera,
                        std::vector<Curve3>& features) {
  std::erase_if(features, [&](const Curve3& line) {
    const auto part = static_cast<std::size_t>(line.source.part);
    if (line.source.part < 0 || part >= threads.size()) return false;
    return std::ranges::any_of(threads[part].threads, [&](const Thread& thread) {
      const auto at_end = [&](double height, double out, bool open) {
        const Vec3 end = thread.axis.point + height * thread.axis.along;
        return open && !line.points.empty() && is_along(camera.to_viewer(end), thread) &&
               is_chamfer_circle(line, thread, height, out);
      };
      return at_end(thread.begin, -1, thread.open_begin) || at_end(thread.end, 1, thread.open_end);
    });
  });
}

/// The radius of the thin lines; nothing where the sheet has no room for them.
std::optional<double> thin_on_sheet(const Thread& thread, double gap, const Camera& camera) {
  const Vec3 middle = thread.axis.point + 0.5 * (thread.begin + thread.end) * thread.axis.along;
  const double least = gap / camera.scale_at(middle);
  if (least > kMostGap * thread.modelled) return std::nullopt;
  return thread.internal ? std::max(thread.thin(), thread.modelled + least)
                         : std::min(thread.thin(), thread.modelled - least);
}

}  // namespace

void add_thread_lines(std::span<const DrawnThreads> threads,
                      std::span<const ProxyMesh* const> proxies, const Camera& camera,
                      std::vector<Curve3>& features, Diagnostics& diagnostics,
                      const RunContext& context) {
  std::set<std::string> small;
  std::int64_t count = 0;
  double needed = 0;
  std::vector<DrawnThreads> large(threads.size());
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
        ++count;
        small.insert(thread.designation);
        needed = std::max(needed, threads[part].gap / (kMostGap * thread.modelled));
        continue;
      }
      large[part].threads.push_back(thread);
      Lines(thread, *thin, static_cast<std::int32_t>(part), rays, cuts, camera, features).draw();
    }
  }
  leave_out_chamfers(large, camera, features);
  if (count > 0) {
    diagnostics.add(
        Severity::Warning, "threads.small", count,
        fmt::format("{} thread{} ({}) too small on paper for thin lines and {} none; "
                    "from a scale of {} on {} some",
                    count, count == 1 ? " is" : "s are", short_list(small, 4),
                    count == 1 ? "has" : "have", scale_text(1 / standard_scale(1 / needed)),
                    count == 1 ? "it has" : "they have"));
  }
}

}  // namespace burin
