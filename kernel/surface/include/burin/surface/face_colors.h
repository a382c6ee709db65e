#pragma once
/// Colours that an input gives to single faces of a part.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// What faces of a part are coloured like that differ from the part itself.
struct FaceColors {
  /// "#rrggbb", of glass "#rrggbbaa" with its opacity, each once; none is that of the part.
  std::vector<std::string> colors;
  /// For each face of the input, by the number that `ProxyMesh::face_source` gives, its place in
  /// `colors`; -1: the face has the colour of the part, as have those beyond the end.
  std::vector<std::int32_t> of_face;

  std::int32_t at(std::int32_t face) const {
    const auto i = static_cast<std::size_t>(face);
    return face >= 0 && i < of_face.size() ? of_face[i] : -1;
  }
};

/// A part that may have several colours.
struct PaintedFaces {
  /// That of most of its area, but for glass where not all is; empty where most of it has none.
  std::string color;
  /// The others; absent where all faces have that one.
  std::shared_ptr<const FaceColors> faces;
};

/// `color`: as FaceColors, of each face, or empty. `area`: of each face, in any unit, one number;
/// fewer: 0. Faces without a colour look like the part.
PaintedFaces painted_faces(std::span<const std::string> color, std::span<const double> area);

/// How many colours a part has: that of the part, where it has one, and those of its faces.
std::int64_t count_colors(const std::string& part, const FaceColors* faces);

}  // namespace burin
