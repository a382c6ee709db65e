#include "lines.h"

#include <algorithm>
#include <cmath>

namespace burin::judge {
namespace {

Vec2 vec2(const nlohmann::json& v) { return {v.at(0).get<double>(), v.at(1).get<double>()}; }
Vec3 vec3(const nlohmann::json& v) {
  return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 e = b - a;
  const double l2 = glm::dot(e, e);
  const double t = l2 > 0 ? std::clamp(glm::dot(p - a, e) / l2, 0.0, 1.0) : 0;
  return glm::distance(p, a + t * e);
}

}  // namespace

View read_view(const nlohmann::json& drawing) {
  const auto& v = drawing.at("view");
  View view;
  view.direction = vec3(v.at("direction"));
  view.right = vec3(v.at("right"));
  view.up = vec3(v.at("up"));
  view.center = vec3(v.at("center"));
  view.offset = vec2(v.at("offset"));
  view.scale = v.at("scale").get<double>();
  return view;
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

std::vector<Polyline> plane_lines(const nlohmann::json& lines, const View& view,
                                  const std::string& without) {
  std::vector<Polyline> out;
  for (const auto& l : lines.at("lines")) {
    if (l.at("kind") == without) continue;
    Polyline line;
    for (const auto& p : l.at("points")) line.push_back(view.to_paper(vec2(p)));
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

NearLines::NearLines(const std::vector<Polyline>& lines, double reach) : reach_(reach) {
  for (const Polyline& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 a = line[i], b = line[i + 1];
      const auto index = static_cast<std::uint32_t>(segments_.size());
      segments_.push_back({a, b});
      // Cells along the segment, one every cell's size: the query looks at the eight around.
      const auto steps = static_cast<std::int64_t>(glm::distance(a, b) / reach) + 1;
      std::int64_t last = INT64_MIN;
      for (std::int64_t s = 0; s <= steps; ++s) {
        const Vec2 p = a + static_cast<double>(s) / static_cast<double>(steps) * (b - a);
        const std::int64_t k = key(std::llround(p.x / reach), std::llround(p.y / reach));
        if (k != last) cells_[k].push_back(index);
        last = k;
      }
    }
  }
}

bool NearLines::near(Vec2 p) const {
  const std::int64_t x = std::llround(p.x / reach_), y = std::llround(p.y / reach_);
  for (std::int64_t dx = -2; dx <= 2; ++dx) {
    for (std::int64_t dy = -2; dy <= 2; ++dy) {
      const auto cell = cells_.find(key(x + dx, y + dy));
      if (cell == cells_.end()) continue;
      for (const std::uint32_t i : cell->second) {
        if (distance(p, segments_[i].a, segments_[i].b) <= reach_) return true;
      }
    }
  }
  return false;
}

}  // namespace burin::judge
