#pragma once
/// The meshes that a 3MF builds, each once.

#include "look.h"
#include "model.h"
#include "slicer.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace burin {

class ThreeMfShapes {
 public:
  /// The number of an object of the model part `path`, whose unit is `unit` mm, or of a volume of
  /// it (null: all of it), in the order in which they are first asked for.
  std::size_t add(const std::string& path, const std::string& id, const ThreeMfObject& object,
                  double unit, const SlicerPart* volume);

  const Appearance& look(std::size_t shape) const { return looks_[shape]; }
  std::size_t triangles(std::size_t shape) const { return soups_[shape].polygon_count(); }
  bool empty() const { return soups_.empty(); }
  /// How many have faces of too many colours.
  std::int64_t many_colors() const { return many_colors_; }
  /// As those of MeshFile.
  std::vector<std::shared_ptr<const FaceColors>> take_colors() { return std::move(colors_); }
  std::vector<PolygonSoup> take() { return std::move(soups_); }

 private:
  std::map<std::tuple<std::string, std::string, std::size_t>, std::size_t> known_;
  std::vector<PolygonSoup> soups_;
  std::vector<Appearance> looks_;
  std::vector<std::shared_ptr<const FaceColors>> colors_;
  std::int64_t many_colors_ = 0;
};

}  // namespace burin
