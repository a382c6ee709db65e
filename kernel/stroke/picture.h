#pragma once
// What every step of the placement needs to know; internal to the module.

#include <burin/base/box.h>
#include <burin/stroke/marks.h>
#include <burin/stroke/stroke.h>

#include "laws.h"
#include "motif.h"
#include "tone_balance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace burin::detail {

/// How one tone is shared between two crossing families: 1 - (1-first)(1-second) = darkness.
struct Coverage2 {
  double first = 0;
  double second = 0;
};

/// From how many times its thinnest line on a pen swells.
constexpr double kLeastSwelling = 1.5;
inline bool swelling(const HatchOptions& options) {
  return options.width_max > kLeastSwelling * options.width_min;
}

/// Of a dot of that diameter, in paper mm2.
inline double dot_area(double width) { return 0.25 * std::numbers::pi * width * width; }

/// Whether everybody knows how lines run on such a face.
inline bool ruled(FaceKind kind) {
  return kind == FaceKind::Plane || kind == FaceKind::Cylinder || kind == FaceKind::Cone ||
         kind == FaceKind::Torus;
}

struct Remembered;

/// The arguments of trace_strokes and the small functions of them.
struct Picture {
  std::span<const Surface* const> surfaces;
  const Camera& camera;
  const Field& field;
  const Tone& tone;
  const ViewProbe& probe;
  const HatchOptions& options;
  std::uint64_t seed = 1;
  /// Model mm within which two places along one viewing ray are the same surface.
  double same_place = 0;
  /// What the tone of the whole picture changes of that of each place; none while the raster is
  /// made that it is found on.
  const ToneBalance* balance = nullptr;
  /// What becomes of it after that; likewise.
  const InkOptions* shaping = nullptr;
  /// What the user's formulas make of ink and strokes; likewise.
  const Laws* laws = nullptr;
  /// How strokes stand: each keeps its distance from the next; on points, where they lie over each
  /// other as chance has it; on points that keep clear of each other; as dots on such points; or
  /// along whole steps of what the field keeps.
  enum class PlacementKind { Apart, Points, Discs, Dots, Levels };
  PlacementKind placement_kind = PlacementKind::Apart;
  /// What stands on points in the place of strokes; null: strokes.
  const Motif* motif = nullptr;
  /// Marks from elsewhere, a motif each; null: `motif` is the same on all points.
  const Marks* marks = nullptr;
  /// What the same strokes in another light have left, and are left; null: nothing is kept.
  Remembered* memory = nullptr;
  /// Between lines that stand along levels of the field; 0: none do.
  double level_step = 0;

  /// The same picture with lines that follow another field, which has to live as long.
  Picture following(const Field& other) const {
    return {surfaces, camera,  other, tone,           probe, options, seed,   same_place,
            balance,  shaping, laws,  placement_kind, motif, marks,   memory, level_step};
  }

  bool by_chance() const {
    return placement_kind != PlacementKind::Apart && placement_kind != PlacementKind::Levels;
  }
  bool dots() const { return placement_kind == PlacementKind::Dots; }

  /// Where strokes are laid: the sheet, and so much beside it that the strokes at its edge have
  /// neighbours on both sides.
  Box2 sheet() const {
    const Vec2 beside(std::max(2 * options.spacing_max, by_chance() ? options.length : 0));
    return {-beside, Vec2(camera.paper().width, camera.paper().height) + beside};
  }
  bool on_sheet(Vec2 paper) const { return sheet().contains(paper); }

  const Surface& surface(std::int32_t part) const {
    return *surfaces[static_cast<std::size_t>(part)];
  }

  /// What lines through a point keep, where the field knows.
  std::optional<Level> level(std::int32_t part, const SurfacePoint& point,
                             const Frame& frame) const {
    const auto cross = field.cross({part, point, frame});
    return cross ? cross->level : std::nullopt;
  }

  /// Whether a place of a proxy, at its point on paper and its depth, is what the viewer sees
  /// there.
  bool seen(std::int32_t part, std::uint32_t face, Vec2 paper, double depth) const {
    const auto hit = probe(paper);
    // Beside the occluder's polygon, though not beside the true surface: at the very outline.
    if (!hit || (hit->part == part && hit->point.face == face)) return true;
    const Vec3 nearer = hit->hatched
                            ? surface(hit->part).proxy().position(hit->point.face, hit->point.bary)
                            : hit->position;
    return camera.depth(nearer) - depth <= same_place;
  }

  /// Ink asked for in [0,1] at a point of a smooth region; `cosine` is that between its normal and
  /// the viewer, to whom the tone sees it turned. None where a section was closed: that is hatched.
  double darkness(std::int32_t part, std::int32_t region, Vec3 position, Vec3 normal,
                  double cosine) const {
    if (surface(part).proxy().is_cut_region(region)) return 0;
    const double asked = std::clamp(1 - tone(position, cosine < 0 ? -normal : normal), 0.0, 1.0);
    return toned(asked, part, region, position);
  }

  /// The same where the point of the surface is known: laws may look at it.
  double darkness(std::int32_t part, std::int32_t region, const SurfacePoint& point,
                  const Frame& frame, double cosine) const {
    const double ink = darkness(part, region, point.position, frame.normal, cosine);
    if (laws == nullptr || !laws->shape_picture()) return ink;
    if (surface(part).proxy().is_cut_region(region)) return 0;
    return laws->inked({part, point, frame, std::abs(cosine), ink}, surface(part), field);
  }
  /// By what factor strokes stand closer there.
  double denser(std::int32_t part, const SurfacePoint& point, const Frame& frame) const {
    if (laws == nullptr || laws->density.plain()) return 1;
    const double cosine = glm::dot(frame.normal, camera.to_viewer(point.position));
    return laws->denser({part, point, frame, std::abs(cosine)}, surface(part), field);
  }

