#pragma once
// Faces, edges and points that rows of an illustration name; internal to the module.

#include "key_row.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

/// The number of a word among those that a key takes.
template <std::size_t N>
std::size_t word_of(const KeyedFile& in, const Json& value, const std::string& path,
                    const std::array<const char*, N>& words) {
  const std::string given = in.text(value, path);
  const auto found = std::ranges::find(words, given);
  if (found == words.end()) {
    in.fail(path, fmt::format("\"{}\" takes {}, not {}", path.substr(path.rfind('/') + 1),
                              fmt::join(words, ", "), given));
  }
  return static_cast<std::size_t>(found - words.begin());
}

/// What such a key takes.
template <std::size_t N>
Json words_schema(const char* what, const std::array<const char*, N>& words) {
  return {{"description", what}, {"enum", words}};
}

inline Json vector_json(const Vec3& v) { return Json{v.x, v.y, v.z}; }

/// [x, y, z], a point near a face, or "part" with one of "face", "edge" and "point".
FeatureRow read_feature(const KeyedFile& in, const Json& value, const std::string& path);
/// That, or parts by a selector, as text or as "part" alone: what a note points at.
FeatureRow read_target(const KeyedFile& in, const Json& value, const std::string& path);
Json write_feature(const FeatureRow& feature);
Json feature_schema();
Json target_schema();

/// How numbers are written, and the view that has them: members of dimensions and notes.
std::vector<KeyRow<DimensionRow>> number_rows();
/// A name in braces that is not among these.
std::optional<std::string> unknown_brace(const std::string& text,
                                         const std::vector<std::string>& names);
/// A text may have these names in braces alone, which `known` tells to a user.
void check_braces(const KeyedFile& in, const std::string& text, const std::string& path,
                  const std::vector<std::string>& names, const std::string& known);

}  // namespace burin::detail
