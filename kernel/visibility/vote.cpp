// One answer for a piece from several rays.

#include "pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace burin {
namespace {

// Rays keep this share of a piece, and no more paper mm than that, away from each of its ends:
// beside a cut the polygons of the proxy and the smooth contour that cut differ by the chord error.
constexpr double kMargin = 0.12, kWidestMargin = 0.6;
// Paper mm a ray on a long piece; pieces shorter than this get three.
constexpr double kRaySpacing = 1.5;
constexpr int kFewestRays = 3, kMostRays = 129;
// A piece whose rays disagree by more than a share, or over more than so many paper mm, is looked
// at again: it may pass through a surface without a cut (a shaft into its hole).
constexpr double kDoubt = 0.15, kDoubtLength = 1.2;
// The second look: paper mm a ray, and the shortest stretch that may be cut off by rays alone.
constexpr double kFineSpacing = 0.25;
constexpr double kShortestStretch = 1.0;
constexpr int kMostFine = 1024;
// Behind other parts, whose triangles no fold of the curve's own makes doubtful, lines are looked
// at more closely: paper mm from ray to ray, those of a second look, and the shortest stretch that
// is told apart, about a pen's width.
constexpr double kOtherSpacing = 0.5, kOtherFine = 0.1, kOtherShortest = 0.35;
constexpr double kOtherMargin = 0.1;
constexpr int kBisections = 14;

double margin(const TrackPiece& piece) { return std::min(kMargin * piece.length(), kWidestMargin); }

double place(const TrackPiece& piece, int i, int count) {
  const double probed = piece.length() - 2 * margin(piece);
  return piece.from + margin(piece) + probed * (static_cast<double>(i) + 0.5) / count;
}

// Highest in the middle of the piece, low at its ends.
double weight(int i, int count) {
  const double x = (static_cast<double>(i) + 0.5) / count;
  return 0.25 + x * (1 - x);
}

struct Run {
  int begin, end;
  bool visible;
};

std::vector<Run> runs_of(const std::vector<char>& answers) {
  std::vector<Run> runs;
  for (int i = 0; i < static_cast<int>(answers.size()); ++i) {
    const bool visible = answers[static_cast<std::size_t>(i)] != 0;
    if (runs.empty() || runs.back().visible != visible) runs.push_back({i, i, visible});
    runs.back().end = i + 1;
  }
  return runs;
}

// Turns a run and joins it to its neighbours.
void turn(std::vector<Run>& runs, std::size_t which) {
  runs[which].visible = !runs[which].visible;
  std::vector<Run> joined;
  for (const Run& r : runs) {
    if (!joined.empty() && joined.back().visible == r.visible) {
      joined.back().end = r.end;
    } else {
      joined.push_back(r);
    }
  }
  runs = std::move(joined);
}

// Gives runs of fewer than `fewest` answers to their neighbours, shortest first.
void absorb_short(std::vector<Run>& runs, int fewest) {
  while (runs.size() > 1) {
    const auto shortest = std::min_element(
        runs.begin(), runs.end(),
        [](const Run& a, const Run& b) { return a.end - a.begin < b.end - b.begin; });
    if (shortest->end - shortest->begin >= fewest) return;
    turn(runs, static_cast<std::size_t>(shortest - runs.begin()));
  }
}

/// The stretches of a piece between its rays, ray i `place_of(i)` from the curve's start; their
/// ends are bisected by `seen(length)`.
template <class PlaceOf, class Seen>
std::vector<TrackPiece> stretches(const TrackPiece& piece, const Track& track,
                                  const std::vector<Run>& runs, const PlaceOf& place_of,
                                  const Seen& seen) {
  std::vector<TrackPiece> out;
  TrackPiece rest = piece;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    rest.visible = runs[r].visible;
    if (r + 1 == runs.size()) break;
    double before = place_of(runs[r].end - 1), after = place_of(runs[r].end);
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (before + after);
      (seen(middle) == runs[r].visible ? before : after) = middle;
    }
    TrackPiece done = rest;
    done.to = rest.from = 0.5 * (before + after);
    done.end = rest.begin = track.parameter_at(done.to);
    out.push_back(done);
  }
  out.push_back(rest);
  return out;
}

}  // namespace

void Cutting::vote(const Curve3& curve, const Track& track, const TrackPiece& piece,
                   std::vector<TrackPiece>& out) const {
  const bool line = !lies_on_surface(curve) && probe_.several_parts() && same_cut_ == kSameCut;
  if (!line || !part_by_others(curve, track, piece, out)) ask(curve, track, piece, out);
}

