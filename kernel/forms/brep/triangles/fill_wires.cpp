#include "fill_wires.h"

#include "trim_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t kMostSides = 2000;
/// Lines of (u,v) that a curved face is cut along at the most, each way.
constexpr double kMostLines = 64;
/// A share of the box in (u,v): places nearer than that are one.
constexpr double kSame = 1e-9;

using Side = TrimPolygon::Side;

double u_on(const Side& s, double v) {
  if (v == s.a.y) return s.a.x;
  if (v == s.b.y) return s.b.x;
  return s.a.x + (v - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x);
}

/// A band of one trapezoid between two lines: from the left side to the right one.
struct Trapezoid {
  Vec2 low, high;  // u at the lower and at the upper line, from (x) and to (y)
};

class Filler {
 public:
  Filler(const Chart& chart, const TrimPolygon& wires, double tolerance)
      : chart_(chart), sides_(wires.sides()), box_(wires.box()), tolerance_(tolerance) {}

  LooseTriangles run(std::int32_t face) {
    const Vec2 size = box_.max - box_.min;
    if (!(size.x > 0) || !(size.y > 0)) return {};
    const std::vector<double> grid_u = grid(0);
    lines_ = all_lines();
    std::vector<std::vector<Trapezoid>> bands;
    for (std::size_t k = 0; k + 1 < lines_.size(); ++k) bands.push_back(trapezoids(k));
    // What lies on a line is the same for the bands above and below it.
    std::vector<std::vector<double>> on(lines_.size(), grid_u);
    for (std::size_t k = 0; k < bands.size(); ++k) {
      for (const Trapezoid& t : bands[k]) {
        on[k].insert(on[k].end(), {t.low.x, t.low.y});
        on[k + 1].insert(on[k + 1].end(), {t.high.x, t.high.y});
      }
    }
    for (auto& u : on) merge(u, kSame * size.x);
    for (std::size_t k = 0; k < bands.size(); ++k) {
      for (const Trapezoid& t : bands[k]) {
        zip(between(on[k], t.low), lines_[k], between(on[k + 1], t.high), lines_[k + 1]);
      }
    }
    out_.face.assign(out_.triangles.size(), face);
    return std::move(out_);
  }

 private:
  static void merge(std::vector<double>& v, double apart) {
    std::ranges::sort(v);
    v.erase(std::unique(v.begin(), v.end(), [&](double a, double b) { return b - a <= apart; }),
            v.end());
  }

  /// Lines across a curved face, near enough for chords within the tolerance.
  std::vector<double> grid(int k) const {
    if (chart_.kind() == FaceKind::Plane) return {};
    const Vec2 size = box_.max - box_.min;
    double bend = 0;
    for (int i = 0; i < 25; ++i) {
      const int row = i / 5, column = i % 5;
      const Vec2 uv = box_.min + size * Vec2(0.1 + 0.2 * column, 0.1 + 0.2 * row);
      const SurfaceDerivatives d = chart_.derivatives(uv);
      bend = std::max(bend, glm::length(k == 0 ? d.uu : d.vv));
    }
    const double wanted = size[k] * std::sqrt(bend / (8 * tolerance_));
    const double n = std::isfinite(wanted) ? std::clamp(std::ceil(wanted), 1.0, kMostLines) : 1;
    std::vector<double> at;
    for (int i = 1; i < static_cast<int>(n); ++i) at.push_back(box_.min[k] + size[k] * i / n);
    return at;
  }

