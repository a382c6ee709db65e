#include "texture.h"

#include <burin/converters/mesh_reader.h>
#include <burin/repair/polygons.h>

#include "text.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace burin {
namespace {

bool is_known(glm::vec2 uv) { return std::isfinite(uv.x) && std::isfinite(uv.y); }

}  // namespace

float texture_coordinate(std::string_view word) {
  double value = 0;
  return parse_double(word, value) ? static_cast<float>(value) : kNoTexture;
}

std::shared_ptr<const TextureMap> texture_of(const PolygonSoup& soup, const RunContext& context) {
  if (soup.texture.empty()) return nullptr;
  TriMesh mesh;
  mesh.positions = soup.positions;
  std::vector<glm::vec2> corners;
  std::vector<Vec3> around;
  std::vector<std::uint32_t> numbers;
  std::vector<Triangle> cut;
  for (std::size_t f = 0; f < soup.polygon_count(); ++f) {
    context.check();
    const std::size_t first = soup.offsets[f], n = soup.offsets[f + 1] - first;
    // By the corners' numbers in the polygon: two of them may be one position, each with its own u
    // and v.
    numbers.resize(n);
    std::iota(numbers.begin(), numbers.end(), 0U);
    around.resize(n);
    for (std::size_t k = 0; k < n; ++k) around[k] = soup.positions[soup.indices[first + k]];
    cut.resize(n - 2);
    triangulate_polygon(around, numbers, cut, context);
    for (const Triangle& t : cut) {
      Triangle& triangle = mesh.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        triangle[k] = soup.indices[first + t[k]];
        corners.push_back(soup.texture[first + t[k]]);
      }
    }
  }
  return std::make_shared<const TextureMap>(std::move(mesh), std::move(corners));
}

void drop_empty_texture(PolygonSoup& soup) {
  if (std::ranges::none_of(soup.texture, is_known)) soup.texture = {};
}

std::int64_t polygons_without_texture(const PolygonSoup& soup) {
  if (soup.texture.empty()) return 0;
  std::int64_t count = 0;
  for (std::size_t f = 0; f < soup.polygon_count(); ++f) {
    const auto corners =
        std::span(soup.texture).subspan(soup.offsets[f], soup.offsets[f + 1] - soup.offsets[f]);
    count += !std::ranges::all_of(corners, is_known);
  }
  return count;
}

}  // namespace burin
