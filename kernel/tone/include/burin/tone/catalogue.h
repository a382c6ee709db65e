#pragma once
/// The laws of tone by name, as styles ask for them: one row each.

#include <burin/tone/tone.h>

#include <span>
#include <string_view>

namespace burin::tone {

struct Law {
  std::string_view name;
  /// What makes a place light, in a few words.
  std::string_view meaning;
  /// Whether it looks at `ToneOptions::light`.
  bool uses_light = false;
  /// The reflectance before rim and highlight; it may leave [0,1]. `blocked` may be empty.
  Tone (*make)(const Camera& camera, const ToneOptions& options, const Blocked& blocked);
};

/// From the model to the light in model space, as long as it was given.
Vec3 to_light(const Camera& camera, const ToneOptions& options);

/// All laws, the usual one first.
std::span<const Law> catalogue();

/// The law of that name. Throws UsageError that lists them all.
const Law& find(std::string_view name);

}  // namespace burin::tone
