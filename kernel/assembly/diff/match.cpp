#include <burin/diff/match.h>

#include "near_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace burin {
namespace {

using Indices = std::vector<std::size_t>;

/// What files that hold opacity as a byte, and those that hold transparency in whole percent,
/// round.
constexpr double kSameOpacity = 0.0079;
/// Pairs of one rule and name that are all looked at, and neighbours beyond that.
constexpr std::size_t kMostPairs = 250'000, kNeighbours = 50;
/// Pairs whose boxes are compared.
constexpr std::size_t kMostBoxes = 4'000'000;
/// Of what two boxes cover together.
constexpr double kShared = 0.5;

double volume_of(const Box3& box) {
  const Vec3 s = box.size();
  return s.x * s.y * s.z;
}

/// What two boxes share of what they cover together; flat ones as if they had a thickness.
double shared(Box3 a, Box3 b) {
  const double thin = 1e-6 * std::max(a.diagonal(), b.diagonal());
  for (Box3* box : {&a, &b}) box->min -= thin, box->max += thin;
  if (!a.overlaps(b)) return 0;
  const double both = volume_of({glm::max(a.min, b.min), glm::min(a.max, b.max)});
  const double all = volume_of(a) + volume_of(b) - both;
  return all > 0 ? both / all : 0;
}

/// Whether faces have the same colours, as far as areas, their places and their extent tell. Of a
/// part that has moved, how far they are from its middle; of one of another shape, the colours.
bool same_face_colors(const RevisionPart& was, const RevisionPart& is, const PartMatch& match) {
  // Of the area or the size of the part: meshes of one shape differ by less.
  constexpr double kSame = 1e-3;
  if (was.face_colors.size() != is.face_colors.size()) return false;
  double all = 0;
  for (const ColorShare& one : was.face_colors) all += one.area;
  const double size = was.pose.box.diagonal(), near = kSame * size;
  for (std::size_t i = 0; i < was.face_colors.size(); ++i) {
    const ColorShare &a = was.face_colors[i], &b = is.face_colors[i];
    if (a.color != b.color) return false;
    if (match.changed) continue;
    if (std::abs(a.area - b.area) > kSame * all) return false;
    if (match.moved) {
      const double from = glm::distance(a.middle, was.pose.middle);
      if (std::abs(from - glm::distance(b.middle, is.pose.middle)) > near) return false;
    } else if (glm::distance(a.middle, b.middle) > near ||
               glm::distance(a.spread, b.spread) > near * size) {
      return false;
    }
  }
  return true;
}

class Matcher {
 public:
  Matcher(std::span<const RevisionPart> before, std::span<const RevisionPart> after,
          const MatchTolerance& tolerance, const LieOnEachOther& lie, const RunContext& context)
      : before_(before),
        after_(after),
        tolerance_(tolerance),
        lie_(lie),
        context_(context),
        mate_before_(before.size(), kNoPart),
        mate_after_(after.size(), kNoPart) {
    find_shapes();
  }

  std::vector<PartMatch> run() {
    match_in_place();
    const auto path = [](const RevisionPart& p) { return p.path; };
    const auto stem = [](const RevisionPart& p) { return p.stem; };
    const auto any = [](const RevisionPart&) { return std::string(); };
    match_nearest(path, true);
    match_nearest(stem, true);
    match_nearest(path, false);
    match_nearest(stem, false);
    match_nearest(any, true);
    match_boxes();
    return matches_found();
  }

 private:
  /// Numbers shapes, so that equal ones have one number. Sorted by area, a part is compared with
  /// the shapes known so far that have about its own.
  void find_shapes() {
    struct One {
      const RevisionPart* part;
      std::size_t* shape;
    };
    shape_before_.assign(before_.size(), 0);
    shape_after_.assign(after_.size(), 0);
    std::vector<One> all;
    for (std::size_t i = 0; i < before_.size(); ++i)
      all.push_back({&before_[i], &shape_before_[i]});
    for (std::size_t i = 0; i < after_.size(); ++i) all.push_back({&after_[i], &shape_after_[i]});
    std::ranges::stable_sort(all, {}, [](const One& one) { return one.part->shape.area; });
    std::vector<const RevisionPart*> known;
    std::size_t from = 0;
    for (const One& one : all) {
      context_.check();
      const double least = (1 - 2 * tolerance_.shape) * one.part->shape.area;
      while (from < known.size() && known[from]->shape.area < least) ++from;
      std::size_t k = from;
      while (k < known.size() && !same_shape(*known[k], *one.part)) ++k;
      if (k == known.size()) known.push_back(one.part);
      *one.shape = k;
    }
  }

