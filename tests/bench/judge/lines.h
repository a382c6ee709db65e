#pragma once
/// Lines on paper from a drawing file or from another program, and which points of them have a
/// partner.

#include <burin/base/vec.h>

#include <nlohmann/json.hpp>

#include <string>
#include <unordered_map>
#include <vector>

namespace burin::judge {

using Polyline = std::vector<Vec2>;

/// The map between model and paper of an orthographic drawing file.
struct View {
  Vec3 direction{0}, right{0}, up{0}, center{0};
  Vec2 offset{0};
  double scale = 1;

  /// Of a point given on the view plane through the model's origin, in model units.
  Vec2 to_paper(Vec2 plane) const {
    return scale * (plane - Vec2(glm::dot(center, right), glm::dot(center, up))) + offset;
  }
  /// The model point over a place of the paper, in the plane through `center`.
  Vec3 over(Vec2 paper) const {
    const Vec2 d = (paper - offset) / scale;
    return center + d.x * right + d.y * up;
  }
};

View read_view(const nlohmann::json& drawing);
/// The visible paths of a drawing file that are neither strokes nor of the kind `without`.
std::vector<Polyline> drawing_lines(const nlohmann::json& drawing, const std::string& without);
/// The lines that another program printed, of all kinds but `without`.
std::vector<Polyline> plane_lines(const nlohmann::json& lines, const View& view,
                                  const std::string& without);

/// Places every `step` mm along a line; where it is in the line, in mm.
struct Sample {
  Vec2 paper{0};
  std::size_t line = 0;
  double at = 0;
};
std::vector<Sample> sample(const std::vector<Polyline>& lines, double step);

/// Segments in a grid of cells of the size of `reach`: whether one of them passes within `reach`.
class NearLines {
 public:
  NearLines(const std::vector<Polyline>& lines, double reach);
  bool near(Vec2 p) const;

 private:
  struct Segment {
    Vec2 a, b;
  };
  static std::int64_t key(std::int64_t x, std::int64_t y) { return x * 1'000'003 + y; }
  double reach_;
  std::vector<Segment> segments_;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace burin::judge
