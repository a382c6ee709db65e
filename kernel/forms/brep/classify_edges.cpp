#include <burin/base/parallel.h>
#include <burin/forms/charted/continuity.h>

#include "contain.h"
#include "model_parts.h"

#include <array>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

/// Degrees between the normals of two faces up to which their edge is smooth: files come with
/// tangencies off by some tenths.
constexpr double kSmoothAngle = 1.0;
constexpr int kSamples = 9;

Vec3 normal_at(const ModelParts& parts, const ModelCoedge& c, double t) {
  const ModelFace& face = parts.faces[static_cast<std::size_t>(c.face)];
  const Vec2 uv = c.curve.at(t);
  return chart_normal(face.chart->derivatives(uv), face.reversed, uv,
                      face.chart->domain().center());
}

bool smooth_at(const ModelParts& parts, const ModelCoedge& a, const ModelCoedge& b, double t) {
  static const double cosine = std::cos(kSmoothAngle * std::numbers::pi / 180);
  const Vec3 m = normal_at(parts, a, t), n = normal_at(parts, b, t);
  // Places without a normal (tips) say nothing.
  return m == Vec3(0) || n == Vec3(0) || glm::dot(m, n) >= cosine;
}

bool known(const ModelParts& parts, const ModelCoedge& c) {
  return c.curve.known() && parts.faces[static_cast<std::size_t>(c.face)].chart;
}

bool is_smooth(const ModelParts& parts, const ModelEdge& e, const ModelCoedge& a,
               const ModelCoedge& b) {
  if (!known(parts, a) || !known(parts, b)) return false;
  // Sharp edges mostly are so in the middle: one look.
  for (int i = 0; i < kSamples; ++i) {
    const int k = (i + kSamples / 2) % kSamples;
    const double s = (k + 0.5) / kSamples;
    if (!smooth_at(parts, a, b, e.first + s * (e.last - e.first))) return false;
  }
  return smooth_at(parts, a, b, e.first) && smooth_at(parts, a, b, e.last);
}

/// Whether a smooth edge only divides one surface: curvature goes on over it all along.
bool divides(const ModelParts& parts, const ModelEdge& e, const ModelCoedge& a,
             const ModelCoedge& b) {
  struct Side {
    SurfaceDerivatives d;
    Vec3 normal;
  };
  const auto side = [&](const ModelCoedge& c, double t) {
    const ModelFace& face = parts.faces[static_cast<std::size_t>(c.face)];
    const Vec2 uv = c.curve.at(t);
    const SurfaceDerivatives d = face.chart->derivatives(uv);
    return Side{d, chart_normal(d, face.reversed, uv, face.chart->domain().center())};
  };
  std::array<Side, kSamples> left, right;
  double length = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double t = e.first + (static_cast<double>(i) + 0.5) / kSamples * (e.last - e.first);
    left[i] = side(a, t);
    right[i] = side(b, t);
    if (i > 0) length += glm::distance(left[i - 1].d.p, left[i].d.p);
  }
  if (!(length > 0)) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!bends_alike(left[i].d, left[i].normal, right[i].d, right[i].normal, length)) return false;
  }
  return true;
}

ModelEdgeClass class_of(const ModelParts& parts, const ModelEdge& e) {
  if (e.coedges.size() == 1) {
    const ModelCoedge& c = parts.coedges[static_cast<std::size_t>(e.coedges[0])];
    return c.internal ? ModelEdgeClass::Seam : ModelEdgeClass::Boundary;
  }
  if (e.coedges.size() != 2)
    return e.coedges.empty() ? ModelEdgeClass::Boundary : ModelEdgeClass::Sharp;
  const ModelCoedge& a = parts.coedges[static_cast<std::size_t>(e.coedges[0])];
  const ModelCoedge& b = parts.coedges[static_cast<std::size_t>(e.coedges[1])];
  if (!is_smooth(parts, e, a, b)) return ModelEdgeClass::Sharp;
  const bool one = a.face == b.face || divides(parts, e, a, b);
  return one ? ModelEdgeClass::Seam : ModelEdgeClass::Smooth;
}

}  // namespace

std::vector<ModelEdgeClass> classify_edges(const ModelParts& parts) {
  std::vector<ModelEdgeClass> out(parts.edges.size(), ModelEdgeClass::Boundary);
  parallel_for(out.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      out[i] = ModelEdgeClass::Sharp;  // where a face has no normals, nothing goes on over the edge
      survived([&] { out[i] = class_of(parts, parts.edges[i]); });
    }
  });
  return out;
}

}  // namespace burin
