#include <burin/base/box.h>
#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>

#include "nurbs_spans.h"

#include <fmt/format.h>

#include <array>

namespace burin {
namespace {

/// What all NURBS charts share; the derived ones differ in how they keep a span.
class NurbsChart : public Chart {
 public:
  NurbsChart(NurbsData data, const NurbsSpans& spans, FaceKind kind)
      : data_(std::move(data)), u_(spans.u), v_(spans.v), origin_(spans.origin), kind_(kind) {}

  ParameterBox domain() const override { return {{u_.min(), v_.min()}, {u_.max(), v_.max()}}; }
  Vec2 period() const override { return {u_.period(), v_.period()}; }
  FaceKind kind() const override { return kind_; }
  std::vector<double> breaks(int direction, int order) const override {
    return (direction == 0 ? u_ : v_).breaks(order);
  }
  const NurbsData& data() const { return data_; }

 protected:
  NurbsData data_;
  KnotSpans u_, v_;
  Vec3 origin_;
  FaceKind kind_;
};

/// S and its partials in homogeneous coordinates to those in space.
SurfaceDerivatives project(Vec3 origin, const Vec4 (&a)[6]) {
  const auto [p, u, v, uu, uv, vv] = a;
  const double f = 1 / p.w;
  SurfaceDerivatives d;
  d.p = Vec3(p) * f;
  d.u = (Vec3(u) - u.w * d.p) * f;
  d.v = (Vec3(v) - v.w * d.p) * f;
  d.uu = (Vec3(uu) - 2 * u.w * d.u - uu.w * d.p) * f;
  d.uv = (Vec3(uv) - u.w * d.v - v.w * d.u - uv.w * d.p) * f;
  d.vv = (Vec3(vv) - 2 * v.w * d.v - vv.w * d.p) * f;
  d.p += origin;
  return d;
}

/// Degrees up to 3: each span as a bicubic polynomial of the offsets in it, lower degrees padded
/// with zeros, so that one short loop of known length serves them all.
template <int Dim>
class CubicChart final : public NurbsChart {
 public:
  CubicChart(NurbsData data, const NurbsSpans& spans, FaceKind kind)
      : NurbsChart(std::move(data), spans, kind), patches_(u_.size() * v_.size()) {
    for (std::size_t su = 0; su < u_.size(); ++su) {
      for (std::size_t sv = 0; sv < v_.size(); ++sv) {
        const std::size_t s = su * v_.size() + sv;
        fill(patches_[s], spans, spans.patch(s), u_.width(su), v_.width(sv));
      }
    }
  }

  Vec3 position(Vec2 uv) const override {
    const KnotSpans::Place pu = u_.find(uv.x), pv = v_.find(uv.y);
    const Patch& c = patches_[pu.span * v_.size() + pv.span];
    const double t = pu.offset, s = pv.offset;
    double a[kRow];
    for (int k = 0; k < kRow; ++k) a[k] = ((c[3][k] * t + c[2][k]) * t + c[1][k]) * t + c[0][k];
    double p[Dim];
    for (int k = 0; k < Dim; ++k) {
      p[k] = ((a[3 * Dim + k] * s + a[2 * Dim + k]) * s + a[Dim + k]) * s + a[k];
    }
    const Vec3 q(p[0], p[1], p[2]);
    return origin_ + (Dim == 4 ? q / p[Dim - 1] : q);
  }

  SurfaceDerivatives derivatives(Vec2 uv) const override {
    const KnotSpans::Place pu = u_.find(uv.x), pv = v_.find(uv.y);
    const Patch& c = patches_[pu.span * v_.size() + pv.span];
    const double t = pu.offset, s = pv.offset;
    // a, b, e: S, Su, Suu as cubics of s.
    double a[kRow], b[kRow], e[kRow];
    for (int k = 0; k < kRow; ++k) {
      const double c3 = c[3][k], c2 = c[2][k], c1 = c[1][k];
      const double h = c3 * t + c2, g = h * t + c1;  // Horner's scheme, and its own derivatives
      const double h1 = c3 * t + h;
      a[k] = g * t + c[0][k];
      b[k] = h1 * t + g;
      e[k] = 2 * (c3 * t + h1);
    }
    Vec4 r[6];
    for (int k = 0; k < Dim; ++k) {
      const double h = a[3 * Dim + k] * s + a[2 * Dim + k], g = h * s + a[Dim + k];
      const double h1 = a[3 * Dim + k] * s + h;
      r[0][k] = g * s + a[k];
      r[2][k] = h1 * s + g;
      r[5][k] = 2 * (a[3 * Dim + k] * s + h1);
      const double bh = b[3 * Dim + k] * s + b[2 * Dim + k], bg = bh * s + b[Dim + k];
      r[1][k] = bg * s + b[k];
      r[4][k] = (b[3 * Dim + k] * s + bh) * s + bg;
      r[3][k] = ((e[3 * Dim + k] * s + e[2 * Dim + k]) * s + e[Dim + k]) * s + e[k];
    }
    if constexpr (Dim == 4) return project(origin_, r);
    return {origin_ + Vec3(r[0]), Vec3(r[1]), Vec3(r[2]), Vec3(r[3]), Vec3(r[4]), Vec3(r[5])};
  }

