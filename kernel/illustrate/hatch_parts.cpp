#include "hatch_parts.h"

#include <burin/base/error.h>
#include <burin/field/catalogue.h>
#include <burin/illustrate/view_probe.h>
#include <burin/surface/empty_surface.h>
#include <burin/tone/catalogue.h>

#include "style_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm of radius from which a surface is flat for strokes that keep an angle: over a hand's
// width the angle changes by some three degrees.
constexpr double kFlatRadius = 2000;

Field make_field(const std::vector<const Surface*>& surfaces, const HatchRequest& asked,
                 const RunContext& context) {
  if (!follows_field(asked.hatch)) {
    return {"none", [](const FieldQuery&) { return std::optional<Cross>(); }};
  }
  const field::FieldKind& kind = field::find(asked.hatch.field.name);
  if (stands_on_levels(asked.hatch) && !kind.has_levels) {
    std::vector<std::string_view> with;
    for (const field::FieldKind& other : field::catalogue()) {
      if (other.has_levels) with.push_back(other.name);
    }
    throw UsageError(
        fmt::format("hatch.placing levels asks for a hatch.field that has levels ({}); {} has none",
                    fmt::join(with, ", "), kind.name));
  }
  return kind.make({.surfaces = surfaces,
                    .camera = asked.camera,
                    .options = asked.hatch.field,
                    .light = tone::to_light(asked.camera, asked.tone),
                    .flat = asked.camera.scale() / kFlatRadius,
                    .context = context,
                    .image = asked.image});
}

// A stream of chance for each kind of strokes: points of two would lie on each other.
std::uint64_t seed_of(std::uint64_t seed, int number) {
  constexpr std::uint64_t kApart = 0x9E3779B97F4A7C15;
  return seed ^ (static_cast<std::uint64_t>(number - 1) * kApart);
}

// What stands before the lights of a scene: the solid parts.
tone::Blocked blocked_by(const Occluder& solid, double tolerance) {
  // A triangle does not hide the smooth surface that it stands for.
  const double off = std::max(4 * solid.resolution(), 2 * tolerance), far = 2 * solid.diagonal();
  return [&solid, off, far](Vec3 position, Vec3 normal, Vec3 towards, double distance) {
    return solid.occluded(position + off * normal, towards, 0, std::min(far, distance));
  };
}

// The picture of some strokes; null where they name none, or one that was not read.
std::shared_ptr<const Image> image_of(const HatchStyle& hatch, const IllustrateOptions& options) {
  const auto found = options.images.find(hatch.image);
  return found == options.images.end() ? nullptr : found->second;
}

// `occluder`: what stands before these parts.
Hatching make_hatching(const HatchRequest& asked, const Occluder& occluder, const DepthCue& cue,
                       const IllustrateOptions& options, RunContext& context) {
  std::vector<const Surface*> surfaces;
  double tolerance = 0;
  const Surfaces& all = asked.occluders->surfaces();
  for (std::size_t i = 0; i < all.size(); ++i) {
    tolerance = std::max(tolerance, all[i]->proxy().tolerance);
    surfaces.push_back(asked.parts[i] ? all[i].get() : empty_surface().get());
  }
  context.begin_stage(RunStage::Field);
  const Occluder& solid = asked.occluders->solid();
  const Camera& camera = asked.camera;
  const ViewProbe probe = view_probe(occluder, camera, asked.parts);
  const HatchScene scene{surfaces, camera, probe, context};
  const Field field = options.field ? options.field(scene) : make_field(surfaces, asked, context);
  const Tone tone = options.tone ? options.tone(scene)
                                 : tone::make(camera, asked.tone, blocked_by(solid, tolerance));
  InkOptions ink{.exponents = asked.exponents,
                 .tone_min = asked.hatch.tone_min,
                 .image = asked.image,
                 .keys = kind_group(static_cast<std::size_t>(asked.number))};
  if (!options.tone && balances(asked.tone)) ink.balance = asked.tone;
  if (!options.tone && cue.pales()) ink.fade = [&](Vec3 position) { return cue.ink(position); };
  Hatching made{
      trace_strokes(surfaces, camera, field, tone, probe, asked.hatch, asked.seed, context, ink),
      {}};
  const StrokeResult& result = made.strokes;
  for (Curve3& stroke : made.strokes.strokes) stroke.stroke_kind = asked.number;
  // Where there is no level there is no line of it to be missed.
  if (!options.field && follows_field(asked.hatch) && !stands_on_levels(asked.hatch)) {
    const Tone toned = [&](Vec3 position, Vec3 normal) {
      const double wanted = std::pow(1 - tone(position, normal), result.tone_gamma);
      return 1 - (ink.fade ? ink.fade(position) : 1.0) * wanted;
    };
    made.undirected = Undirected::look(scene, field, toned, asked.hatch);
  }
  return made;
}

}  // namespace

