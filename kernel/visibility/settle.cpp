// One consistent answer along a chain.

#include "pieces.h"

#include <algorithm>

namespace burin {
namespace {

// Joins neighbours of like answer.
std::vector<TrackPiece> join(const std::vector<TrackPiece>& pieces, const Track& track) {
  std::vector<TrackPiece> runs;
  for (const TrackPiece& p : pieces) {
    if (!runs.empty() && runs.back().visible == p.visible) {
      runs.back().end = p.end;
      runs.back().to = p.to;
    } else {
      runs.push_back(p);
    }
  }
  if (track.closed() && runs.size() > 1 && runs.front().visible == runs.back().visible) {
    runs.back().end = runs.front().end + static_cast<double>(track.segment_count());
    runs.back().to = runs.front().to + track.length();
    runs.erase(runs.begin());
  }
  return runs;
}

}  // namespace

std::vector<TrackPiece> settle(std::vector<TrackPiece> pieces, const Track& track, double minimum) {
  pieces = join(pieces, track);
  while (pieces.size() > 1) {
    const auto shortest = std::min_element(
        pieces.begin(), pieces.end(),
        [](const TrackPiece& a, const TrackPiece& b) { return a.length() < b.length(); });
    if (shortest->length() >= minimum) break;
    shortest->visible = !shortest->visible;  // its neighbours agree: answers alternate
    pieces = join(pieces, track);
  }
  return pieces;
}

}  // namespace burin
