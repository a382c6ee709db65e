#include <burin/verify/verify.h>

#include "feature_lines.h"

#include <cmath>

namespace burin {
namespace {

// Paper mm along a path from which on its own course is another line to its end.
constexpr double kAway = 1;

struct Line {
  const Path* path;
  std::vector<double> at;  // a point: mm from the start
};

bool on_sheet(const Drawing& drawing, Vec2 p, double border) {
  return p.x > border && p.y > border && p.x < drawing.paper_width - border &&
         p.y < drawing.paper_height - border;
}

}  // namespace

std::vector<LooseEnd> loose_ends(const Drawing& drawing, double reach) {
  std::vector<Polyline> polylines;
  std::vector<Line> lines;
  std::vector<std::size_t> outline;
  each_feature_line(drawing, [&](const Layer& layer, const Path& path, Polyline&& p) {
    if (layer.name == "outline" && !path.closed) outline.push_back(lines.size());
    lines.push_back({&path, {0}});
    for (std::size_t i = 1; i < p.size(); ++i) {
      lines.back().at.push_back(lines.back().at.back() + glm::distance(p[i - 1], p[i]));
    }
    polylines.push_back(std::move(p));
  });
  const NearLines grid(polylines, reach);
  std::vector<LooseEnd> out;
  for (const std::size_t own : outline) {
    const Line& line = lines[own];
    for (const bool last : {false, true}) {
      const Vec2 end = last ? line.path->points.back() : line.path->points.front();
      if (!on_sheet(drawing, end, reach)) continue;
      const double from = last ? line.at.back() : 0;
      const bool goes_on = grid.near(end, [&](std::size_t other, std::size_t segment) {
        if (other != own) return true;
        const double near = last ? line.at[segment + 1] : line.at[segment];
        return std::abs(from - near) >= kAway;
      });
      if (goes_on) continue;
      const std::vector<Vec3>& p3 = line.path->points3;
      out.push_back({line.path->source, end, p3.empty() ? Vec3(0) : last ? p3.back() : p3.front()});
    }
  }
  return out;
}

}  // namespace burin
