#include "measure.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr std::size_t kGrain = 512;  // triangles

/// Squared distances of one triangle.
double worst(const ChartMesh& m, const Atlas& atlas, std::size_t f) {
  const std::int32_t face = m.face[f];
  const Chart& chart = atlas.chart(face);
  const bool flat = chart.kind() == FaceKind::Plane;
  double d2 = 0;
  const auto compare = [&](Vec2 uv, Vec3 p) {
    const Vec3 d = chart.position(uv) - p;
    d2 = std::max(d2, glm::dot(d, d));
  };
  Vec2 uv(0);
  Vec3 p(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t h = 3 * f + k, n = 3 * f + (k + 1) % 3;
    const Vec3 a = m.positions[m.triangles[f][k]], b = m.positions[m.triangles[f][(k + 1) % 3]];
    uv += m.uv[h] / 3.0;
    p += a / 3.0;
    if (m.border[h] >= 0) {
      const auto& border = m.borders[static_cast<std::size_t>(m.border[h])];
      if (border.coedge < 0) continue;
      compare(atlas.on_coedge(border.coedge, 0.5 * (border.t0 + border.t1)), 0.5 * (a + b));
    } else if (!flat && m.triangles[f][k] < m.triangles[f][(k + 1) % 3]) {
      compare(0.5 * (m.uv[h] + m.uv[n]), 0.5 * (a + b));
    }
  }
  if (!flat) compare(uv, p);
  return d2;
}

}  // namespace

double measure_tolerance(const ChartMesh& mesh, const Atlas& atlas, const RunContext& context) {
  const std::size_t n = mesh.triangles.size();
  std::vector<double> range((n + kGrain - 1) / kGrain, 0.0);
  parallel_for(
      n, kGrain,
      [&](std::size_t begin, std::size_t end) {
        double& d2 = range[begin / kGrain];
        for (std::size_t f = begin; f < end; ++f) d2 = std::max(d2, worst(mesh, atlas, f));
      },
      &context);
  return range.empty() ? 0 : std::sqrt(*std::ranges::max_element(range));
}

}  // namespace burin
