#include "haloes.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Cosine between normal and view down to which a stroke's surface has a slope: strokes end there.
constexpr double kMostSlanted = 0.02;

// Paper mm of white beside the lines of exploded views where a style has no haloes: over strokes
// they would be lost.
constexpr double kTrailGap = 0.3;

bool casts(const Style& style, const Curve3& curve) {
  if (curve.kind == LineClass::Trail) return true;
  if (style.halo.gap <= 0) return false;
  if (curve.kind == LineClass::Stroke || curve.kind == LineClass::Isophote)
    return style.halo.lines == HaloStyle::Lines::All;
  return style.halo.lines != HaloStyle::Lines::Occluding || curve.occluding ||
         curve.kind == LineClass::Boundary;
}

HaloLine picture(const Curve3& curve, const Composition& how) {
  const Camera& camera = how.camera;
  HaloLine line;
  line.closed = curve.closed;
  for (const Vec3& p : curve.points) {
    line.points.push_back(camera.to_paper(p));
    line.depths.push_back(camera.depth(p));
    if (camera.perspective()) {
      line.ranges.push_back(glm::dot(camera.eye() - p, camera.direction()));
    }
  }
  if (how.cue.active()) line.scale = how.cue.widths(curve.points);
  return line;
}

HaloLine feature_line(const Curve3& curve, const std::vector<Span>& spans, const Composition& how) {
  HaloLine line = picture(curve, how);
  double widest = 0;
  for (const Span& span : spans) {
    if (!span.visible && !how.shows_hidden()) continue;
    const double half = 0.5 * how.feature_width(curve, span);
    widest = std::max(widest, half);
    // Dashes are no line that something could pass behind.
    if (casts(how.style, curve) && (span.visible || how.style.halo.hidden)) {
      line.casters.push_back({span.begin, span.end, half});
    }
  }
  line.overhang = widest;  // round caps
  return line;
}

HaloLine stroke_line(const Curve3& curve, const std::vector<Span>& spans, const Composition& how) {
  HaloLine line = picture(curve, how);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Vec3& p = curve.points[i];
    const double cosine = std::abs(glm::dot(curve.normals[i], how.camera.to_viewer(p)));
    const double c = std::clamp(cosine, kMostSlanted, 1.0);
    line.slopes.push_back(std::sqrt(1 - c * c) / c / how.camera.scale_at(p));
  }
  if (!casts(how.style, curve)) return line;
  line.scale.resize(curve.points.size(), 1);
  for (std::size_t i = 0; i < curve.widths.size(); ++i) line.scale[i] *= curve.widths[i];
  for (const Span& span : spans) {
    if (span.visible) line.casters.push_back({span.begin, span.end, 0.5});
  }
  return line;
}

}  // namespace

Haloes find_haloes(const LinesToDraw& lines, const Composition& how, const RunContext& context) {
  Haloes out;
  out.features.resize(lines.features.size());
  out.strokes.resize(lines.strokes.size());
  const bool trails = std::ranges::any_of(lines.features, [&](const Curve3& curve) {
    return curve.kind == LineClass::Trail && how.draws(curve);
  });
  if (how.style.halo.gap <= 0 && !trails) return out;
  const double gap = how.style.halo.gap > 0 ? how.style.halo.gap : kTrailGap;
  std::vector<HaloLine> all;
  for (std::size_t i = 0; i < lines.features.size(); ++i) {
    const bool drawn = how.draws(lines.features[i]);
    all.push_back(drawn ? feature_line(lines.features[i], lines.feature_spans[i], how)
                        : HaloLine{});
    // Trails alone leave the lines of the shape whole.
    all.back().interrupted = how.style.halo.gap > 0;
  }
  for (std::size_t i = 0; i < lines.strokes.size(); ++i) {
    all.push_back(stroke_line(lines.strokes[i], lines.stroke_spans[i], how));
  }
  // What lies no deeper than the halo is wide has no need to be set apart.
  auto gaps = halo_gaps(all, {.gap = gap, .behind = gap / how.camera.scale()}, context);
  const auto features = static_cast<std::ptrdiff_t>(lines.features.size());
  std::move(gaps.begin(), gaps.begin() + features, out.features.begin());
  std::move(gaps.begin() + features, gaps.end(), out.strokes.begin());
  return out;
}

std::vector<Span> without(const Span& span, const Gaps& gaps, bool closed, double count) {
  if (gaps.empty()) return {span};
  Span rest = span;
  if (closed && rest.end - rest.begin >= count) {  // a whole turn: begin it behind a gap
    rest.begin = gaps.back().end;
    rest.end = rest.begin + count;
  }
  std::vector<Span> out;
  for (const double turn : {0.0, count}) {
    if (turn > 0 && !closed) break;
    for (const HaloGap& gap : gaps) {
      const double begin = gap.begin + turn, end = gap.end + turn;
      if (end <= rest.begin || begin >= rest.end) continue;
      if (begin > rest.begin) {
        out.push_back(rest);
        out.back().end = begin;
      }
      rest.begin = end;
    }
  }
  if (rest.begin < rest.end) out.push_back(rest);
  return out;
}

}  // namespace burin::detail
