#include "trim_polygon.h"

#include <algorithm>
#include <cmath>

namespace burin {

TrimPolygon::TrimPolygon(const ModelParts& parts, std::int32_t face) {
  const ModelFace& f = parts.faces[static_cast<std::size_t>(face)];
  for (auto c = static_cast<std::size_t>(f.first_coedge);
       c < parts.coedges.size() && parts.coedges[c].face == face; ++c) {
    const ModelCoedge& co = parts.coedges[c];
    if (!co.curve.known() || co.internal) continue;
    const ModelEdge& e = parts.edges[static_cast<std::size_t>(co.edge)];
    const int steps = co.curve.straight() ? 1 : 16;
    Vec2 last = co.curve.at(e.first);
    for (int i = 1; i <= steps; ++i) {
      const Vec2 next = co.curve.at(e.first + (e.last - e.first) * i / steps);
      sides_.push_back({last, next});
      box_.add(last);
      box_.add(next);
      last = next;
    }
  }
}

std::vector<double> TrimPolygon::crossings(double v) const {
  std::vector<double> u;
  for (const Side& s : sides_) {
    if ((s.a.y <= v) == (s.b.y <= v)) continue;
    u.push_back(s.a.x + (v - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x));
  }
  std::ranges::sort(u);
  if (u.size() % 2) u.pop_back();  // wires that do not close
  return u;
}

}  // namespace burin
