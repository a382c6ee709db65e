#include <burin/verify/verify.h>

#include "feature_lines.h"

#include <cmath>

namespace burin {
namespace {

// Paper mm along a path from which on its own course is another line to its end.
constexpr double kAway = 1;

bool on_sheet(const Drawing& drawing, Vec2 p, double border) {
  return p.x > border && p.y > border && p.x < drawing.paper_width - border &&
         p.y < drawing.paper_height - border;
}

}  // namespace

std::vector<LooseEnd> loose_ends(const Drawing& drawing, double reach) {
  std::vector<Polyline> polylines;
  std::vector<const Path*> paths;
  std::vector<std::size_t> outline;
  each_feature_line(drawing, [&](const Layer& layer, const Path& path, Polyline&& p) {
    if (layer.name == "outline" && !path.closed) outline.push_back(paths.size());
    paths.push_back(&path);
    polylines.push_back(std::move(p));
  });
  const NearLines grid(polylines, reach);
  std::vector<LooseEnd> out;
  for (const auto& [line, last] : free_ends(polylines, grid, outline, kAway)) {
    const Vec2 end = last ? paths[line]->points.back() : paths[line]->points.front();
    if (!on_sheet(drawing, end, reach)) continue;
    const std::vector<Vec3>& p3 = paths[line]->points3;
    out.push_back({paths[line]->source, end, p3.empty() ? Vec3(0) : last ? p3.back() : p3.front()});
  }
  return out;
}

}  // namespace burin
