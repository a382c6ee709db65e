#include "hatch_parts.h"

#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/base/plugin_error.h>
#include <burin/field/catalogue.h>
#include <burin/illustrate/view_probe.h>
#include <burin/surface/empty_surface.h>
#include <burin/tone/catalogue.h>

#include "style/style_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm of radius from which a surface is flat for strokes that keep an angle: over a hand's
// width the angle changes by some three degrees.
constexpr double kFlatRadius = 2000;

// Strokes on levels ask for a field that has some.
void check_levels(const HatchStyle& hatch, const IllustrateOptions& options) {
  if (options.field || !follows_field(hatch) || !uses_level_lines(hatch)) return;
  const field::FieldKind& kind = field::find(hatch.field.name);
  if (kind.has_levels) return;
  std::vector<std::string_view> with;
  for (const field::FieldKind& other : field::catalogue()) {
    if (other.has_levels) with.push_back(other.name);
  }
  throw UsageError(
      fmt::format("hatch.placing levels asks for a hatch.field that has levels ({}); {} has none",
                  fmt::join(with, ", "), kind.name));
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

HatchPlace place_of(const StrokeSet& strokes, const Camera& camera,
                    const IllustrateOptions& options) {
  HatchPlace place{.camera = camera,
                   .field = strokes.hatch->field,
                   .follows_field = follows_field(*strokes.hatch),
                   .lines = remembered_by(*strokes.hatch),
                   .seed = seed_of(options.seed, strokes.number),
                   .image = image_of(*strokes.hatch, options)};
  if (place.follows_field && field::find(place.field.name).uses_light) {
    place.light = tone::to_light(camera, *strokes.tone);
  }
  return place;
}

// How a user asks for what stands in.
std::string fallback(const PluginError& failed, const HatchRequest& request) {
  if (failed.row() == PluginError::Row::Direction) return "hatch.field=" + request.hatch.field.name;
  if (failed.row() == PluginError::Row::Law) return "tone.law=" + request.tone.law;
  return "hatch.placing=" + request.hatch.placing;
}

// What stands in for a plug-in that failed: what asks of the surfaces no more than it did.
void do_without(const PluginError& failed, const HatchStyle& hatch, HatchRequest& request) {
  switch (failed.row()) {
    case PluginError::Row::Direction:
      request.place.field.name =
          field::find(hatch.field.name).needs_curvature ? field::FieldOptions().name : "fixed-auto";
      break;
    case PluginError::Row::Law:
      request.tone.law = tone::ToneOptions().law;
      break;
    case PluginError::Row::StrokeKind:
      request.hatch.placing = "discs";
      break;
    default:
      throw;  // nothing of strokes
  }
  request.hatch.field = request.place.field;
  request.place.lines = remembered_by(request.hatch);
}

}  // namespace

class HatchPreparation {
 public:
  /// `with_field`: else the caller brings one.
  HatchPreparation(HatchPlace place, bool with_field, RunContext& context)
      : place_(std::move(place)), surfaces_(flagged(place_)) {
    if (place_.alone) {
      context.begin_stage(RunStage::Build);
      before_.emplace(place_.occluders->proxies_before(*place_.alone), context,
                      place_.occluders->tree_options());
    }
    context.begin_stage(RunStage::Field);
    probe_ =
        view_probe(before_ ? *before_ : place_.occluders->solid(), place_.camera, place_.parts);
    if (with_field) field_ = make_field(context);
  }
  HatchPreparation(const HatchPreparation&) = delete;
  HatchPreparation& operator=(const HatchPreparation&) = delete;

  /// `remembers`: for other strokes over the same surfaces and field.
  Hatching hatch(const HatchRequest& asked, const DepthCue& cue, const IllustrateOptions& options,
                 bool remembers, RunContext& context);

 private:
  // The surfaces; empty ones where a part has no such strokes.
  static std::vector<const Surface*> flagged(const HatchPlace& place) {
    std::vector<const Surface*> out;
    const Surfaces& all = place.occluders->surfaces();
    for (std::size_t i = 0; i < all.size(); ++i) {
      out.push_back(place.parts[i] ? all[i].get() : empty_surface().get());
    }
    return out;
  }
  Field make_field(const RunContext& context) const;
  VisibleSurfaces shown(const RunContext& context) const {
    return {surfaces_,
            [probe = probe_](Vec2 paper) -> std::optional<VisiblePlace> {
              const auto hit = probe(paper);
              if (!hit || !hit->hatched) return std::nullopt;
              return VisiblePlace{hit->part, hit->point};
            },
            &context};
  }

  HatchPlace place_;
  std::vector<const Surface*> surfaces_;
  std::optional<Occluder> before_;
  ViewProbe probe_;
  Field field_;
  StrokeMemory memory_;
};

Field HatchPreparation::make_field(const RunContext& context) const {
  if (!place_.follows_field) {
    return {"none", [](const FieldQuery&) { return std::optional<Cross>(); }};
  }
  return field::find(place_.field.name)
      .make({.surfaces = surfaces_,
             .camera = place_.camera,
             .options = place_.field,
             .light = place_.light.value_or(Vec3(0, 0, 1)),
             .flat = place_.camera.scale() / kFlatRadius,
             .context = context,
             .image = place_.image,
             .shown = shown(context)});
}

