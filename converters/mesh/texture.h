#pragma once
/// Texture coordinates of mesh files.

#include <burin/base/run_context.h>
#include <burin/forms/mesh/texture_map.h>
#include <burin/mesh/tri_mesh.h>

#include <limits>
#include <memory>
#include <string_view>

namespace burin {

inline constexpr float kNoTexture = std::numeric_limits<float>::quiet_NaN();

/// A word as u or v; kNoTexture where it is no number: some programs write "-nan(ind)", and texture
/// is not worth refusing a model.
float texture_coordinate(std::string_view word);

/// u and v of a soup, or nothing where it has none. To be taken before `repair`.
std::shared_ptr<const TextureMap> texture_of(const PolygonSoup& soup, const RunContext& context);

/// How many polygons have corners without u and v though others have them.
std::int64_t polygons_without_texture(const PolygonSoup& soup);

}  // namespace burin
