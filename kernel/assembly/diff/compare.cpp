#include <burin/assembly/select.h>
#include <burin/diff/difference.h>

#include "shift.h"
#include "surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

PartNumbers numbers_of(const RevisionPart& part) {
  return {part.shape.volume, part.shape.area, part.pose.box.size(), part.shape.faces,
          part.pose.middle};
}

/// Angle and axis of a turn.
void set_turn(const Mat3& turn, PartMotion& motion) {
  const double angle =
      std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1), -1.0, 1.0));
  motion.degrees = angle * 180 / std::numbers::pi;
  const Vec3 twice(turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]);
  constexpr double kHalf = 1e-6;
  if (glm::length(twice) > kHalf) {
    motion.axis = glm::normalize(twice);
  } else if (angle > 1) {
    // Half a turn: the axis is the longest column of turn + 1.
    const Mat3 m = turn + Mat3(1);
    Vec3 best = m[0];
    for (int k = 1; k < 3; ++k) {
      if (glm::length(m[k]) > glm::length(best)) best = m[k];
    }
    motion.axis = glm::normalize(best);
  }
}

class Comparer {
 public:
  Comparer(const Scene& before, const Scene& after, const std::vector<bool>& drawn_before,
           const std::vector<bool>& drawn_after, Diagnostics& diagnostics, RunContext& context)
      : scene_before_(before),
        scene_after_(after),
        context_(context),
        surfaces_before_(before, drawn_before, diagnostics, context),
        surfaces_after_(after, drawn_after, diagnostics, context) {}

  Difference run() {
    context_.begin_stage(RunStage::Build);
    parts_before_ = surfaces_before_.measured(0, 0.4);
    parts_after_ = surfaces_after_.measured(0.4, 0.8);
    Difference difference;
    difference.tolerance.place =
        kSamePlace * std::max(diagonal(parts_before_), diagonal(parts_after_));
    place_ = difference.tolerance.place;
    const auto lie = [this](std::size_t b, std::size_t a) { return lie_on_each_other(b, a); };
    const std::vector<PartMatch> matches =
        match_parts(parts_before_, parts_after_, difference.tolerance, lie, context_);
    for (const PartMatch& match : matches) {
      context_.check();
      difference.parts.push_back(compared(match));
      ++difference.counts[static_cast<std::size_t>(difference.parts.back().change())];
      context_.progress(0.8 + 0.2 * static_cast<double>(difference.parts.size()) /
                                  static_cast<double>(matches.size()));
    }
    context_.end_stage();
    return difference;
  }

 private:
  static double diagonal(const std::vector<RevisionPart>& parts) {
    Box3 box;
    for (const RevisionPart& part : parts) {
      if (!part.pose.box.empty()) box.add(part.pose.box);
    }
    return box.diagonal();
  }

  static bool has_area(const std::shared_ptr<const Surface>& surface) {
    return surface && !surface->proxy().mesh.triangles.empty();
  }

  bool lie_on_each_other(std::size_t b, std::size_t a) {
    const auto before = surfaces_before_.surface(b), after = surfaces_after_.surface(a);
    if (!has_area(before) || !has_area(after)) return true;
    const TriMesh &was = before->proxy().mesh, &is = after->proxy().mesh;
    const auto as_it_was = [&](const Vec3& p, const Vec3& q) {
      return glm::distance(p, q) <= place_;
    };
    if (was.triangles == is.triangles && std::ranges::equal(was.positions, is.positions, as_it_was))
      return true;
    return coincide(Body(before), Body(after), {}, place_);
  }

  PartDifference compared(const PartMatch& match) {
    PartDifference d;
    d.match = match;
    if (match.before != kNoPart) {
      const RevisionPart& part = parts_before_[match.before];
      d.before = path_of(scene_before_.parts[match.before]);
      d.numbers_before = numbers_of(part);
      d.color_before = part.color;
      d.opacity_before = part.opacity;
      d.drawn_before = part.drawn;
    }
    if (match.after != kNoPart) {
      const RevisionPart& part = parts_after_[match.after];
      d.after = path_of(scene_after_.parts[match.after]);
      d.numbers_after = numbers_of(part);
      d.color_after = part.color;
      d.opacity_after = part.opacity;
      d.drawn_after = part.drawn;
    }
    if (match.before != kNoPart && match.after != kNoPart) {
      if (match.changed) find_shift(d);
      if (match.moved && !match.changed) find_motion(d);
    }
    return d;
  }

  Vec3 way_of(const PartMatch& match) const {
    return parts_after_[match.after].pose.middle - parts_before_[match.before].pose.middle;
  }

  void find_shift(PartDifference& d) {
    const auto before = surfaces_before_.surface(d.match.before),
               after = surfaces_after_.surface(d.match.after);
    d.match.moved = false;
    if (!has_area(before) || !has_area(after)) return;
    const detail::Shift shift = detail::best_shift(Body(before), Body(after), place_);
    d.surface_changed = 1 - shift.share;
    d.match.moved = glm::length(shift.by) > place_;
    if (d.match.moved) d.motion = PartMotion{shift.by};
  }

  void find_motion(PartDifference& d) {
    const Vec3 way = way_of(d.match);
    const auto before = surfaces_before_.surface(d.match.before),
               after = surfaces_after_.surface(d.match.after);
    if (!has_area(before) || !has_area(after)) {
      d.motion = PartMotion{way};
      return;
    }
    const Body was(before), is(after);
    PartMotion motion{way, std::nullopt};
    if (const auto move = rigid_move(was, is, place_, context_)) {
      set_turn(move->linear, motion);
    } else if (glm::length(way) <= place_) {
      // One measure, one middle, and nothing lays it on the other: it is another shape.
      d.match.moved = false;
      d.match.changed = true;
      d.surface_changed = 1 - share_on_each_other(was, is, {}, place_);
      return;
    }
    d.motion = motion;
  }

  const Scene& scene_before_;
  const Scene& scene_after_;
  RunContext& context_;
  detail::RevisionSurfaces surfaces_before_, surfaces_after_;
  std::vector<RevisionPart> parts_before_, parts_after_;
  double place_ = 0;
};

}  // namespace

const char* to_string(PartChange change) {
  switch (change) {
    case PartChange::Added:
      return "added";
    case PartChange::Removed:
      return "removed";
    case PartChange::Changed:
      return "changed";
    case PartChange::Moved:
      return "moved";
    case PartChange::Renamed:
      return "renamed";
    case PartChange::Look:
      return "look";
    case PartChange::Same:
      break;
  }
  return "same";
}

std::vector<PartChange> PartDifference::changes() const {
  if (match.before == kNoPart) return {PartChange::Added};
  if (match.after == kNoPart) return {PartChange::Removed};
  std::vector<PartChange> all;
  if (match.changed) all.push_back(PartChange::Changed);
  if (match.moved) all.push_back(PartChange::Moved);
  if (match.renamed) all.push_back(PartChange::Renamed);
  if (match.look) all.push_back(PartChange::Look);
  if (all.empty()) all.push_back(PartChange::Same);
  return all;
}

PartChange PartDifference::change() const { return changes().front(); }

Difference compare_revisions(const Scene& before, const Scene& after,
                             const std::vector<bool>& drawn_before,
                             const std::vector<bool>& drawn_after, Diagnostics& diagnostics,
                             RunContext& context) {
  return Comparer(before, after, drawn_before, drawn_after, diagnostics, context).run();
}

}  // namespace burin
