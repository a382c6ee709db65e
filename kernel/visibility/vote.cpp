// One answer for a piece from several rays.

#include "pieces.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Rays keep this share of a piece away from each of its ends, and no more than `widest_margin`:
// beside a cut the polygons of the proxy and the smooth contour that cut differ by the chord error.
constexpr double kMargin = 0.12;
constexpr int kFewest = 3, kMost = 129;
// A piece whose rays disagree by more than a share, or over more than `doubt` paper mm, is looked
// at again: it may pass through a surface without a cut (a shaft into its hole).
constexpr double kDoubt = 0.15;
constexpr int kMostFine = 1024;
constexpr int kBisections = 14;

/// How closely a curve is looked at, in paper mm.
struct Look {
  double widest_margin;
  /// From ray to ray on a long piece (shorter ones get three), and at the second look.
  double spacing, fine_spacing;
  double doubt;
  /// The shortest stretch that may be cut off by rays alone.
  double shortest;
};
// Lines of the form are few; of them nothing may vanish that is as long as a pen is wide. Of
// strokes, which are many, ends matter less.
constexpr Look kLine{0.2, 0.5, 0.1, 0.35, 0.35}, kStroke{0.6, 1.5, 0.25, 1.2, 1.0};

const Look& look_at(const Curve3& curve) { return lies_on_surface(curve) ? kStroke : kLine; }

double margin(const Piece& piece, const Look& look) {
  return std::min(kMargin * piece.length(), look.widest_margin);
}

double place(const Piece& piece, const Look& look, int i, int count) {
  const double probed = piece.length() - 2 * margin(piece, look);
  return piece.from + margin(piece, look) + probed * (static_cast<double>(i) + 0.5) / count;
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

}  // namespace

void Cutting::vote(const Curve3& curve, const Track& track, const Piece& piece,
                   std::vector<Piece>& out) const {
  const Look& look = look_at(curve);
  // Where cuts that lie far apart are one, more rays would tell nothing more.
  const double spacing = std::max(look.spacing, same_cut_ / kFewest);
  const int count = std::clamp(static_cast<int>(piece.length() / spacing) + 1, kFewest, kMost) | 1;
  double seen = 0, all = 0;
  int yes = 0;
  for (int i = 0; i < count; ++i) {
    const double w = weight(i, count);
    all += w;
    if (visible_at(curve, track, place(piece, look, i, count))) {
      seen += w;
      ++yes;
    }
  }
  const int outvoted = std::min(yes, count - yes);
  Piece answer = piece;
  answer.visible = 2 * seen > all;
  const double doubt = std::min(seen, all - seen) / all;
  const bool doubtful = doubt > kDoubt || outvoted * piece.length() > look.doubt * count;
  if (doubtful && piece.length() > 2 * std::max(look.shortest, same_cut_)) {
    refine(curve, track, piece, out);
  } else {
    out.push_back(answer);
  }
}

// The rays of a piece disagree: no occluding line was known where its visibility changes. Many rays
// find the stretches, bisection their ends. Without such a line a surface that hides a stretch is
// one that the curve dives into; what it never gets clear of are the curve's own triangles.
void Cutting::refine(const Curve3& curve, const Track& track, const Piece& piece,
                     std::vector<Piece>& out) const {
  const Look& look = look_at(curve);
  const int count =
      std::clamp(static_cast<int>(piece.length() / look.fine_spacing), kFewest, kMostFine);
  std::vector<char> answers(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    answers[static_cast<std::size_t>(i)] = visible_at(curve, track, place(piece, look, i, count));
  }
  std::vector<Run> runs = runs_of(answers);
  const double spacing = (piece.length() - 2 * margin(piece, look)) / count;
  absorb_short(runs, std::max(2, static_cast<int>(std::ceil(look.shortest / spacing))));
  for (std::size_t r = 0; r < runs.size() && runs.size() > 1;) {
    bool hidden = runs[r].visible;
    for (int i = runs[r].begin; i < runs[r].end && !hidden; ++i) {
      hidden = clearly_hidden_at(curve, track, place(piece, look, i, count));
    }
    if (hidden) {
      ++r;
    } else {
      turn(runs, r);
      if (r > 0) --r;  // what it was joined to
    }
  }
  Piece rest = piece;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    rest.visible = runs[r].visible;
    if (r + 1 == runs.size()) break;
    double before = place(piece, look, runs[r].end - 1, count),
           after = place(piece, look, runs[r].end, count);
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (before + after);
      (visible_at(curve, track, middle) == runs[r].visible ? before : after) = middle;
    }
    Piece done = rest;
    done.to = rest.from = 0.5 * (before + after);
    done.end = rest.begin = track.parameter_at(done.to);
    out.push_back(done);
  }
  out.push_back(rest);
}

}  // namespace burin
