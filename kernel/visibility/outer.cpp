#include "outer.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace burin {
namespace {

// Paper mm beside the curve where the sheet must be empty, beside what the proxy's polygons may jut
// out over a smooth contour: below the width of a gap that a reader would see as one.
constexpr double kBeside = 0.2;
// Paper mm between two places that are looked at, and how many at least and at most.
constexpr double kPlaceSpacing = 2;
constexpr int kFewestPlaces = 3, kMostPlaces = 7;
// Paper mm between two lines from which the strip between them is looked at, and of a line: its
// ends at others would come off it as crumbs.
constexpr double kStrip = 0.02, kStripLength = 0.3;
// Where the outline begins without a line: paper mm between places, and the shortest stretch.
constexpr double kFinePlaces = 0.25, kShortestOutline = 1.0;
constexpr int kMostFinePlaces = 1024, kOutlineBisections = 14;

// Whether there is paper from `p` to `p + side`. Where another line that is seen lies between, a
// sheet may end there: a strip narrower than `side` is no paper, though there is paper beyond it.
bool paper_to(const Probe& probe, const Cutters* seen, Vec2 p, Vec2 side, Crossings& crossings) {
  if (probe.paper_covered(p + side)) return false;
  if (!seen) return true;
  crossings.clear();
  seen->cross({.a = p, .b = p + side}, CutRule::AnyDepth, crossings);
  const double least = kStrip / glm::length(side);
  double nearest = 1;
  for (const double at : crossings.cuts) {
    if (at > least) nearest = std::min(nearest, at);
  }
  return nearest == 1 || !probe.paper_covered(p + 0.5 * nearest * side);
}

/// Whether there is paper beside places of one curve.
struct Beside {
  const Probe& probe;
  const Cutters& seen;
  const Curve3& curve;
  const Track& track;
  Crossings& crossings;

  /// `at`: paper mm from the start; `strips`: whether they are looked at.
  bool paper(double at, bool strips) const {
    const double parameter = track.parameter_at(at);
    const std::size_t n = track.segment_count();
    const auto segment = std::min(static_cast<std::size_t>(parameter), 2 * n - 1) % n;
    const double share = picture_share(parameter - std::floor(parameter),
                                       track.start_range(segment), track.end_range(segment));
    const Vec2 d = track.direction(segment);
    const Vec2 p = glm::mix(track.start(segment), track.end(segment), share);
    const std::int32_t face = curve.faces.empty() ? -1 : curve.faces[segment];
    const double error =
        probe.chord_error(curve.source.part, face) * probe.camera().scale_at(curve.points[segment]);
    const Vec2 side = (kBeside + 2 * error) * Vec2(-d.y, d.x);
    const Cutters* lines = strips ? &seen : nullptr;
    return paper_to(probe, lines, p, side, crossings) ||
           paper_to(probe, lines, p, -side, crossings);
  }
};

// Adds the part with its answer, that of most places; where they disagree for long enough on both
// sides, no line was known at which the outline begins: it is looked for.
void add_part(const Beside& beside, TrackPiece part, std::vector<TrackPiece>& out) {
  const bool strips = part.length() >= kStripLength;
  const auto place = [&](int i, int count) {
    return part.from + part.length() * (i + 0.5) / count;
  };
  const int count =
      std::clamp(static_cast<int>(part.length() / kPlaceSpacing), kFewestPlaces, kMostPlaces) | 1;
  int open = 0;
  for (int i = 0; i < count; ++i) open += beside.paper(place(i, count), strips) ? 1 : 0;
  part.outer = 2 * open > count;
  if (open == 0 || open == count || part.length() < 2 * kShortestOutline) {
    out.push_back(part);
    return;
  }
  const int fine = std::min(static_cast<int>(part.length() / kFinePlaces), kMostFinePlaces);
  std::vector<char> answers;
  for (int i = 0; i < fine; ++i) answers.push_back(beside.paper(place(i, fine), strips) ? 1 : 0);
  // At the most one change: an end of the outline. More are noise, and the most decide.
  const auto change = std::ranges::adjacent_find(answers, std::not_equal_to());
  const auto again = change == answers.end()
                         ? answers.end()
                         : std::adjacent_find(change + 1, answers.end(), std::not_equal_to());
  if (change == answers.end() || again != answers.end()) {
    out.push_back(part);
    return;
  }
  const auto before = static_cast<int>(change - answers.begin());
  double from = place(before, fine), to = place(before + 1, fine);
  if (from - part.from < kShortestOutline || part.to - to < kShortestOutline) {
    out.push_back(part);
    return;
  }
  for (int i = 0; i < kOutlineBisections; ++i) {
    const double middle = 0.5 * (from + to);
    (beside.paper(middle, strips) == (*change != 0) ? from : to) = middle;
  }
  TrackPiece first = part;
  first.outer = *change != 0;
  part.outer = !first.outer;
  first.to = part.from = 0.5 * (from + to);
  first.end = part.begin = beside.track.parameter_at(first.to);
  out.push_back(first);
  out.push_back(part);
}

// Marks the stretch `piece`, short parts of which take their neighbours' answer.
void mark(const Beside& beside, const TrackPiece& piece, const std::vector<double>& cuts,
          double minimum, std::vector<TrackPiece>& out) {
  std::vector<TrackPiece> parts;
  TrackPiece rest = piece;
  for (const double cut : cuts) {
    const double at = beside.track.length_at(cut);
    if (at - rest.from < minimum || piece.to - at < minimum) continue;
    TrackPiece part = rest;
    part.end = rest.begin = cut;
    part.to = rest.from = at;
    parts.push_back(part);
  }
  parts.push_back(rest);
  std::vector<TrackPiece> answered;
  for (const TrackPiece& part : parts) add_part(beside, part, answered);
  for (const TrackPiece& part : answered) {
    if (!out.empty() && out.back().visible && out.back().outer == part.outer &&
        out.back().to == part.from) {
      out.back().end = part.end;
      out.back().to = part.to;
    } else {
      out.push_back(part);
    }
  }
}

}  // namespace

std::vector<TrackPiece> find_outer(const Probe& probe, const Cutters& cutters, const Cutters& seen,
                                   const Curve3& curve, const Track& track, std::int32_t number,
                                   const std::vector<TrackPiece>& pieces, double minimum,
                                   double same_cut, Scratch& scratch) {
  const auto n = static_cast<double>(track.segment_count());
  scratch.cuts.clear();
  for (std::size_t i = 0; i < track.segment_count(); ++i) {
    scratch.crossings.clear();
    cutters.cross(track.segment(i, number), CutRule::AnyDepth, scratch.crossings);
    if (same_cut > kSameCut) {
      thin_cuts(scratch.crossings.cuts, glm::distance(track.start(i), track.end(i)), same_cut);
    }
    for (const double t : scratch.crossings.cuts) {
      scratch.cuts.push_back(static_cast<double>(i) + t);
      if (track.closed()) scratch.cuts.push_back(static_cast<double>(i) + t + n);
    }
  }
  std::sort(scratch.cuts.begin(), scratch.cuts.end());
  std::vector<TrackPiece> out;
  std::vector<double> inside;
  const Beside beside{probe, seen, curve, track, scratch.crossings};
  for (const TrackPiece& piece : pieces) {
    if (!piece.visible) {
      out.push_back(piece);
      continue;
    }
    inside.assign(std::upper_bound(scratch.cuts.begin(), scratch.cuts.end(), piece.begin),
                  std::lower_bound(scratch.cuts.begin(), scratch.cuts.end(), piece.end));
    mark(beside, piece, inside, minimum, out);
  }
  return out;
}

}  // namespace burin
