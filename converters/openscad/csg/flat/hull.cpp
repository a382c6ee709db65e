#include <burin/planar/convex_hull.h>

#include "clip.h"
#include "origins.h"

#include <utility>
#include <vector>

namespace burin::csg {

Region hull_of(std::span<const Region> regions) {
  Origins origins;
  std::vector<Vec2> points;
  for (const Region& r : regions) {
    origins.add(r);
    for (const Outline& o : r.outlines) {
      points.insert(points.end(), o.points.begin(), o.points.end());
    }
  }
  Outline outline;
  outline.points = convex_hull(std::move(points));
  if (outline.points.size() < 3) return {};
  outline.arc.assign(outline.points.size(), -1);
  Region region;
  region.outlines.push_back(std::move(outline));
  origins.tag(region);
  return region;
}

}  // namespace burin::csg
