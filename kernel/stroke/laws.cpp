#include "laws.h"

#include <burin/base/error.h>
#include <burin/base/rng.h>

#include "motif.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace burin::detail {
namespace {

enum Variable { X, Y, Z, Nx, Ny, Nz, U, V, Facing, Lean, Ink, Random, Along };
constexpr std::size_t kVariables = Along + 1;
constexpr std::array<std::string_view, kVariables> kNames{
    "x", "y", "z", "nx", "ny", "nz", "u", "v", "facing", "lean", "ink", "random", "t"};
constexpr std::array<std::string_view, 1> kOutside{"image"};
// Of a place; of a stroke too; of a place along a stroke.
constexpr std::size_t kOfPlace = Random, kOfStroke = Along, kOfSample = kVariables;

expression::Formula compiled(const std::string& text, const std::string& key, std::size_t known) {
  try {
    return {text, std::span(kNames).first(known), kOutside};
  } catch (const UsageError& e) {
    throw UsageError(fmt::format("style key '{}': {}", key, e.what()));
  }
}

const HatchOptions kPlain{};

}  // namespace

Law::Law(const std::string& text, const std::string& plain, const std::string& key,
         std::size_t known, std::shared_ptr<const Image> image)
    : key_(key), plain_(text == plain), formula_(compiled(text, key, known)) {
  if (image) {
    image_ = [image = std::move(image)](std::size_t, double u, double v) {
      return image->at(u, v);
    };
  }
}

bool Law::needs_image() const { return formula_.calls_outside(); }

bool Law::needs_parameters() const { return formula_.uses(U) || formula_.uses(V); }

double Law::at(const LawPlace& place, const Surface& surface, const Field& field,
               double otherwise) const {
  std::array<double, kVariables> values{};
  const Vec3 p = place.point.position, n = place.frame.normal;
  for (int i = 0; i < 3; ++i) {
    values[static_cast<std::size_t>(X + i)] = p[i];
    values[static_cast<std::size_t>(Nx + i)] = n[i];
  }
  if (needs_parameters()) {
    const auto uv = surface.parameters(place.point);
    if (!uv) return otherwise;
    values[U] = uv->x;
    values[V] = uv->y;
  }
  if (formula_.uses(Lean)) {
    const auto cross = field.cross({place.part, place.point, place.frame});
    values[Lean] = cross ? cross->lean : 0;
  }
  values[Facing] = place.facing;
  values[Ink] = place.ink;
  values[Random] = place.random;
  values[Along] = place.along;
  const double value = formula_(values, image_);
  if (!std::isfinite(value)) {
    throw UsageError(
        fmt::format("style key '{}': the formula gives no finite number in places (it divides by "
                    "zero, or takes a root or logarithm of what is negative); bound it by max, min "
                    "or clamp",
                    key_));
  }
  return value;
}

Laws::Laws(const HatchOptions& options, const std::string& group,
           const std::shared_ptr<const Image>& image)
    : ink(options.ink_law, kPlain.ink_law, group + "ink_law", kOfPlace, image),
      density(options.density_law, kPlain.density_law, group + "density_law", kOfPlace, image),
      width(options.width_law, kPlain.width_law, group + "width_law", kOfSample, image),
      length(options.length_law, kPlain.length_law, group + "length_law", kOfStroke, image),
      presence(options.presence_law, kPlain.presence_law, group + "presence_law", kOfStroke,
               image) {
  if (options.has_image()) return;
  for (const Law* law : {&ink, &density, &width, &length, &presence}) {
    if (!law->needs_image()) continue;
    throw UsageError(fmt::format(
        "style key '{}': image(u, v) asks for a picture; name one by {}image", law->key(), group));
  }
}

bool Laws::need_parameters() const {
  const std::array all{&ink, &density, &width, &length, &presence};
  return std::ranges::any_of(all, [](const Law* law) { return law->needs_parameters(); });
}

double Laws::inked(const LawPlace& place, const Surface& surface, const Field& field) const {
  if (!density.plain() && density.at(place, surface, field, 1) <= 0) return 0;
  return ink.plain() ? place.ink : std::clamp(ink.at(place, surface, field, place.ink), 0.0, 1.0);
}

double Laws::denser(const LawPlace& place, const Surface& surface, const Field& field) const {
  // Beyond, the phase of lines would not follow, and points be without number.
  constexpr double kLeast = 0.2, kMost = 5;
  if (density.plain()) return 1;
  return std::clamp(density.at(place, surface, field, 1), kLeast, kMost);
}

double Laws::random(std::uint64_t seed, std::int32_t part, int family, std::uint64_t law,
                    std::size_t stroke) {
  constexpr std::uint64_t kStream = 16;  // away from those of families
  return Rng(seed, static_cast<std::uint64_t>(part),
             kStream * law + static_cast<std::uint64_t>(family))
      .uniform(stroke);
}

}  // namespace burin::detail

namespace burin {

void check_texts(const HatchOptions& options, const std::string& group) {
  const detail::Laws compiled(options, group, nullptr);
  if (options.has_motif() && !options.motif_is_file()) detail::motif_of(options, group, 1);
}

}  // namespace burin