  std::vector<double> all_lines() const {
    std::vector<double> v = grid(1);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      v.push_back(sides_[i].a.y);
      v.push_back(sides_[i].b.y);
      for (std::size_t j = 0; j < i; ++j) add_crossing(sides_[i], sides_[j], v);
    }
    merge(v, kSame * (box_.max.y - box_.min.y));
    return v;
  }

  static void add_crossing(const Side& s, const Side& t, std::vector<double>& v) {
    const Vec2 d = s.b - s.a, e = t.b - t.a;
    const double area = cross2(d, e);
    if (area == 0) return;
    const double x = cross2(t.a - s.a, e) / area, y = cross2(t.a - s.a, d) / area;
    if (x > 0 && x < 1 && y > 0 && y < 1) v.push_back(s.a.y + x * d.y);
  }

  std::vector<Trapezoid> trapezoids(std::size_t k) const {
    const double low = lines_[k], high = lines_[k + 1], middle = 0.5 * (low + high);
    std::vector<std::pair<double, const Side*>> over;
    for (const Side& s : sides_) {
      if ((s.a.y <= middle) != (s.b.y <= middle)) over.emplace_back(u_on(s, middle), &s);
    }
    std::ranges::sort(over, {}, [](const auto& o) { return o.first; });
    const auto ends = [&](const Side& s) {
      // Lines that were merged may lie a hair outside the side.
      const auto [from, to] = std::minmax(s.a.y, s.b.y);
      return Vec2(u_on(s, std::clamp(low, from, to)), u_on(s, std::clamp(high, from, to)));
    };
    std::vector<Vec2> at;
    for (const auto& [u, side] : over) at.push_back(ends(*side));
    if (at.size() % 2) add_other_side_of_seam(at);
    std::vector<Trapezoid> out;
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const auto order = [](double a, double b) { return Vec2(std::min(a, b), std::max(a, b)); };
      out.push_back({order(at[i].x, at[i + 1].x), order(at[i].y, at[i + 1].y)});
    }
    return out;
  }

  void add_other_side_of_seam(std::vector<Vec2>& at) const {
    const double period = chart_.period().x;
    if (!(period > 0)) {
      at.pop_back();
    } else if (at.back().x - box_.min.x >= box_.max.x - at.back().x) {
      at.insert(at.begin(), at.back() - Vec2(period));
    } else {
      at.push_back(at.front() + Vec2(period));
    }
  }

  std::vector<double> between(const std::vector<double>& u, Vec2 ends) const {
    const double slack = kSame * (box_.max.x - box_.min.x);
    const auto begin = std::ranges::lower_bound(u, ends.x - slack);
    const auto end = std::ranges::upper_bound(u, ends.y + slack);
    return begin < end ? std::vector<double>(begin, end) : std::vector<double>();
  }

  std::uint32_t point(double u, double v) {
    out_.positions.push_back(chart_.position(Vec2(u, v)));
    return static_cast<std::uint32_t>(out_.positions.size() - 1);
  }

  /// Triangles between the points of two lines, going up on the line that lags behind.
  void zip(const std::vector<double>& low, double v_low, const std::vector<double>& high,
           double v_high) {
    if (low.empty() || high.empty()) return;
    std::vector<std::uint32_t> a, b;
    for (const double u : low) a.push_back(point(u, v_low));
    for (const double u : high) b.push_back(point(u, v_high));
    std::size_t i = 0, j = 0;
    while (i + 1 < a.size() || j + 1 < b.size()) {
      const bool up = j + 1 == b.size() || (i + 1 < a.size() && low[i + 1] <= high[j + 1]);
      if (up) {
        out_.triangles.push_back({a[i], a[i + 1], b[j]});
        ++i;
      } else {
        out_.triangles.push_back({a[i], b[j + 1], b[j]});
        ++j;
      }
    }
  }

  const Chart& chart_;
  const std::vector<Side>& sides_;
  Box2 box_;
  double tolerance_;
  std::vector<double> lines_;
  LooseTriangles out_;
};

}  // namespace

LooseTriangles fill_wires(const ModelParts& parts, std::int32_t face, double tolerance) {
  const ModelFace& f = parts.faces[static_cast<std::size_t>(face)];
  const TrimPolygon wires(parts, face);
  if (!f.chart || wires.empty() || wires.sides().size() > kMostSides) return {};
  return Filler(*f.chart, wires, tolerance).run(face);
}

}  // namespace burin
