#pragma once
/// Where Python's fields and tones are asked: at a lattice of points of the picture, all at once.

#include <burin/illustrate/illustrate.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace burin::python {

/// What is seen at the centres of square cells of the sheet: half a mm wide, wider on sheets of
/// more than a million such cells; and, where a surface shows between such centres only, at places
/// of its triangles. The scene must outlive it.
class PictureSamples {
 public:
  explicit PictureSamples(const HatchScene& scene);

  const Camera& camera() const { return *camera_; }
  /// Model mm and unit normals turned to the viewer, one per cell that shows a surface, then those
  /// of slivers.
  const std::vector<Vec3>& positions() const { return positions_; }
  const std::vector<Vec3>& normals() const { return normals_; }

  /// Samples of the same stretch of surface, with weights that add up to 1 (bilinear on paper), the
  /// heaviest first; none where no cell shows the place or one beside it.
  struct Near {
    std::array<std::uint32_t, 4> sample{};
    std::array<double, 4> weight{};
    int count = 0;
  };
  Near near(Vec3 position, Vec3 normal) const;

  /// Whether the viewer sees a place, as far as a cell's width tells: nothing stands before it.
  bool seen(Vec3 position) const;

 private:
  void add_slivers();
  void add_sliver(std::int32_t part, std::uint32_t face, Vec3 bary);
  /// The nearest sample of a sliver.
  Near near_sliver(Vec3 position, Vec3 normal, Vec2 place, double reach) const;
  bool same_surface(std::int32_t sample, Vec3 position, Vec3 normal, double reach) const;
  std::int32_t at(std::int64_t x, std::int64_t y) const;

  const HatchScene* scene_;
  const Camera* camera_;
  double pitch_ = 0.5;
  std::int64_t nx_ = 0, ny_ = 0;
  /// For each cell its sample, -1 where it shows nothing.
  std::vector<std::int32_t> cells_;
  std::vector<Vec3> positions_, normals_;
  /// By cell, the samples of slivers in it.
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> slivers_;
};

}  // namespace burin::python
