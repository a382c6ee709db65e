#include "pieces.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Whether the surface under a stroke hides what faces away from the viewer.
bool turns_away_hidden(const Curve3& curve, const Probe& probe, std::size_t segment) {
  if (!lies_on_surface(curve)) return false;
  if (curve.normals.empty() || curve.faces.empty() || curve.faces[segment] < 0) return false;
  const ProxyMesh* proxy = probe.proxy(curve.source.part);
  return proxy && !proxy->topology.face_component.empty() &&
         proxy->closed(static_cast<std::uint32_t>(curve.faces[segment]));
}

double facing(const Curve3& curve, const Camera& camera, std::size_t i) {
  return glm::dot(curve.normals[i], camera.to_viewer(curve.points[i]));
}

// Whether the surface's own turn or the caller's knowledge hides the middle of a piece.
bool hidden_by_itself(const Curve3& curve, const Probe& probe, double middle) {
  const auto i = std::min(static_cast<std::size_t>(middle), curve.segment_count() - 1);
  if (!curve.self_hidden.empty() && curve.self_hidden[i]) return true;
  if (!turns_away_hidden(curve, probe, i)) return false;
  const double t = middle - static_cast<double>(i);
  const Camera& camera = probe.camera();
  return (1 - t) * facing(curve, camera, i) + t * facing(curve, camera, curve.next(i)) < 0;
}

void own_cuts(const Curve3& curve, const Camera& camera, std::vector<double>& cuts) {
  const std::size_t n = curve.segment_count();
  if (!curve.self_hidden.empty()) {
    for (std::size_t i = curve.closed ? 0 : 1; i < n; ++i) {
      const std::size_t before = i == 0 ? n - 1 : i - 1;
      if (curve.self_hidden[i] != curve.self_hidden[before]) cuts.push_back(static_cast<double>(i));
    }
  }
  if (!lies_on_surface(curve) || curve.normals.empty()) return;
  double g = facing(curve, camera, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double h = facing(curve, camera, curve.next(i));
    // A stroke that turns round with its surface comes back on the other side of the fold without
    // ever crossing it in the picture. Of an open sheet that side can be seen or not.
    if ((g < 0) != (h < 0)) cuts.push_back(static_cast<double>(i) + g / (g - h));
    g = h;
  }
}

// Whether a sheet that the curve passes through at an end of the piece hides it. Rays cannot tell
// on a short piece: within the chord errors of both they do not know which is in front.
bool hidden_at_passage(const TrackPiece& piece, const std::vector<Passage>& passages,
                       const Track& track) {
  constexpr double kShort = 2;  // paper mm
  if (piece.length() > kShort) return false;
  const auto meet = [&](double a, double b) {
    const double apart = std::abs(a - b);
    return apart <= 2 * kSameCut ||
           (track.closed() && std::abs(apart - track.length()) <= 2 * kSameCut);
  };
  return std::any_of(passages.begin(), passages.end(), [&](const Passage& p) {
    const double at = track.length_at(p.at);
    return (p.hidden_after && meet(at, piece.from)) || (p.hidden_before && meet(at, piece.to));
  });
}

}  // namespace

void Cutting::find_cuts(const Curve3& curve, const Track& track, std::int32_t number,
                        Scratch& scratch) const {
  scratch.cuts.clear();
  scratch.covered.clear();
  own_cuts(curve, probe_.camera(), scratch.cuts);
  for (std::size_t i = 0; i < track.segment_count(); ++i) {
    if (!curve.self_hidden.empty() && curve.self_hidden[i]) continue;
    scratch.crossings.clear();
    cutters_.cross(track.segment(i, number), rule_, scratch.crossings);
    const auto at = static_cast<double>(i);
    if (same_cut_ > kSameCut) {
      thin_cuts(scratch.crossings.cuts, glm::distance(track.start(i), track.end(i)), same_cut_);
    }
    for (const double t : scratch.crossings.cuts) scratch.cuts.push_back(at + t);
    for (const Crossings::Stretch& s : scratch.crossings.covered) {
      scratch.covered.push_back({at + s.begin, at + s.end});
    }
  }
  scratch.passages = find_passages(probe_, curve, track);
  for (const Passage& p : scratch.passages) scratch.cuts.push_back(p.at);
}

std::size_t Cutting::count_cuts(const Track& track, std::int32_t number, Scratch& scratch) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < track.segment_count(); ++i) {
    scratch.crossings.clear();
    cutters_.cross(track.segment(i, number), rule_, scratch.crossings);
    count += scratch.crossings.cuts.size();
  }
  return count;
}

void thin_cuts(std::vector<double>& cuts, double length, double same_cut) {
  if (!(length > 0) || cuts.size() < 2) return;
  std::sort(cuts.begin(), cuts.end());
  const double apart = same_cut / length;
  std::size_t kept = 1;
  for (const double cut : cuts) {
    if (cut - cuts[kept - 1] >= apart) cuts[kept++] = cut;
  }
  cuts.resize(kept);
}

