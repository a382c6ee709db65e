#include "halves.h"

#include <cmath>

namespace burin::recognised {
namespace {

// Of an edge: how far along it halfway between the parameters of its ends may be off its middle.
constexpr double kAside = 0.1;

}  // namespace

std::optional<Middle> Halves::find(Ends ends, std::span<const SurfaceRef> refs, SurfaceRef round,
                                   bool within) const {
  if (within && patch(round).sheet) {
    if (auto found = on_sheet(ends, round)) return found;
  }
  if (auto found = around(ends, refs, round)) return found;
  Middle out{.at = 0.5 * (position(ends.first) + position(ends.second)), .place = {}};
  return meet_(refs, out.at) ? std::optional(out) : std::nullopt;
}

/// Halfway between the parameters of the ends, which needs no search; none where that is not near
/// the middle of the chord.
std::optional<Middle> Halves::on_sheet(Ends ends, SurfaceRef ref) const {
  const Patch& on = patch(ref);
  const Vec3 a = position(ends.first), b = position(ends.second);
  const Vec2 from = place_of(ref, ends.first).uv, period = on.sheet->period();
  Vec2 way = place_of(ref, ends.second).uv - from;
  for (int k = 0; k < 2; ++k) {
    if (period[k] > 0) way[k] -= period[k] * std::round(way[k] / period[k]);
  }
  const Vec2 uv = from + 0.5 * way;
  const SurfaceDerivatives d = on.sheet->derivatives(uv);
  const Vec3 off = d.p - 0.5 * (a + b);
  if (!(glm::length(off) <= 2 * on.sagitta) ||
      !(std::abs(glm::dot(off, b - a)) <= kAside * glm::dot(b - a, b - a))) {
    return std::nullopt;
  }
  return Middle{d.p, {ref, on.outward(d), uv}};
}

/// Halfway around an axis, where that is on the other surface too: a rim is a circle though the
/// surfaces hardly cross there, as a fillet and what it runs into.
std::optional<Middle> Halves::around(Ends ends, std::span<const SurfaceRef> refs,
                                     SurfaceRef ref) const {
  const Patch& on = patch(ref);
  if (on.sheet) return std::nullopt;
  const Vec3 a = position(ends.first), b = position(ends.second);
  const Vec3 middle = on.halfway(a, b);
  if (!(glm::length(middle - 0.5 * (a + b)) <= 2 * on.sagitta)) return std::nullopt;
  if (refs.size() > 1 && !meet_.holds(refs, middle)) return std::nullopt;
  return Middle{middle, {}};
}

/// Each corner is asked for by all edges there.
const KnownPlace& Halves::place_of(SurfaceRef ref, std::uint32_t vertex) const {
  if (places_.size() < mesh_.mesh.positions.size()) places_.resize(mesh_.mesh.positions.size());
  KnownPlace& place = places_[vertex];
  if (place.of == ref) return place;
  const Vec3 p = position(vertex);
  const Patch& on = patch(ref);
  place.of = ref;
  if (on.sheet) {
    place.uv = on.sheet->locate(p, on.window);
    place.normal = on.outward(on.sheet->derivatives(place.uv));
  } else {
    place.normal = on.normal_at(p);
  }
  return place;
}

void Halves::keep_last(const KnownPlace& place) {
  if (place.of < 0) return;
  places_.resize(mesh_.mesh.positions.size());
  places_.back() = place;
}

}  // namespace burin::recognised
