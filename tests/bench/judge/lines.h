#pragma once
/// Lines on paper from a drawing file or from another program.

#include <burin/camera/camera.h>
#include <burin/planar/near_lines.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin::judge {

/// The view of an orthographic drawing file.
Camera read_camera(const nlohmann::json& drawing);
/// The visible paths of a drawing file that are neither strokes nor of the kind `without`.
std::vector<Polyline> drawing_lines(const nlohmann::json& drawing, const std::string& without);
/// The lines that another program printed, of all kinds but `without`.
std::vector<Polyline> plane_lines(const nlohmann::json& lines, const Camera& camera,
                                  const std::string& without);

/// Places every `step` mm along a line; where it is in the line, in mm.
struct Sample {
  Vec2 paper{0};
  std::size_t line = 0;
  double at = 0;
};
std::vector<Sample> sample(const std::vector<Polyline>& lines, double step);

}  // namespace burin::judge
