#pragma once
/// What a user reads who asks for a piece that this Burin was built without.

#include <string>
#include <string_view>

namespace burin {

/// The pieces (cmake/pieces.cmake).
inline constexpr std::string_view kWithOcct = "OCCT (BURIN_CAD)";
inline constexpr std::string_view kWithOpenscad = "its evaluator of trees (BURIN_OPENSCAD)";
inline constexpr std::string_view kWithPictures = "cairo and libpng (BURIN_PICTURES)";

/// "STEP files", kWithOcct: "STEP files need Burin with OCCT (BURIN_CAD)".
inline std::string needs(std::string_view what, std::string_view piece) {
  return std::string(what) + " need Burin with " + std::string(piece);
}

}  // namespace burin