  /// What the whole picture makes of the ink that the tone of a place asks for.
  double toned(double asked, std::int32_t part, std::int32_t region, Vec3 position) const {
    double wanted = balance ? balance->ink(asked, part, region, camera.depth(position)) : asked;
    if (shaping == nullptr) return wanted;
    if (shaping->fade) wanted *= shaping->fade(position);
    if (shaping->exponents.empty()) return wanted;
    const double exponent = shaping->exponents[static_cast<std::size_t>(part)];
    if (exponent == 1) return wanted;
    // Paper that the tone leaves white stays so, however little of its ink these strokes have.
    return wanted < shaping->tone_min ? 0 : shared(wanted, exponent);
  }

  /// The part of some ink that strokes of an exponent of InkOptions have.
  static double shared(double ink, double exponent) { return 1 - std::pow(1 - ink, exponent); }

  /// Model mm of depth that a surface seen under a cosine of `facing` may change by a paper mm;
  /// `scale` in paper mm a model mm.
  static double slope(double facing, double scale) {
    constexpr double kLeastFacing = 0.02;  // seen more edge-on, a surface is not drawn on
    const double c = std::clamp(facing, kLeastFacing, 1.0);
    return (std::sqrt(1 - c * c) / c + 0.1) / scale;
  }

  Coverage2 share(double darkness) const {
    // Each line of the second family grows out of nothing at a place of its own.
    constexpr double kFull = 0.9;  // ink at which it has as much as the first
    constexpr double kMost = 0.5;
    if (options.cross_from > 1) return {darkness, 0};
    if (one_pen()) return nested(darkness);
    const double span = std::max(kFull - options.cross_from, 0.1);
    const double t = std::clamp((darkness - options.cross_from) / span, 0.0, 1.0);
    const double second = kMost * t * std::sqrt(t);
    return {1 - (1 - darkness) / (1 - second), second};
  }

  /// The same of lines that have nothing but their distances to carry it: from where they cross the
  /// first family stays as it is until the second is as dense, then both grow alike.
  Coverage2 nested(double darkness) const {
    if (!(darkness > options.cross_from)) return {darkness, 0};
    const double most = std::min(0.95, options.width_min / options.spacing_min),
                 held = std::min(options.cross_from, most);
    const double alike = std::min(1 - std::sqrt(1 - darkness), most);
    const double first = std::max(held, alike);
    return {first, 1 - (1 - darkness) / (1 - first)};
  }

  double share(double darkness, int family) const {
    const Coverage2 c = share(darkness);
    return family == 1 ? c.first : c.second;
  }

  /// The sum of the areas of strokes a mm^2 that cover a share `ink` of it. Where chance lays one
  /// over another the last bit of white is never covered. @cite Stoyan1995
  double laid(double ink) const {
    constexpr double kMost = 0.96;
    if (!by_chance()) return ink;
    const double bare = -std::log1p(-std::min(ink, kMost)), k = clearing();
    return (std::sqrt(1 + 4 * k * bare) - 1) / (2 * k);
  }

  /// The share that such a sum covers.
  double covered(double laid) const {
    if (!by_chance()) return std::min(1.0, laid);
    return -std::expm1(-laid * (1 + clearing() * laid));
  }

  /// Strokes by chance leave exp(-a - k a^2) of the paper white, a being the sum of their areas; k
  /// would be 0 if nothing kept them apart. Measured on a plane, a from 0.2 to 1.4, strokes 2 to 8
  /// mm long, pens up to 0.2 and 0.4 mm: widths that are evened out make it about 0.04 on points;
  /// on discs it is 0.09 to 0.32, by how far a stroke reaches beyond its disc; of dots 0.65.
  double clearing() const {
    switch (placement_kind) {
      case PlacementKind::Dots:
        return 0.65;
      case PlacementKind::Discs: {
        if (motif) return 0.5;  // next to none lies over another
        const double width = 0.5 * (options.width_min + options.width_max);
        return std::min(0.65, 0.85 * std::sqrt(width / options.length));
      }
      default:
        return 0.04;
    }
  }

  /// The width of a stroke that no neighbour tells how wide to be.
  double free_width(double ink) const {
    return options.width_min + (options.width_max - options.width_min) * ink;
  }

  /// Whether the width of lines carries the tone; else their distance does.
  bool swells() const { return swelling(options); }
  /// ... and nothing else does: the pen has one width, or next to.
  bool one_pen() const {
    constexpr double kSame = 1.2;
    return placement_kind == PlacementKind::Apart && options.width_max <= kSame * options.width_min;
  }

  /// Distance between neighbours of a family that is to cover a share `ink` of the paper: always
  /// the same where lines swell; wider where it is lighter with a pen of one width.
  double line_spacing(double ink) const {
    if (swells()) return options.spacing_min;
    if (ink <= 0) return options.spacing_max;
    return std::clamp(options.width_min / ink, options.spacing_min, options.spacing_max);
  }

  /// The mean distance of lines, those counted that fade out into the light.
  double spacing(double ink) const {
    constexpr double kThin =
        1.25;  // of the thinnest pen: what a line of the widest grid has left to thin out
    if (ink <= 0) return options.spacing_max;
    return std::clamp(kThin * options.width_min / ink, options.spacing_min, options.spacing_max);
  }
};

}  // namespace burin::detail
