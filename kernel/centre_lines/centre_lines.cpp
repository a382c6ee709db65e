#include <burin/centre_lines/centre_lines.h>

#include "along_ray.h"
#include "axis_sight.h"
#include "pitch_circles.h"
#include "turned_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace burin {
namespace {

using detail::GroupFace;
using detail::TurnedGroup;

/// Paper mm within which two axes are one; and where normals are estimates.
constexpr double kOneAxis = 0.01;
constexpr double kOneEstimate = 0.5;
/// Paper mm: the radius of the smallest face that has a line, and of the smallest ball.
constexpr double kSmallest = 0.6, kSmallestBall = 2.5;
/// Sine below which a line is no longer made longer to reach over the outline on paper.
constexpr double kSteep = 0.3;
/// Paper mm along a line between two rays, and the most places of one line.
constexpr double kStep = 0.25;
constexpr int kMostPlaces = 4000;
/// Of a radius: facets that lie within a circle, and what of it has been cut away.
constexpr double kCutAway = 0.02;
/// Paper mm of a line that are drawn at least.
constexpr double kLeast = 1.5;

/// A stretch of an axis, model mm from its point.
struct Stretch {
  double low = 0, high = 0;
};

class Maker {
 public:
  Maker(std::span<const std::shared_ptr<const Surface>> surfaces, const Camera& camera,
        const Occluder& occluder, const CentreLineOptions& options, const RunContext& context)
      : surfaces_(surfaces),
        camera_(camera),
        options_(options),
        context_(context),
        sight_(surfaces, camera, occluder) {}

  std::vector<Curve3> lines() {
    std::vector<TurnedGroup> groups;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      if (!surfaces_[i] || i >= options_.over.size() || !options_.over[i]) continue;
      const double near = surfaces_[i]->exact() ? kOneAxis : kOneEstimate;
      std::ranges::move(detail::turned_groups(*surfaces_[i], static_cast<std::int32_t>(i),
                                              near / camera_.scale(), context_),
                        std::back_inserter(groups));
    }
    for (TurnedGroup& group : groups) {
      context_.check();
      if (!options_.hidden) sight_.keep_seen(group);
    }
    std::erase_if(groups, [&](const TurnedGroup& group) { return group.faces.empty(); });
    groups = detail::joined(std::move(groups), kOneAxis / camera_.scale());
    std::erase_if(groups, [&](const TurnedGroup& group) {
      const double radius = group.radius() * scale_at(group);
      if (group.sphere) return radius < kSmallestBall;
      const bool small = radius < kSmallest;
      small_ += small ? 1 : 0;
      return small;
    });
    std::vector<const TurnedGroup*> end_on;
    for (const TurnedGroup& group : groups) {
      context_.check();
      if (group.sphere || sight_.seen_along(group)) {
        end_on.push_back(&group);
      } else {
        draw_axis(group);
      }
    }
    draw_marks(end_on);
    std::ranges::stable_sort(lines_, {}, [](const Curve3& line) { return line.source.part; });
    return std::move(lines_);
  }

  std::int64_t small() const { return small_; }

 private:
  double scale_at(const TurnedGroup& group) const { return camera_.scale_at(group.middle()); }

  double over(const TurnedGroup& group) const {
    return options_.over[static_cast<std::size_t>(source_of(group).part)].value_or(0);
  }

  /// The largest face says where a line comes from.
  static SourceId source_of(const TurnedGroup& group) {
    const GroupFace& largest = group.largest();
    return {largest.part, largest.turned.face, -1};
  }

  void add(std::vector<Vec3> points, const SourceId& source, bool closed = false) {
    Curve3 line;
    line.kind = LineClass::Centre;
    line.source = source;
    line.closed = closed;
    line.points = std::move(points);
    lines_.push_back(std::move(line));
  }

  // Lines along axes in space.

  /// How far a line goes on from the end of a face, model mm: over its outline, which is an ellipse
  /// about the axis where it is seen at a slant.
  double beyond(const TurnedGroup& group, double height, double radius) const {
    const Vec3 end = group.at(height);
    const double sine = glm::length(glm::cross(camera_.to_viewer(end), group.axis.along));
    const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
    return (over(group) / camera_.scale_at(end) + cosine * radius) / std::max(sine, kSteep);
  }

  void draw_axis(const TurnedGroup& group) {
    // A part has one line along an axis; that of another joins it where both meet.
    std::map<std::int32_t, Stretch> of_parts;
    for (const GroupFace& face : group.faces) {
      const auto& [turn, low, high, radius] = face.extent;
      const Stretch one{low - beyond(group, low, radius), high + beyond(group, high, radius)};
      Stretch& all = of_parts.try_emplace(face.part, one).first->second;
      all = {std::min(all.low, one.low), std::max(all.high, one.high)};
    }
    std::vector<Stretch> stretches;
    for (const auto& [part, stretch] : of_parts) stretches.push_back(stretch);
    std::ranges::sort(stretches, {}, &Stretch::low);
    std::vector<Stretch> whole;
    for (const Stretch& one : stretches) {
      if (whole.empty() || one.low > whole.back().high) {
        whole.push_back(one);
      } else {
        whole.back().high = std::max(whole.back().high, one.high);
      }
    }
    for (const Stretch& one : whole) draw_stretch(group, one);
  }

