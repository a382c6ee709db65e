#include <burin/visibility/visible_spans.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

bool same_ink(const Span& a, const Span& b) { return a.visible == b.visible && a.outer == b.outer; }

struct CurvePlace {
  std::size_t segment;
  double t;
};

CurvePlace place_on_curve(const Curve3& curve, double parameter, bool last) {
  const std::size_t n = curve.segment_count();
  const auto count = static_cast<double>(n);
  if (curve.closed) parameter -= std::floor(parameter / count) * count;
  parameter = std::clamp(parameter, 0.0, count);
  // The end of a span that lies on a point belongs to the segment before it.
  auto i = static_cast<std::size_t>(last ? std::max(0.0, std::ceil(parameter) - 1) : parameter);
  i = std::min(i, n - 1);
  return {i, std::min(1.0, parameter - static_cast<double>(i))};
}

class Slicer {
 public:
  explicit Slicer(const Curve3& curve) : curve_(curve) {
    out_.kind = curve.kind;
    out_.source = curve.source;
    out_.occluding = curve.occluding;
    out_.crease_sign = curve.crease_sign;
    out_.family = curve.family;
    out_.stroke_kind = curve.stroke_kind;
  }

  void point(std::size_t segment, double t) {
    const std::size_t i = segment, j = curve_.next(segment);
    // Whole points stay as they are, bit by bit.
    const auto mixed = [&](const auto& v) {
      return t == 0 ? v[i] : t == 1 ? v[j] : glm::mix(v[i], v[j], t);
    };
    out_.points.push_back(mixed(curve_.points));
    if (!curve_.normals.empty()) {
      out_.normals.push_back(t == 0 || t == 1
                                 ? mixed(curve_.normals)
                                 : normalize_or(mixed(curve_.normals), curve_.normals[i]));
    }
    if (!curve_.widths.empty()) out_.widths.push_back(mixed(curve_.widths));
  }
  void segment(std::size_t i) {
    if (!curve_.faces.empty()) out_.faces.push_back(curve_.faces[i]);
    if (!curve_.self_hidden.empty()) out_.self_hidden.push_back(curve_.self_hidden[i]);
  }
  Curve3 take() { return std::move(out_); }

 private:
  const Curve3& curve_;
  Curve3 out_;
};

}  // namespace

Curve3 slice(const Curve3& curve, double begin, double end) {
  const auto n = static_cast<double>(curve.segment_count());
  if (curve.closed && end - begin >= n) {  // a whole turn stays closed
    Curve3 whole = curve;
    const auto turn = static_cast<std::ptrdiff_t>(begin - std::floor(begin / n) * n);
    const auto rotate = [&](auto& v) {
      if (!v.empty()) std::rotate(v.begin(), v.begin() + turn, v.end());
    };
    rotate(whole.points);
    rotate(whole.normals);
    rotate(whole.faces);
    rotate(whole.self_hidden);
    rotate(whole.widths);
    return whole;
  }
  end = std::max(end, begin);
  const CurvePlace from = place_on_curve(curve, begin, false),
                   to = place_on_curve(curve, end, true);
  Slicer slicer(curve);
  slicer.point(from.segment, from.t);
  std::size_t i = from.segment;
  slicer.segment(i);
  // Points strictly between the ends.
  const auto inner =
      static_cast<std::size_t>(std::max(0.0, std::ceil(end) - 1 - std::floor(begin)));
  for (std::size_t k = 0; k < inner; ++k) {
    slicer.point(i, 1);
    i = i + 1 == curve.segment_count() ? 0 : i + 1;
    slicer.segment(i);
  }
  slicer.point(i, i == to.segment ? to.t : 1);
  return slicer.take();
}

std::vector<Span> merged(const std::vector<Span>& spans, bool closed, double count) {
  std::vector<Span> out;
  for (const Span& s : spans) {
    if (!out.empty() && same_ink(out.back(), s)) {
      out.back().end = s.end;
    } else {
      out.push_back(s);
    }
  }
  if (closed && out.size() > 1 && same_ink(out.front(), out.back())) {
    out.back().end = count + out.front().end;
    out.erase(out.begin());
  }
  return out;
}

}  // namespace burin
