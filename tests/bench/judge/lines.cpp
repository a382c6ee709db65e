#include "lines.h"

namespace burin::judge {
namespace {

Vec2 vec2(const nlohmann::json& v) { return {v.at(0).get<double>(), v.at(1).get<double>()}; }
Vec3 vec3(const nlohmann::json& v) {
  return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

// A point given on the view plane through the model's origin, in model units.
Vec2 to_paper(Vec2 plane, const Camera& camera) {
  return camera.to_paper(plane.x * camera.right() + plane.y * camera.up());
}

}  // namespace

Camera read_camera(const nlohmann::json& drawing) {
  const auto& view = drawing.at("view");
  const auto& paper = drawing.at("paper");
  ViewOptions options;
  options.direction = vec3(view.at("direction"));
  options.up = vec3(view.at("up"));
  options.scale = view.at("scale").get<double>();
  options.center = vec3(view.at("center"));
  options.paper = {paper.at("width").get<double>(), paper.at("height").get<double>()};
  // The extent shapes nothing where scale and centre are given.
  return Camera::fit([](const Mat3&) { return Box3{Vec3(0), Vec3(1)}; }, options);
}

std::vector<Polyline> drawing_lines(const nlohmann::json& drawing, const std::string& without) {
  std::vector<Polyline> out;
  for (const auto& layer : drawing.at("layers")) {
    for (const auto& path : layer.at("paths")) {
      if (path.at("kind") == "stroke" || path.at("kind") == without ||
          !path.at("visible").get<bool>())
        continue;
      Polyline line;
      for (const auto& p : path.at("points")) line.push_back(vec2(p));
      if (path.at("closed").get<bool>()) line.push_back(line.front());
      out.push_back(std::move(line));
    }
  }
  return out;
}

std::vector<Polyline> plane_lines(const nlohmann::json& lines, const Camera& camera,
                                  const std::string& without) {
  std::vector<Polyline> out;
  for (const auto& l : lines.at("lines")) {
    if (l.at("kind") == without) continue;
    Polyline line;
    for (const auto& p : l.at("points")) line.push_back(to_paper(vec2(p), camera));
    out.push_back(std::move(line));
  }
  return out;
}

std::vector<Sample> sample(const std::vector<Polyline>& lines, double step) {
  std::vector<Sample> out;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    double gone = 0, next = 0.5 * step;
    for (std::size_t i = 0; i + 1 < lines[l].size(); ++i) {
      const Vec2 a = lines[l][i], b = lines[l][i + 1];
      const double length = glm::distance(a, b);
      for (; next < gone + length; next += step) {
        out.push_back({a + (next - gone) / length * (b - a), l, next});
      }
      gone += length;
    }
  }
  return out;
}

}  // namespace burin::judge
