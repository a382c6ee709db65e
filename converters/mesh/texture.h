#pragma once
/// Texture coordinates of mesh files.

#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <limits>
#include <string_view>

namespace burin {

inline constexpr float kNoTexture = std::numeric_limits<float>::quiet_NaN();

/// A word as u or v; kNoTexture where it is no number: some programs write "-nan(ind)", and texture
/// is not worth refusing a model.
float texture_coordinate(std::string_view word);

/// Takes the texture off a soup of which no corner has u and v.
void drop_empty_texture(PolygonSoup& soup);

/// How many polygons have corners without u and v though others have them.
std::int64_t polygons_without_texture(const PolygonSoup& soup);

}  // namespace burin
