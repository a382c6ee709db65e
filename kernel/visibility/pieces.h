#pragma once
/// A curve between its cuts, and one answer for each piece.

#include <burin/base/curve.h>

#include "cutters.h"
#include "passages.h"
#include "probe.h"
#include "track.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// A stretch of a curve on which visibility is one and the same. On a closed curve `end` may exceed
/// the number of segments: the piece runs over the start.
struct TrackPiece {
  double begin = 0, end = 0;
  /// Paper mm from the curve's start.
  double from = 0, to = 0;
  bool visible = true;
  bool outer = false;
  double length() const { return to - from; }
};

/// Everything that classifying one curve takes; reused from curve to curve by one thread.
struct Scratch {
  Crossings crossings;
  std::vector<double> cuts;
  std::vector<Crossings::Stretch> covered;  // in parameters of the curve
  std::vector<Passage> passages;
};

/// The pieces of a curve between its cuts: where an occluding segment crosses it in the picture,
/// where `self_hidden` changes and, for strokes, where they pass through another sheet and, on
/// closed surfaces, where the surface turns away. Answers that need no ray are given.
class Cutting {
 public:
  /// Cuts closer to each other than `same_cut` paper mm are one.
  Cutting(const Probe& probe, const Cutters& cutters, CutRule rule, double same_cut)
      : probe_(probe), cutters_(cutters), rule_(rule), same_cut_(same_cut) {}

  /// How many cuts `classify` would find, each crossing once.
  std::size_t count_cuts(const Track& track, std::int32_t number, Scratch& scratch) const;

  /// Sets the pieces' places and answers; deterministic. `number`: the curve's number among the
  /// cutters, or -1.
  std::vector<TrackPiece> classify(const Curve3& curve, const Track& track, std::int32_t number,
                                   Scratch& scratch) const;

 private:
  void find_cuts(const Curve3& curve, const Track& track, std::int32_t number,
                 Scratch& scratch) const;
  void vote(const Curve3& curve, const Track& track, const TrackPiece& piece,
            std::vector<TrackPiece>& out) const;
  bool part_by_others(const Curve3& curve, const Track& track, const TrackPiece& piece,
                      std::vector<TrackPiece>& out) const;
  void ask(const Curve3& curve, const Track& track, const TrackPiece& piece,
           std::vector<TrackPiece>& out) const;
  void refine(const Curve3& curve, const Track& track, const TrackPiece& piece,
              std::vector<TrackPiece>& out) const;
  void show_at_folds(const Curve3& curve, const Track& track,
                     std::vector<TrackPiece>& pieces) const;
  bool visible_at(const Curve3& curve, const Track& track, double length) const;
  bool hidden_by_others_at(const Curve3& curve, const Track& track, double length) const;
  bool clearly_hidden_at(const Curve3& curve, const Track& track, double length) const;

  const Probe& probe_;
  const Cutters& cutters_;
  CutRule rule_;
  double same_cut_;
};

/// Paper mm: cuts closer than this are one (rounding of the same crossing found twice).
inline constexpr double kSameCut = 1e-6;
/// Leaves of the shares of a segment of `length` paper mm those that are `same_cut` apart.
void thin_cuts(std::vector<double>& cuts, double length, double same_cut);

/// The pieces between sorted cuts of a curve, without answers.
std::vector<TrackPiece> pieces_between(const Track& track, std::vector<double>& cuts,
                                       double same_cut = kSameCut);

/// Pieces of like answer joined; those shorter than `minimum` paper mm take the answer of their
/// neighbours.
std::vector<TrackPiece> settle(std::vector<TrackPiece> pieces, const Track& track, double minimum);

}  // namespace burin