 private:
  static constexpr int kRow = 4 * Dim;
  // [power of t][power of s * Dim + component]
  using Patch = std::array<std::array<double, kRow>, 4>;

  /// Bernstein coefficients to powers of the offset in a span of the given width, in place.
  static void to_powers(std::array<Vec4, 4>& c, int degree, double width) {
    static constexpr double kBinomial[4][4] = {
        {1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    for (int r = 1; r <= degree; ++r) {
      for (int i = degree; i >= r; --i) {
        c[static_cast<std::size_t>(i)] -= c[static_cast<std::size_t>(i - 1)];
      }
    }
    double scale = 1;
    for (int i = 0; i <= degree; ++i, scale /= width) {
      c[static_cast<std::size_t>(i)] *= kBinomial[degree][i] * scale;
    }
  }

  static void fill(Patch& patch, const NurbsSpans& spans, std::span<const Vec4> bezier,
                   double width_u, double width_v) {
    const auto ou = static_cast<std::size_t>(spans.degree_u) + 1;
    const auto ov = static_cast<std::size_t>(spans.degree_v) + 1;
    std::array<std::array<Vec4, 4>, 4> powers{};  // [v][u]
    for (std::size_t i = 0; i < ou; ++i) {
      std::array<Vec4, 4> row{};
      for (std::size_t j = 0; j < ov; ++j) row[j] = bezier[i * ov + j];
      to_powers(row, spans.degree_v, width_v);
      for (std::size_t j = 0; j < ov; ++j) powers[j][i] = row[j];
    }
    for (std::size_t j = 0; j < 4; ++j) {
      if (j < ov) to_powers(powers[j], spans.degree_u, width_u);
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < Dim; ++k) {
          patch[i][j * Dim + k] = powers[j][i][static_cast<glm::length_t>(k)];
        }
      }
    }
  }

  std::vector<Patch> patches_;
};

/// Bernstein polynomials of one degree at t in [0, 1], with their derivatives by the parameter.
struct BernsteinBasis {
  static constexpr std::size_t kMax = 61;
  double b[kMax], b1[kMax], b2[kMax];

  BernsteinBasis(int degree, double t, double width) {
    int n = std::max(degree - 2, 0);
    values(n, t, b);
    const double f2 = degree * (degree - 1) / (width * width), f1 = degree / width;
    if (degree < 2) b2[0] = b2[1] = 0;
    if (degree >= 2) {
      for (int i = 0; i <= degree; ++i) b2[i] = f2 * (at(n, i - 2) - 2 * at(n, i - 1) + at(n, i));
      raise(b, n++, t);
    }
    for (int i = 0; i <= degree; ++i) b1[i] = f1 * (at(n, i - 1) - at(n, i));
    raise(b, n, t);
  }

  static void values(int degree, double t, double* b) {
    b[0] = 1;
    for (int n = 0; n < degree; ++n) raise(b, n, t);
  }

 private:
  double at(int n, int i) const { return i < 0 || i > n ? 0 : b[i]; }
  static void raise(double* b, int n, double t) {
    b[n + 1] = t * b[n];
    for (int i = n; i > 0; --i) b[i] = (1 - t) * b[i] + t * b[i - 1];
    b[0] *= 1 - t;
  }
};

/// Any degree: each span as Bezier points, which stay exact where powers would cancel.
class BezierChart final : public NurbsChart {
 public:
  BezierChart(NurbsData data, NurbsSpans spans, FaceKind kind)
      : NurbsChart(std::move(data), spans, kind), spans_(std::move(spans)) {}

  Vec3 position(Vec2 uv) const override {
    const KnotSpans::Place pu = u_.find(uv.x), pv = v_.find(uv.y);
    double bu[BernsteinBasis::kMax], bv[BernsteinBasis::kMax];
    BernsteinBasis::values(spans_.degree_u, pu.offset / u_.width(pu.span), bu);
    BernsteinBasis::values(spans_.degree_v, pv.offset / v_.width(pv.span), bv);
    const Vec4* c = spans_.patch(pu.span * v_.size() + pv.span).data();
    Vec4 r(0);
    for (int i = 0; i <= spans_.degree_u; ++i) {
      Vec4 s(0);
      for (int j = 0; j <= spans_.degree_v; ++j, ++c) s += bv[j] * *c;
      r += bu[i] * s;
    }
    return origin_ + Vec3(r) / (spans_.rational ? r.w : 1);
  }