// Where a pin comes out of a hole of its size its sides meet the rim without crossing it: no line
// is known there, and what stands out may be short.
bool Cutting::part_by_others(const Curve3& curve, const Track& track, const TrackPiece& piece,
                             std::vector<TrackPiece>& out) const {
  const double probed = piece.length() - 2 * kOtherMargin;
  if (probed < 2 * kOtherShortest) return false;
  const auto at = [&](int i, int count) {
    return piece.from + kOtherMargin + probed * (static_cast<double>(i) + 0.5) / count;
  };
  const auto look = [&](double spacing) {
    std::vector<char> seen(static_cast<std::size_t>(
        std::clamp(static_cast<int>(probed / spacing) + 1, kFewestRays, kMostFine)));
    const int count = static_cast<int>(seen.size());
    for (int i = 0; i < count; ++i) {
      seen[static_cast<std::size_t>(i)] = !hidden_by_others_at(curve, track, at(i, count));
    }
    return seen;
  };
  if (runs_of(look(kOtherSpacing)).size() == 1) return false;
  const std::vector<char> seen = look(kOtherFine);
  const int count = static_cast<int>(seen.size());
  std::vector<Run> runs = runs_of(seen);
  absorb_short(runs, static_cast<int>(std::ceil(kOtherShortest * count / probed)));
  if (runs.size() == 1) return false;
  const auto seen_at = [&](double length) { return !hidden_by_others_at(curve, track, length); };
  const auto place_of = [&](int i) { return at(i, count); };
  for (const TrackPiece& stretch : stretches(piece, track, runs, place_of, seen_at)) {
    if (stretch.visible) {
      ask(curve, track, stretch, out);
    } else {
      out.push_back(stretch);
    }
  }
  return true;
}

void Cutting::ask(const Curve3& curve, const Track& track, const TrackPiece& piece,
                  std::vector<TrackPiece>& out) const {
  // Where cuts that lie far apart are one, more rays would tell nothing more.
  const double spacing = std::max(kRaySpacing, same_cut_ / kFewestRays);
  const int count =
      std::clamp(static_cast<int>(piece.length() / spacing) + 1, kFewestRays, kMostRays) | 1;
  double seen = 0, all = 0;
  int yes = 0;
  for (int i = 0; i < count; ++i) {
    const double w = weight(i, count);
    all += w;
    if (visible_at(curve, track, place(piece, i, count))) {
      seen += w;
      ++yes;
    }
  }
  const int outvoted = std::min(yes, count - yes);
  TrackPiece answer = piece;
  answer.visible = 2 * seen > all;
  const double doubt = std::min(seen, all - seen) / all;
  const bool doubtful = doubt > kDoubt || outvoted * piece.length() > kDoubtLength * count;
  if (doubtful && piece.length() > 2 * std::max(kShortestStretch, same_cut_)) {
    refine(curve, track, piece, out);
  } else {
    out.push_back(answer);
  }
}

// The rays of a piece disagree: no occluding line was known where its visibility changes. Many rays
// find the stretches, bisection their ends. Without such a line a surface that hides a stretch is
// one that the curve dives into; what it never gets clear of are the curve's own triangles.
void Cutting::refine(const Curve3& curve, const Track& track, const TrackPiece& piece,
                     std::vector<TrackPiece>& out) const {
  const int count =
      std::clamp(static_cast<int>(piece.length() / kFineSpacing), kFewestRays, kMostFine);
  std::vector<char> answers(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    answers[static_cast<std::size_t>(i)] = visible_at(curve, track, place(piece, i, count));
  }
  std::vector<Run> runs = runs_of(answers);
  const double spacing = (piece.length() - 2 * margin(piece)) / count;
  absorb_short(runs, std::max(2, static_cast<int>(std::ceil(kShortestStretch / spacing))));
  for (std::size_t r = 0; r < runs.size() && runs.size() > 1;) {
    bool hidden = runs[r].visible;
    for (int i = runs[r].begin; i < runs[r].end && !hidden; ++i) {
      hidden = clearly_hidden_at(curve, track, place(piece, i, count));
    }
    if (hidden) {
      ++r;
    } else {
      turn(runs, r);
      if (r > 0) --r;  // what it was joined to
    }
  }
  const auto seen_at = [&](double length) { return visible_at(curve, track, length); };
  const auto place_of = [&](int i) { return place(piece, i, count); };
  std::ranges::move(stretches(piece, track, runs, place_of, seen_at), std::back_inserter(out));
}

}  // namespace burin
