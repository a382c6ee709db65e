#pragma once
/// The laws of tone by name, as styles ask for them: one row each.

#include <burin/options/declared.h>
#include <burin/tone/tone.h>

#include <functional>
#include <span>
#include <string_view>

namespace burin::tone {

/// What a law may be made from; it outlives the law.
struct LawRequest {
  const Camera& camera;
  const ToneOptions& options;
  /// May be empty.
  const Blocked& blocked;
  const VisibleSurfaces& shown;
};

struct Law {
  std::string_view name;
  /// What makes a place light, in a few words.
  std::string_view meaning;
  /// Whether it looks at `ToneOptions::light`.
  bool uses_light = false;
  /// The reflectance before rim and highlight; it may leave [0,1].
  std::function<Tone(const LawRequest&)> make;
  /// What it lets a user choose beside `ToneOptions`; the values stand in `ToneOptions::declared`.
  std::vector<DeclaredOption> options{};
  /// Those of `tone_option_rows` between "light" and "highlight" that it looks at; all laws have
  /// the others.
  std::vector<std::string_view> looks_at{};
};

/// From the model to the light in model space, as long as it was given.
Vec3 to_light(const Camera& camera, const ToneOptions& options);

/// Cosine to the light up to which a part of one flat colour counts as unlit where shadows are
/// cast, as the darkest of five steps does: where light only grazes, the facets of round surfaces
/// shade each other.
inline constexpr double kUnlit = 0.2;

/// All laws, the usual one first; those that were added last.
std::span<const Law> catalogue();

/// Adds a law from elsewhere, or puts it in the place of one of its name that was added. Its texts
/// live as long as the program. Throws UsageError where a law of our own has the name.
void add(Law law);

/// The law of that name. Throws UsageError that lists them all.
const Law& find(std::string_view name);

}  // namespace burin::tone