  bool same_shape(const RevisionPart& a, const RevisionPart& b) const {
    if (!a.shape.same(b.shape, tolerance_.shape)) return false;
    if (a.shape.area > 0) return true;
    // Nothing was measured: what is left are the boxes.
    const Vec3 off = glm::abs(a.pose.box.size() - b.pose.box.size());
    return std::max({off.x, off.y, off.z}) <= place_of(a, b);
  }

  double place_of(const RevisionPart& a, const RevisionPart& b) const {
    return tolerance_.place + a.pose.error + b.pose.error;
  }

  bool stands(const RevisionPart& a, const RevisionPart& b) const {
    const double place = place_of(a, b);
    if (glm::distance(a.pose.middle, b.pose.middle) > place) return false;
    const Mat3 off = a.pose.spread - b.pose.spread;
    const double reach =
        std::sqrt(std::max(0.0, a.pose.spread[0][0] + a.pose.spread[1][1] + a.pose.spread[2][2]));
    // A point that far from the middle which moves by `place` changes a moment by no more.
    const double allowed = 2 * reach * place + place * place;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        if (std::abs(off[i][k]) > allowed) return false;
      }
    }
    return true;
  }

  bool in_place(std::size_t b, std::size_t a) const {
    return stands(before_[b], after_[a]) && (!lie_ || lie_(b, a));
  }

  void pair(std::size_t b, std::size_t a, bool moved) {
    mate_before_[b] = a;
    mate_after_[a] = b;
    if (moved) moved_.push_back(a);
  }

  using Cell = std::array<std::int64_t, 3>;

  void match_in_place() {
    double side = 0;
    for (const auto parts : {before_, after_}) {
      for (const RevisionPart& p : parts) side = std::max(side, p.pose.error);
    }
    side = 2 * (tolerance_.place + 2 * side);
    const auto cell_of = [&](Vec3 p) {
      constexpr double kFar = 1e15;
      Cell cell{};
      for (int k = 0; k < 3; ++k) {
        cell[static_cast<std::size_t>(k)] =
            static_cast<std::int64_t>(std::clamp(std::floor(p[k] / side), -kFar, kFar));
      }
      return cell;
    };
    std::map<Cell, Indices> cells;
    for (std::size_t b = 0; b < before_.size(); ++b) {
      cells[cell_of(before_[b].pose.middle)].push_back(b);
    }
    // Equal paths, then equal stems, then any.
    for (int rule = 0; rule < 3; ++rule) {
      for (std::size_t a = 0; a < after_.size(); ++a) {
        context_.check();
        if (mate_after_[a] != kNoPart) continue;
        const Cell middle = cell_of(after_[a].pose.middle);
        for (int n = 0; n < 27 && mate_after_[a] == kNoPart; ++n) {
          const auto found =
              cells.find({middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1});
          if (found == cells.end()) continue;
          for (const std::size_t b : found->second) {
            if (mate_before_[b] != kNoPart || shape_before_[b] != shape_after_[a]) continue;
            if (rule == 0 && before_[b].path != after_[a].path) continue;
            if (rule == 1 && before_[b].stem != after_[a].stem) continue;
            if (!in_place(b, a)) continue;
            pair(b, a, false);
            break;
          }
        }
      }
      for (auto& [cell, parts] : cells) {
        std::erase_if(parts, [&](std::size_t b) { return mate_before_[b] != kNoPart; });
      }
    }
  }

  /// Of the parts that are left: those of one name (and shape), the nearest first.
  template <class Name>
  void match_nearest(const Name& name, bool shape) {
    std::map<std::pair<std::string, std::size_t>, std::pair<Indices, Indices>> groups;
    for (std::size_t b = 0; b < before_.size(); ++b) {
      if (mate_before_[b] != kNoPart) continue;
      groups[{name(before_[b]), shape ? shape_before_[b] : 0}].first.push_back(b);
    }
    for (std::size_t a = 0; a < after_.size(); ++a) {
      if (mate_after_[a] != kNoPart) continue;
      const auto group = groups.find({name(after_[a]), shape ? shape_after_[a] : 0});
      if (group != groups.end()) group->second.second.push_back(a);
    }
    for (const auto& [key, parts] : groups) {
      context_.check();
      if (!parts.second.empty()) pair_nearest(parts.first, parts.second, shape);
    }
  }

  void pair_nearest(const Indices& before, const Indices& after, bool shape) {
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    const auto consider = [&](std::size_t b, std::size_t a) {
      pairs.emplace_back(glm::distance(before_[b].pose.middle, after_[a].pose.middle), b, a);
    };
    if (before.size() * after.size() <= kMostPairs) {
      for (const std::size_t b : before) {
        for (const std::size_t a : after) consider(b, a);
      }
    } else {
      consider_neighbours(before, after, consider);
    }
    std::ranges::sort(pairs);
    for (const auto& [distance, b, a] : pairs) {
      if (mate_before_[b] == kNoPart && mate_after_[a] == kNoPart) pair(b, a, shape);
    }
  }

  template <class Consider>
  void consider_neighbours(const Indices& before, const Indices& after, const Consider& consider) {
    std::vector<Vec3> places;
    for (const std::size_t a : after) places.push_back(after_[a].pose.middle);
    const detail::NearPlaces near(places);
    for (const std::size_t b : before) {
      context_.check();
      for (const std::size_t i : near.find(before_[b].pose.middle, kNeighbours)) {
        consider(b, after[i]);
      }
    }
  }

  /// Something else stands where something is gone.
  void match_boxes() {
    Indices before, after;
    for (std::size_t b = 0; b < before_.size(); ++b) {
      if (mate_before_[b] == kNoPart && !before_[b].pose.box.empty()) before.push_back(b);
    }
    for (std::size_t a = 0; a < after_.size(); ++a) {
      if (mate_after_[a] == kNoPart && !after_[a].pose.box.empty()) after.push_back(a);
    }
    std::ranges::stable_sort(after, {}, [&](std::size_t a) { return after_[a].pose.box.min.x; });
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    std::size_t looked = 0;
    for (const std::size_t b : before) {
      context_.check();
      const Box3& box = before_[b].pose.box;
      for (const std::size_t a : after) {
        if (after_[a].pose.box.min.x > box.max.x || ++looked > kMostBoxes) break;
        const double share = shared(box, after_[a].pose.box);
        if (share >= kShared) pairs.emplace_back(-share, b, a);
      }
    }
    std::ranges::sort(pairs);
    for (const auto& [share, b, a] : pairs) {
      if (mate_before_[b] == kNoPart && mate_after_[a] == kNoPart) pair(b, a, false);
    }
  }

  std::vector<PartMatch> matches_found() const {
    std::vector<PartMatch> matches;
    std::vector<bool> moved(after_.size(), false);
    for (const std::size_t a : moved_) moved[a] = true;
    for (std::size_t a = 0; a < after_.size(); ++a) {
      PartMatch match{mate_after_[a], a};
      if (match.before != kNoPart) {
        const RevisionPart &was = before_[match.before], &is = after_[a];
        match.moved = moved[a];
        match.changed = shape_before_[match.before] != shape_after_[a];
        match.renamed = was.stem != is.stem;
        match.look = was.color != is.color || was.drawn != is.drawn ||
                     std::abs(was.opacity - is.opacity) >= kSameOpacity;
        match.face_colors = !same_face_colors(was, is, match);
        match.look = match.look || match.face_colors;
      }
      matches.push_back(match);
    }
    for (std::size_t b = 0; b < before_.size(); ++b) {
      if (mate_before_[b] == kNoPart) matches.push_back({b, kNoPart});
    }
    return matches;
  }

  std::span<const RevisionPart> before_, after_;
  const MatchTolerance& tolerance_;
  const LieOnEachOther& lie_;
  const RunContext& context_;
  Indices shape_before_, shape_after_;
  Indices mate_before_, mate_after_, moved_;
};

}  // namespace

std::vector<PartMatch> match_parts(std::span<const RevisionPart> before,
                                   std::span<const RevisionPart> after,
                                   const MatchTolerance& tolerance, const LieOnEachOther& lie,
                                   const RunContext& context) {
  return Matcher(before, after, tolerance, lie, context).run();
}

}  // namespace burin
