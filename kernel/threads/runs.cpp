#include "runs.h"

#include <utility>

namespace burin::detail {
namespace {

/// Halvings of a piece: beyond them is rounding.
constexpr int kHalvings = 48;

using At = std::function<std::optional<OwnPlace>(double)>;

/// Where a stretch ends between a parameter with a place and one without.
OwnPlace end_between(double there, OwnPlace place, double gone, const At& at) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (there + gone);
    if (auto found = at(middle)) {
      there = middle;
      place = *found;
    } else {
      gone = middle;
    }
  }
  return place;
}

void add(const std::vector<OwnPlace>& places, bool closed, Curve3 curve, std::vector<Curve3>& out) {
  if (places.size() < 2) return;
  const bool within = places.front().triangle < 0;
  curve.closed = closed;
  for (const OwnPlace& place : places) {
    curve.points.push_back(place.point);
    if (!within) curve.normals.push_back(place.normal);
  }
  const std::size_t count = curve.segment_count();
  if (within) {
    curve.self_hidden.assign(count, 1);
  } else {
    for (std::size_t i = 0; i < count; ++i) curve.faces.push_back(places[i].triangle);
  }
  out.push_back(std::move(curve));
}

}  // namespace

void add_runs(double from, double to, int pieces, const At& at, const Curve3& like,
              std::vector<Curve3>& out, bool closes) {
  if (!(to > from)) return;
  const auto parameter = [&](int i) { return from + (to - from) * i / pieces; };
  std::vector<OwnPlace> run;
  std::optional<OwnPlace> before;
  bool whole = true;
  for (int i = 0; i <= pieces; ++i) {
    const double here = parameter(i);
    const auto place = at(here);
    whole = whole && place;
    if (place && !before && i > 0) {
      run.push_back(end_between(here, *place, parameter(i - 1), at));
    }
    if (place) {
      run.push_back(*place);
    } else if (before) {
      run.push_back(end_between(parameter(i - 1), *before, here, at));
      add(std::exchange(run, {}), false, like, out);
    }
    before = place;
  }
  const bool closed = closes && whole;
  if (closed) run.pop_back();
  add(run, closed, like, out);
}

}  // namespace burin::detail