  void draw_stretch(const TurnedGroup& group, const Stretch& whole) {
    const double length = glm::distance(camera_.to_paper(group.at(whole.low)),
                                        camera_.to_paper(group.at(whole.high)));
    const int places = std::clamp(static_cast<int>(std::ceil(length / kStep)), 1, kMostPlaces);
    const double step = (whole.high - whole.low) / places;
    const double reach = (over(group) / camera_.scale_at(group.middle()) + group.radius()) / kSteep;
    std::optional<double> begin;
    const auto close = [&](double end) {
      const Vec3 a = group.at(*begin), b = group.at(end);
      if (glm::distance(camera_.to_paper(a), camera_.to_paper(b)) >= kLeast) {
        add({a, b}, source_of(group));
      }
      begin.reset();
    };
    for (int i = 0; i < places; ++i) {
      const double from = whole.low + i * step;
      const bool seen = options_.hidden || sight_.seen_at(group, from + 0.5 * step, reach);
      if (seen && !begin) begin = from;
      if (!seen && begin) close(from);
    }
    if (begin) close(whole.high);
  }

  // Marks where axes are seen as points.

  /// The end of a group that is nearest to the viewer, on its axis.
  Vec3 near_end(const TurnedGroup& group) const {
    if (group.sphere) return group.axis.point;
    Vec3 nearest = group.at(group.faces.front().extent.low);
    for (const GroupFace& face : group.faces) {
      for (const double height : {face.extent.low, face.extent.high}) {
        const Vec3 p = group.at(height);
        if (camera_.depth(p) > camera_.depth(nearest)) nearest = p;
      }
    }
    return nearest;
  }

  /// The point of the plane across the view through `near` that is seen at a place of the sheet.
  Vec3 in_space(Vec2 paper, Vec3 near) const {
    const ViewRay ray = camera_.ray(paper);
    const double way = glm::dot(near - ray.origin, camera_.direction()) /
                       glm::dot(ray.direction, camera_.direction());
    return ray.origin + way * ray.direction;
  }

  void draw_marks(const std::vector<const TurnedGroup*>& groups) {
    std::vector<detail::Round> rounds;
    std::vector<Vec3> ends;
    for (const TurnedGroup* group : groups) {
      const Vec3 end = near_end(*group);
      const GroupFace& largest = group->largest();
      rounds.push_back({camera_.to_paper(end), largest.extent.radius * camera_.scale_at(end),
                        largest.turned.hollow, largest.part});
      ends.push_back(end);
    }
    std::vector<bool> on_circle(groups.size());
    for (const detail::PitchCircle& circle : detail::pitch_circles(rounds)) {
      const SourceId source = source_of(*groups[circle.holes.front()]);
      draw_circle(circle, ends[circle.holes.front()], source);
      for (const std::size_t i : circle.holes) {
        on_circle[i] = true;
        draw_line(*groups[i], rounds[i], glm::normalize(rounds[i].center - circle.center), ends[i]);
      }
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (on_circle[i]) continue;
      draw_line(*groups[i], rounds[i], {1, 0}, ends[i]);
      draw_line(*groups[i], rounds[i], {0, 1}, ends[i]);
    }
  }

  void draw_line(const TurnedGroup& group, const detail::Round& round, Vec2 along, Vec3 end) {
    const auto tip = [&](Vec2 way) {
      return in_space(round.center + (reach(group, round, way) + over(group)) * way, end);
    };
    add({tip(-along), tip(along)}, source_of(group));
  }

  /// Paper mm from the middle of a mark to the circle of the largest face, or to the outline of its
  /// part where the circle has been cut away there, as by the flats of a nut.
  double reach(const TurnedGroup& group, const detail::Round& round, Vec2 way) const {
    const GroupFace& face = group.largest();
    const ProxyMesh& proxy = surfaces_[static_cast<std::size_t>(face.part)]->proxy();
    const detail::PaperRay ray{round.center, way, (1 + kCutAway) * round.radius};
    detail::AlongRay own, all;
    for (const std::uint32_t t : face.turned.triangles) own.add(ray, corners(proxy, t));
    if (own.farthest >= (1 - kCutAway) * round.radius) return round.radius;
    for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) all.add(ray, corners(proxy, t));
    if (all.covers_end || all.farthest <= 0) return round.radius;
    return std::min(all.farthest, round.radius);
  }

  std::array<Vec2, 3> corners(const ProxyMesh& proxy, std::uint32_t t) const {
    std::array<Vec2, 3> out;
    for (std::size_t k = 0; k < 3; ++k) {
      out[k] = camera_.to_paper(proxy.mesh.positions[proxy.mesh.triangles[t][k]]);
    }
    return out;
  }

  void draw_circle(const detail::PitchCircle& circle, Vec3 end, const SourceId& source) {
    constexpr double kOff = 0.01;  // paper mm between chord and circle
    const double half = std::acos(std::max(0.9, 1 - kOff / circle.radius));
    const int count = static_cast<int>(std::ceil(std::numbers::pi / half));
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      points.push_back(
          in_space(circle.center + circle.radius * Vec2(std::cos(angle), std::sin(angle)), end));
    }
    add(std::move(points), source, true);
  }

  std::span<const std::shared_ptr<const Surface>> surfaces_;
  const Camera& camera_;
  const CentreLineOptions& options_;
  const RunContext& context_;
  detail::AxisSight sight_;
  std::vector<Curve3> lines_;
  std::int64_t small_ = 0;
};

}  // namespace

std::vector<Curve3> centre_lines(std::span<const std::shared_ptr<const Surface>> surfaces,
                                 const Camera& camera, const Occluder& occluder,
                                 const CentreLineOptions& options, Diagnostics& diagnostics,
                                 const RunContext& context) {
  Maker maker(surfaces, camera, occluder, options, context);
  std::vector<Curve3> lines = maker.lines();
  if (const auto small = maker.small(); small > 0) {
    diagnostics.add(Severity::Info, "centre_lines.small", small,
                    fmt::format("{} round face{} narrower than {} mm on paper {} no centre line",
                                small, small == 1 ? " is" : "s are", 2 * kSmallest,
                                small == 1 ? "and has" : "and have"));
  }
  return lines;
}

}  // namespace burin
