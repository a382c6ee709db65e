#include "motif_strokes.h"

#include <cmath>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

// A surface may pull two neighbours of a motif apart by this factor; where it does by more, as
// beside a vertex at which marches part, the line is broken.
constexpr double kMostStretch = 4;
// Halvings of a step to find where a line ends: to a thousandth of it.
constexpr int kMotifHalvings = 10;

class MotifWalk {
 public:
  MotifWalk(const Picture& picture, std::int32_t part, const StrokeSample& middle, double size)
      : picture_(picture),
        surface_(picture.surface(part)),
        part_(part),
        middle_(middle),
        size_(size / picture.camera.scale_at(middle.point.position)) {
    const bool leftwards =
        middle.direction.x < 0 || (middle.direction.x == 0 && middle.direction.y < 0);
    x_ = leftwards ? -middle.tangent : middle.tangent;
    y_ = glm::cross(middle.front ? middle.normal : -middle.normal, x_);
  }

  /// The sample at a place of the motif; nothing where the surface does not go on to it or is not
  /// drawn on.
  std::optional<StrokeSample> at(Vec2 place) const {
    const double length = size_ * glm::length(place);
    StrokeSample out = middle_;
    if (length > 0) {
      const MarchStep step = surface_.march(middle_.point, place.x * x_ + place.y * y_, length);
      if (step.stop != MarchStop::Completed) return std::nullopt;
      look_at(picture_, part_, step.end, surface_.frame(step.end), out);
    }
    if (!may_begin(picture_, out) || out.front != middle_.front) return std::nullopt;
    return out;
  }

  /// Model mm between two samples beyond which they are no neighbours.
  double apart(Vec2 a, Vec2 b) const { return kMostStretch * size_ * glm::distance(a, b); }

 private:
  const Picture& picture_;
  const Surface& surface_;
  std::int32_t part_;
  const StrokeSample& middle_;
  double size_;
  Vec3 x_{0}, y_{0};
};

// A place of the motif and, where it lies on the surface, the sample there.
struct Place {
  Vec2 motif{0};
  std::optional<StrokeSample> sample;
};

// The last place on the way from `on` to `off` that lies on the surface.
Place last_on(const MotifWalk& walk, Place on, Vec2 off) {
  for (int i = 0; i < kMotifHalvings; ++i) {
    const Vec2 middle = 0.5 * (on.motif + off);
    if (auto sample = walk.at(middle);
        sample && glm::distance(sample->point.position, on.sample->point.position) <=
                      walk.apart(on.motif, middle)) {
      on = {middle, sample};
    } else {
      off = middle;
    }
  }
  return on;
}

// All places of a line, no two neighbours farther apart than `step`.
std::vector<Place> places_of(const MotifWalk& walk, const Motif::Line& line, double step) {
  std::vector<Place> places;
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
    const Vec2 a = line.points[i], b = line.points[(i + 1) % n];
    const double count = std::max(1.0, std::ceil(glm::distance(a, b) / step));
    for (double k = 0; k < count; ++k) places.push_back({glm::mix(a, b, k / count), {}});
  }
  if (!line.closed) places.push_back({line.points.back(), {}});
  for (Place& place : places) place.sample = walk.at(place.motif);
  return places;
}

// The stretches of a line that lie on the surface, as samples; sets `whole` where that is all of a
// closed one.
std::vector<std::vector<StrokeSample>> stretches(const MotifWalk& walk,
                                                 const std::vector<Place>& places, bool closed,
                                                 bool& whole) {
  const std::size_t n = places.size();
  const auto joined = [&](const Place& a, const Place& b) {
    return a.sample && b.sample &&
           glm::distance(a.sample->point.position, b.sample->point.position) <=
               walk.apart(a.motif, b.motif);
  };
  // A closed line that is broken begins behind a break.
  std::size_t first = 0;
  whole = closed;
  for (std::size_t i = 0; closed && i < n; ++i) {
    if (joined(places[i], places[(i + 1) % n])) continue;
    first = i + 1;
    whole = false;
    break;
  }
  std::vector<std::vector<StrokeSample>> out;
  std::vector<StrokeSample> run;
  const auto add = [&](const Place& place) {
    if (!place.sample) return;
    if (run.empty() || run.back().point.position != place.sample->point.position) {
      run.push_back(*place.sample);
    }
  };
  const auto end_run = [&](const Place& before, const Place& here) {
    if (before.sample) add(last_on(walk, before, here.motif));
    if (run.size() > 1) out.push_back(std::move(run));
    run.clear();
  };
  const bool broken = closed && !whole;
  for (std::size_t k = 0; k < n; ++k) {
    const Place& here = places[(first + k) % n];
    if (k > 0 || broken) {
      const Place& before = places[(first + k + n - 1) % n];
      if (!joined(before, here)) {
        if (k > 0) end_run(before, here);
        if (here.sample) add(last_on(walk, here, before.motif));
      }
    }
    add(here);
  }
  if (broken) {
    end_run(places[(first + n - 1) % n], places[first % n]);
  } else if (run.size() > 1) {
    out.push_back(std::move(run));
  }
  return out;
}

// Which way the line runs at its samples, and what is seen of them.
void direct(const Picture& picture, std::int32_t part, bool closed,
            std::vector<StrokeSample>& samples) {
  const std::size_t n = samples.size();
  for (std::size_t i = 0; i < n; ++i) {
    StrokeSample& s = samples[i];
    const StrokeSample& next = i + 1 < n ? samples[i + 1] : closed ? samples.front() : s;
    const StrokeSample& before = &next == &s ? samples[i - 1] : s;
    const Vec3 way = next.point.position - before.point.position;
    s.tangent = normalize_or(reject(way, s.normal), s.tangent);
    const Vec2 v = picture.camera.velocity(s.point.position, s.tangent);
    if (const double speed = glm::length(v); speed > 0) s.direction = v / speed;
    s.visible = s.visible && picture.seen(part, s.face, s.paper, s.depth);
  }
}

}  // namespace

std::vector<TracedStroke> motif_strokes(const Picture& picture, const Motif& motif,
                                        std::int32_t part, int family, const StrokeSample& middle,
                                        double size, std::size_t number) {
  std::vector<TracedStroke> out;
  if (!(size > 0)) return out;
  const MotifWalk walk(picture, part, middle, size);
  for (const Motif::Line& line : motif.lines) {
    const std::vector<Place> places = places_of(walk, line, kStep / size);
    bool whole = false;
    for (std::vector<StrokeSample>& samples : stretches(walk, places, line.closed, whole)) {
      direct(picture, part, whole, samples);
      TracedStroke stroke;
      stroke.part = part;
      stroke.family = family;
      stroke.samples = std::move(samples);
      stroke.closed = whole;
      // Lines of a motif end where they are drawn to end: no taper.
      stroke.begin_reason = stroke.end_reason = whole ? StrokeEnd::Closed : StrokeEnd::Edge;
      stroke.whole = TracedStroke::Whole{number, middle};
      out.push_back(std::move(stroke));
    }
  }
  return out;
}

}  // namespace burin::detail