std::vector<TrackPiece> pieces_between(const Track& track, std::vector<double>& cuts,
                                       double same_cut) {
  const auto n = static_cast<double>(track.segment_count());
  std::sort(cuts.begin(), cuts.end());
  const double total = track.length();
  std::vector<TrackPiece> ends;  // places of the cuts that remain
  for (const double cut : cuts) {
    const double at = track.length_at(std::min(cut, n * (1 - 1e-16)));
    if (!ends.empty() && at - ends.back().from <= same_cut) continue;
    const bool at_an_end = at <= kSameCut || at >= total - kSameCut;
    if (at_an_end && !track.closed()) continue;
    ends.push_back({cut, cut, at, at});
  }
  std::vector<TrackPiece> pieces;
  if (track.closed() && !ends.empty()) {
    if (ends.size() > 1 && ends.front().from + total - ends.back().from <= kSameCut)
      ends.pop_back();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      pieces.push_back({ends[i].begin, ends[i + 1].begin, ends[i].from, ends[i + 1].from});
    }
    pieces.push_back(
        {ends.back().begin, ends.front().begin + n, ends.back().from, ends.front().from + total});
    return pieces;
  }
  TrackPiece piece{0, n, 0, total};
  for (const TrackPiece& e : ends) {
    piece.end = e.begin;
    piece.to = e.from;
    pieces.push_back(piece);
    piece = {e.begin, n, e.from, total};
  }
  pieces.push_back(piece);
  return pieces;
}

std::vector<TrackPiece> Cutting::classify(const Curve3& curve, const Track& track,
                                          std::int32_t number, Scratch& scratch) const {
  find_cuts(curve, track, number, scratch);
  std::vector<TrackPiece> pieces = pieces_between(track, scratch.cuts, same_cut_), out;
  out.reserve(pieces.size());
  for (TrackPiece& piece : pieces) {
    // The middle on paper, so that a piece of almost no length in space decides by its own inside.
    double middle = track.parameter_at(0.5 * (piece.from + piece.to));
    if (middle >= static_cast<double>(track.segment_count())) {
      middle -= static_cast<double>(track.segment_count());
    }
    const bool covered = std::any_of(
        scratch.covered.begin(), scratch.covered.end(),
        [&](const Crossings::Stretch& s) { return s.begin <= middle && middle <= s.end; });
    if (covered || hidden_by_itself(curve, probe_, middle) ||
        hidden_at_passage(piece, scratch.passages, track)) {
      piece.visible = false;
      out.push_back(piece);
    } else {
      vote(curve, track, piece, out);
    }
  }
  if (curve.kind == LineClass::Intersection) show_at_folds(curve, track, out);
  return out;
}

namespace {

struct TrackPlace {
  std::size_t segment;
  double share;
};

TrackPlace place_on_track(const Track& track, double length) {
  double parameter = track.parameter_at(length);
  const auto n = static_cast<double>(track.segment_count());
  if (parameter >= n) parameter -= track.closed() ? n : 0;
  const auto i = std::min(static_cast<std::size_t>(parameter), track.segment_count() - 1);
  return {i, std::min(1.0, parameter - static_cast<double>(i))};
}

}  // namespace

bool Cutting::visible_at(const Curve3& curve, const Track& track, double length) const {
  const TrackPlace place = place_on_track(track, length);
  return probe_.visible(curve, place.segment, place.share);
}

bool Cutting::hidden_by_others_at(const Curve3& curve, const Track& track, double length) const {
  const TrackPlace place = place_on_track(track, length);
  return probe_.hidden_by_others(curve, place.segment, place.share);
}

// A line of intersection touches the contour where that dives into the other part. Of triangles the
// two cross there several times, within their chord errors: what is hidden between two such
// crossings is the way from one side of the fold to the other, and the contour is hidden there,
// too.
void Cutting::show_at_folds(const Curve3& curve, const Track& track,
                            std::vector<TrackPiece>& pieces) const {
  constexpr double kLongest = 3;  // paper mm
  constexpr int kRays = 5;
  const std::size_t n = pieces.size();
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < n; ++i) {
    const TrackPiece& piece = pieces[i];
    const bool inside = track.closed() || (i > 0 && i + 1 < n);
    if (n < 3 || piece.visible || piece.length() > kLongest || !inside) continue;
    if (!pieces[(i + n - 1) % n].visible || !pieces[(i + 1) % n].visible) continue;
    bool hidden = false;
    for (int k = 0; k < kRays && !hidden; ++k) {
      const TrackPlace place =
          place_on_track(track, piece.from + piece.length() * (k + 0.5) / kRays);
      hidden = probe_.hidden_by_smooth(curve, place.segment, place.share, 1);
    }
    if (!hidden) shown.push_back(i);
  }
  for (const std::size_t i : shown) pieces[i].visible = true;
}

bool Cutting::clearly_hidden_at(const Curve3& curve, const Track& track, double length) const {
  // What the proxies do not tell apart is an estimate; the edges of a CAD file may lie off its
  // faces by more.
  constexpr double kClear = 3;
  const TrackPlace place = place_on_track(track, length);
  return probe_.hidden_by(curve, place.segment, place.share, kClear);
}

}  // namespace burin
