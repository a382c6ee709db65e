#include "shapes.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// From the triangle `first` to before `end`.
PolygonSoup part_of(const PolygonSoup& mesh, std::size_t first, std::size_t end) {
  if (end - first == mesh.polygon_count()) return mesh;
  PolygonSoup soup;
  soup.positions = mesh.positions;
  const auto corner = [](const auto& corners, std::size_t triangle) {
    return corners.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
  };
  soup.indices.assign(corner(mesh.indices, first), corner(mesh.indices, end));
  if (!mesh.texture.empty()) {
    soup.texture.assign(corner(mesh.texture, first), corner(mesh.texture, end));
  }
  for (std::size_t i = 1; i <= end - first; ++i) soup.offsets.push_back(3 * i);
  return soup;
}

}  // namespace

std::size_t ThreeMfShapes::add(const std::string& path, const std::string& id,
                               const ThreeMfObject& object, double unit, const SlicerPart* volume) {
  const std::size_t all = object.mesh.polygon_count();
  const std::size_t end = volume ? std::min(volume->last, all - 1) + 1 : all;
  const std::size_t first = volume ? std::min(volume->first, end) : 0;
  const auto [known, is_new] =
      known_.try_emplace({path, id, volume ? first + 1 : 0}, soups_.size());
  if (!is_new) return known->second;
  PolygonSoup& soup = soups_.emplace_back(part_of(object.mesh, first, end));
  soup.name = volume && !volume->name.empty() ? volume->name : object.name;
  for (Vec3& p : soup.positions) p *= unit;
  FaceLooks look;
  for (std::size_t t = first; t < end && !object.colors.empty(); ++t) look.add(object.colors[t]);
  many_colors_ += look.too_many();
  looks_.push_back(look.look());
  colors_.push_back(look.colors());
  return known->second;
}

}  // namespace burin