Hatching HatchPreparation::hatch(const HatchRequest& asked, const DepthCue& cue,
                                 const IllustrateOptions& options, bool remembers,
                                 RunContext& context) {
  double tolerance = 0;
  for (const auto& surface : place_.occluders->surfaces()) {
    tolerance = std::max(tolerance, surface->proxy().tolerance);
  }
  const Camera& camera = place_.camera;
  const HatchScene scene{surfaces_, camera, probe_, context};
  const Field own = options.field ? options.field(scene) : Field();
  const Field& field = options.field ? own : field_;
  const Tone tone =
      options.tone ? options.tone(scene)
                   : tone::make(camera, asked.tone,
                                blocked_by(place_.occluders->solid(), tolerance), shown(context));
  InkOptions ink{.exponents = asked.exponents,
                 .tone_min = asked.hatch.tone_min,
                 .image = place_.image,
                 .keys = kind_group(static_cast<std::size_t>(asked.number))};
  if (!options.tone && balances(asked.tone)) ink.balance = asked.tone;
  if (!options.tone && cue.pales()) ink.fade = [&](Vec3 position) { return cue.ink(position); };
  Hatching made{trace_strokes(surfaces_, camera, field, tone, probe_, asked.hatch, place_.seed,
                              context, ink, remembers ? &memory_ : nullptr),
                {}};
  const StrokeResult& result = made.strokes;
  for (Curve3& stroke : made.strokes.strokes) stroke.stroke_kind = asked.number;
  // Where there is no level there is no line of it to be missed.
  if (!options.field && place_.follows_field && !uses_level_lines(asked.hatch)) {
    const Tone toned = [&](Vec3 position, Vec3 normal) {
      const double wanted = std::pow(1 - tone(position, normal), result.tone_gamma);
      return 1 - (ink.fade ? ink.fade(position) : 1.0) * wanted;
    };
    made.missing_directions = MissingDirections::look(scene, field, toned, asked.hatch);
  }
  return made;
}

bool balances(const tone::ToneOptions& tone) {
  return tone.ink == tone::ToneOptions::Ink::Shade && tone::find(tone.law).uses_light;
}

HatchedParts::Hatchings HatchedParts::hatch(const std::shared_ptr<const Occluders>& occluders,
                                            const Camera& camera, const PartStyles& part_styles,
                                            const DepthCue& cue, const DepthOptions& depth,
                                            const IllustrateOptions& options, bool keeps,
                                            RunContext& context) {
  // Of another view nothing is of use any more.
  std::erase_if(made_, [&](const Made& one) {
    return one.request.place.camera != camera || one.request.place.occluders != occluders;
  });
  std::vector<Made> made;
  const auto prepared_for = [&](const HatchPlace& place) {
    const auto fits = [&](const Made& one) { return one.prepared && one.request.place == place; };
    for (const auto* all : {&made_, &made}) {
      const auto known = std::ranges::find_if(*all, fits);
      if (known != all->end()) return known->prepared;
    }
    return std::make_shared<HatchPreparation>(place, !options.field, context);
  };
  const auto add = [&](const StrokeSet& strokes, std::vector<bool> parts,
                       std::optional<std::size_t> alone) {
    check_levels(*strokes.hatch, options);
    HatchRequest request{place_of(strokes, camera, options),
                         *strokes.hatch,
                         *strokes.tone,
                         strokes.number,
                         strokes.exponents,
                         depth};
    request.hatch.color.clear();  // of the lines when they stand
    request.place.occluders = occluders;
    request.place.parts = std::move(parts);
    request.place.alone = alone;
    const auto known = std::ranges::find(made_, request, &Made::request);
    if (known != made_.end()) {
      made.push_back(*known);
      return;
    }
    // Each of the parts that are seen alone has a tree of rays, which is not to stay.
    const bool remembers = keeps && !alone && !options.field;
    std::shared_ptr<HatchPreparation> prepared;
    auto hatching = std::make_shared<Hatching>();
    HatchRequest tried = request;
    for (std::vector<std::string> failed;;) {
      try {
        prepared = prepared_for(tried.place);
        *hatching = prepared->hatch(tried, cue, options, remembers, context);
        hatching->failed = std::move(failed);
        break;
      } catch (const PluginError& e) {
        // A row of each kind, and those that stand in for them are our own.
        do_without(e, *strokes.hatch, tried);
        failed.push_back(
            fmt::format("{}; the strokes are those of {}", e.what(), fallback(e, tried)));
      }
    }
    // The fallback was drawn with another field than the request asks for.
    if (!remembers || !hatching->failed.empty()) prepared.reset();
    made.push_back({std::move(request), std::move(prepared), std::move(hatching)});
  };
  // Functions of the caller's own cannot be told apart, nor what was added by a name that it had.
  if (options.field || options.tone || growth_ != catalogue_growth()) made_.clear();
  growth_ = catalogue_growth();
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

StrokeResult stroke_totals(std::span<const std::shared_ptr<const Hatching>> hatchings) {
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

void report_failed(const HatchedParts::Hatchings& hatchings, Diagnostics& diagnostics) {
  std::set<std::string> failures;
  for (const auto& hatching : hatchings) {
    failures.insert(hatching->failed.begin(), hatching->failed.end());
  }
  for (const std::string& text : failures) {
    diagnostics.add(Severity::Warning, "plugin.quarantined", 1, text);
  }
}

}  // namespace burin::detail
