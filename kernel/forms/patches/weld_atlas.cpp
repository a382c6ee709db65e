// From the t of an edge to the sides that lie on it.

#include "weld.h"

#include <cmath>

namespace burin::detail {

double PatchAtlas::side_t(std::int32_t coedge, double t) const {
  const SideUse& use = uses_[static_cast<std::size_t>(coedge)];
  if (use.table.empty()) return use.backward ? 1 - t : t;
  if (t <= 0) return use.table.front();
  if (t >= 1) return use.table.back();
  const double x = t * static_cast<double>(use.table.size() - 1);
  const auto i = static_cast<std::size_t>(x);
  const double guess =
      use.table[i] + (x - static_cast<double>(i)) * (use.table[i + 1] - use.table[i]);
  // The table is but a guess: the point of the edge is that of its first side.
  const SideUse& first = uses_[static_cast<std::size_t>(use.master)];
  const Chart& master = chart(first.face);
  const Vec3 p = master.position(side_uv(master.domain(), first.side, t));
  SideCurve curve;
  curve.chart = &chart(use.face);
  curve.box = curve.chart->domain();
  curve.side = use.side;
  return curve.nearest(p, guess);
}

double PatchAtlas::edge_t(std::int32_t coedge, double wanted) const {
  const SideUse& use = uses_[static_cast<std::size_t>(coedge)];
  if (use.table.empty()) return use.backward ? 1 - wanted : wanted;
  double low = 0, high = 1;
  // Halving to the last bit: the map is monotone, nothing else is known of it.
  for (int i = 0; i < 50; ++i) {
    const double t = 0.5 * (low + high), s = side_t(coedge, t);
    const bool before = use.backward ? s > wanted : s < wanted;
    (before ? low : high) = t;
  }
  return 0.5 * (low + high);
}

Vec2 PatchAtlas::on_coedge(std::int32_t coedge, double t) const {
  const SideUse& use = uses_[static_cast<std::size_t>(coedge)];
  return side_uv(chart(use.face).domain(), use.side, side_t(coedge, t));
}

}  // namespace burin::detail