  SurfaceDerivatives derivatives(Vec2 uv) const override {
    const KnotSpans::Place pu = u_.find(uv.x), pv = v_.find(uv.y);
    const double wu = u_.width(pu.span), wv = v_.width(pv.span);
    const BernsteinBasis bu(spans_.degree_u, pu.offset / wu, wu);
    const BernsteinBasis bv(spans_.degree_v, pv.offset / wv, wv);
    const Vec4* c = spans_.patch(pu.span * v_.size() + pv.span).data();
    Vec4 r[6] = {};
    for (int i = 0; i <= spans_.degree_u; ++i) {
      Vec4 s(0), s1(0), s2(0);
      for (int j = 0; j <= spans_.degree_v; ++j, ++c) {
        s += bv.b[j] * *c;
        s1 += bv.b1[j] * *c;
        s2 += bv.b2[j] * *c;
      }
      r[0] += bu.b[i] * s;
      r[1] += bu.b1[i] * s;
      r[2] += bu.b[i] * s1;
      r[3] += bu.b2[i] * s;
      r[4] += bu.b1[i] * s1;
      r[5] += bu.b[i] * s2;
    }
    if (spans_.rational) return project(origin_, r);
    return {origin_ + Vec3(r[0]), Vec3(r[1]), Vec3(r[2]), Vec3(r[3]), Vec3(r[4]), Vec3(r[5])};
  }

 private:
  NurbsSpans spans_;
};

std::shared_ptr<const NurbsChart> make_chart(NurbsData data, FaceKind kind) {
  NurbsSpans spans(data);
  if (std::max(data.degree_u, data.degree_v) > 3) {
    return std::make_shared<BezierChart>(std::move(data), std::move(spans), kind);
  }
  if (spans.rational) return std::make_shared<CubicChart<4>>(std::move(data), spans, kind);
  return std::make_shared<CubicChart<3>>(std::move(data), spans, kind);
}

/// Largest distance between the two sides across one direction, at places along the other.
double gap_between_sides(const Chart& chart, int across) {
  constexpr int kPlaces = 64;
  const ParameterBox box = chart.domain();
  double gap = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    Vec2 a = box.min + (static_cast<double>(i) / kPlaces) * box.size(), b = a;
    a[across] = box.min[across];
    b[across] = box.max[across];
    gap = std::max(gap, glm::distance(chart.position(a), chart.position(b)));
  }
  return gap;
}

void check_periods(const NurbsChart& chart) {
  Box3 box;
  for (const Vec3& p : chart.data().points) box.add(p);
  for (int direction = 0; direction < 2; ++direction) {
    if (chart.period()[direction] == 0) continue;
    // A millionth of the size: the precision to which CAD systems close what they call periodic.
    if (gap_between_sides(chart, direction) > 1e-6 * box.diagonal()) {
      throw GeometryError(
          fmt::format("the surface is given as periodic in {}, but does not close there",
                      direction == 0 ? "u" : "v"));
    }
  }
}

}  // namespace

std::shared_ptr<const Chart> make_nurbs_chart(NurbsData data, FaceKind kind) {
  check_nurbs(data);
  std::shared_ptr<const NurbsChart> chart = make_chart(std::move(data), kind);
  check_periods(*chart);
  return chart;
}

const NurbsData* nurbs_data(const Chart& chart) {
  const auto* nurbs = dynamic_cast<const NurbsChart*>(&chart);
  return nurbs ? &nurbs->data() : nullptr;
}

NurbsData bezier_patch(int degree_u, int degree_v, std::vector<Vec3> points,
                       std::vector<double> weights) {
  const auto knots = [](int degree) {
    std::vector<double> k(2 * static_cast<std::size_t>(std::max(degree, 0) + 1), 0.0);
    std::fill(k.begin() + static_cast<std::ptrdiff_t>(k.size() / 2), k.end(), 1.0);
    return k;
  };
  NurbsData data;
  data.degree_u = degree_u;
  data.degree_v = degree_v;
  data.knots_u = knots(degree_u);
  data.knots_v = knots(degree_v);
  data.count_u = degree_u + 1;
  data.count_v = degree_v + 1;
  data.points = std::move(points);
  data.weights = std::move(weights);
  return data;
}

}  // namespace burin