bool balances(const tone::ToneOptions& tone) {
  return tone.ink == tone::ToneOptions::Ink::Shade && tone::find(tone.law).uses_light;
}

HatchedParts::Hatchings HatchedParts::hatch(const std::shared_ptr<const Occluders>& occluders,
                                            const Camera& camera, const PartStyles& part_styles,
                                            const DepthCue& cue, const DepthOptions& depth,
                                            const IllustrateOptions& options, RunContext& context) {
  // Of another view nothing is of use any more.
  std::erase_if(made_, [&](const Made& one) {
    return one.request.camera != camera || one.request.occluders != occluders;
  });
  std::vector<Made> made;
  std::optional<std::size_t> standing;  // the part that `before` is for
  std::optional<Occluder> before;
  const auto occluder = [&](std::optional<std::size_t> alone) -> const Occluder& {
    if (!alone) return occluders->solid();
    if (standing != alone) {
      context.begin_stage(RunStage::Build);
      before.emplace(occluders->proxies_before(*alone), context);
      standing = alone;
    }
    return *before;
  };
  const auto add = [&](const StrokeSet& strokes, std::vector<bool> parts,
                       std::optional<std::size_t> alone) {
    HatchRequest request{occluders,
                         std::move(parts),
                         alone,
                         camera,
                         *strokes.hatch,
                         *strokes.tone,
                         strokes.number,
                         strokes.exponents,
                         depth,
                         seed_of(options.seed, strokes.number),
                         image_of(*strokes.hatch, options)};
    const auto known = std::ranges::find(made_, request, &Made::request);
    if (known != made_.end()) {
      made.push_back(*known);
      return;
    }
    auto hatching = std::make_shared<const Hatching>(
        make_hatching(request, occluder(alone), cue, options, context));
    made.push_back({std::move(request), std::move(hatching)});
  };
  // Functions of the caller's own cannot be told apart.
  if (options.field || options.tone) made_.clear();
  for (const StrokeSet& strokes : part_styles.strokes()) {
    std::vector<bool> parts = strokes.parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (part_styles.transparent(i)) parts[i] = false;
    }
    if (std::ranges::find(parts, true) != parts.end()) add(strokes, std::move(parts), {});
  }
  for (std::size_t part = 0; part < part_styles.size(); ++part) {
    if (!part_styles.transparent(part) || !part_styles.hatched(part)) continue;
    std::vector<bool> alone(part_styles.size(), false);
    alone[part] = true;
    for (const StrokeSet& strokes : part_styles.strokes()) {
      if (strokes.parts[part]) add(strokes, alone, part);
    }
  }
  Hatchings out;
  for (const Made& one : made) out.push_back(one.hatching);
  made_ = std::move(made);
  if (options.field || options.tone) made_.clear();
  return out;
}

StrokeResult told_of(std::span<const std::shared_ptr<const Hatching>> hatchings) {
  StrokeResult all;
  std::int64_t most = 0;
  for (const auto& hatching : hatchings) {
    const StrokeResult& one = hatching->strokes;
    if (one.coverage_points > most) {
      most = one.coverage_points;
      all.tone_gamma = one.tone_gamma;
    }
    all.coverage_points += one.coverage_points;
    all.coverage_delta = std::max(all.coverage_delta, one.coverage_delta);
    all.thinned_parts += one.thinned_parts;
    all.unmapped.insert(all.unmapped.end(), one.unmapped.begin(), one.unmapped.end());
  }
  return all;
}

}  // namespace burin::detail
