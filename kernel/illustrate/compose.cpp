#include "compose.h"

#include <burin/drawing/bezier.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/join_lines.h>
#include <burin/drawing/length.h>
#include <burin/drawing/one_line.h>
#include <burin/feature/source_faces.h>

#include "haloes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm: points of a line that lie closer than this to the line through the others are left out;
// a tenth of the thinnest pen's width.
constexpr double kSimplify = 0.005;
// Share of the style's shortest stroke that the visible rest of a stroke must have, so that no
// stubs stand at outlines.
constexpr double kShortestRest = 0.3;

// Paper mm of a centre line that are drawn.
constexpr double kLeastCentre = 1;

Path to_path(const Curve3& curve, const Camera& camera) {
  Path path;
  path.kind = curve.kind;
  path.source = curve.source;
  path.closed = curve.closed;
  path.family = curve.family;
  path.stroke_kind = curve.stroke_kind;
  path.points3 = curve.points;
  path.points.reserve(curve.points.size());
  for (const Vec3& p : curve.points) path.points.push_back(camera.to_paper(p));
  path.width = curve.widths;
  return path;
}

// Where a path goes on to the next face of the input; features that are edges have one face.
void name_faces(const Curve3& curve, const ProxyMesh& proxy, const Camera& camera, Path& path) {
  if (proxy.source_face.empty() || curve.source.edge >= 0 || curve.faces.empty()) return;
  const std::vector<FaceRun> runs = source_faces(curve, proxy, camera);
  path.source.face = main_face(runs);
  if (runs.size() < 2) return;
  for (const FaceRun& run : runs) {
    path.faces.push_back({static_cast<std::uint32_t>(run.first_segment), run.face});
  }
}

// Leaves out points that neither the line nor its width needs; those where the face changes stay.
void simplify_path(Path& path) {
  if (path.points.size() < 3) return;
  const bool varies = path.width.size() == path.points.size();
  std::vector<Vec3> line;
  line.reserve(path.points.size());
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    line.emplace_back(path.points[i], varies ? path.width[i] : 0.0);
  }
  std::size_t kept = 0;
  const auto keep = [&](std::size_t i) {  // ascending: entries move forward only
    path.points[kept] = path.points[i];
    path.points3[kept] = path.points3[i];
    if (varies) path.width[kept] = path.width[i];
    ++kept;
  };
  std::size_t first = 0;
  for (std::size_t run = 1; run <= path.faces.size(); ++run) {
    const std::size_t next =
        run < path.faces.size() ? path.faces[run].first_point : path.points.size() - 1;
    if (next == first) continue;
    const auto part = std::span(line).subspan(first, next - first + 1);
    if (kept > 0) --kept;  // the joint is the last of one part and the first of the next
    for (const std::size_t i : simplify(part, kSimplify)) keep(first + i);
    if (run < path.faces.size()) path.faces[run].first_point = static_cast<std::uint32_t>(kept - 1);
    first = next;
  }
  if (path.faces.empty()) {
    for (const std::size_t i : simplify(line, kSimplify)) keep(i);
  }
  path.points.resize(kept);
  path.points3.resize(kept);
  if (varies) path.width.resize(kept);
}

// The curve between two parameters; a span that is the whole of a closed curve stays closed.
Curve3 piece(const Curve3& curve, const Span& span) {
  const auto count = static_cast<double>(curve.segment_count());
  if (span.begin <= 0 && span.end >= count && span.end - span.begin <= count) return curve;
  return slice(curve, span.begin, span.end);
}

const char* feature_layer(LineClass kind, const Span& span, bool in_full) {
  if (!span.visible) return in_full ? "behind" : "hidden";
  if (span.outer) return "outline";
  if (kind == LineClass::ThreadEnd) return kThreadLayer.data();
  return to_string(kind);
}

const ProxyMesh& proxy_of(std::span<const ProxyMesh* const> proxies, const Curve3& curve) {
  return *proxies[static_cast<std::size_t>(curve.source.part)];
}

// The stretches of a curve's spans that haloes leave.
std::vector<Span> drawn_spans(const Curve3& curve, const std::vector<Span>& spans,
                              const Gaps& gaps) {
  const auto count = static_cast<double>(curve.segment_count());
  std::vector<Span> out;
  for (const Span& span : merged(spans, curve.closed, count)) {
    for (const Span& rest : without(span, gaps, curve.closed, count)) out.push_back(rest);
  }
  return out;
}

// Draws a path's widths after its depth.
void cue_widths(const DepthCue& cue, Path& path) {
  if (!cue.active()) return;
  const std::vector<double> factors = cue.widths(path.points3);
  if (path.width.size() == 1) path.width.assign(factors.size(), path.width.front());
  for (std::size_t i = 0; i < factors.size(); ++i) path.width[i] *= factors[i];
}

// Keeps a line as it was found, before points are left out.
void keep(const Path& path, bool visible, std::vector<Path>* found) {
  if (!found || path.points3.size() < 2) return;
  Path& line = found->emplace_back();
  line.kind = path.kind;
  line.visible = visible;
  line.source = path.source;
  line.closed = path.closed;
  line.points3 = path.points3;
}

// Of one kind of strokes and one of its families.
std::string stroke_layer(int kind, int family) {
  return fmt::format("stroke-{}", family) + (kind > 1 ? fmt::format("-kind-{}", kind) : "");
}

void compose_strokes(const LinesToDraw& lines, const std::vector<Gaps>& gaps,
                     const Composition& how, Drawing& drawing, std::vector<Path>* found) {
  std::vector<Layer> layers;
  for (int kind = 1; kind <= static_cast<int>(kMostStrokeKinds); ++kind) {
    for (const int family : {1, 2}) layers.push_back({stroke_layer(kind, family), {}});
  }
  for (std::size_t i = 0; i < lines.strokes.size(); ++i) {
    const Curve3& curve = lines.strokes[i];
    const auto count = static_cast<double>(curve.segment_count());
    for (const Span& span : drawn_spans(curve, lines.stroke_spans[i], gaps[i])) {
      if (!span.visible) {
        if (found) keep(to_path(piece(curve, span), how.camera), false, found);
        continue;
      }
      const bool whole = span.begin <= 0 && span.end >= count;
      const Curve3 visible = piece(curve, span);
      Path path = to_path(visible, how.camera);
      if (!whole && length_of(path) < kShortestRest * how.hatch_of(curve).length_min) continue;
      keep(path, true, found);
      path.field = how.hatch_of(curve).field.name;
      path.color = how.stroke_color(curve);
      cue_widths(how.cue, path);
      name_faces(visible, proxy_of(how.proxies, curve), how.camera, path);
      simplify_path(path);
      if (is_dot(path)) path.width.resize(1);
      const int layer = 2 * (curve.stroke_kind - 1) + (curve.family == 2 ? 1 : 0);
      layers[static_cast<std::size_t>(layer)].paths.push_back(std::move(path));
    }
  }
  for (Layer& layer : layers) {
    drawing.stats.strokes += static_cast<std::int64_t>(layer.paths.size());
    if (!layer.paths.empty()) drawing.layers.push_back(std::move(layer));
  }
}

void compose_features(const LinesToDraw& lines, const std::vector<Gaps>& gaps,
                      const Composition& how, Drawing& drawing, std::vector<Path>* found,
                      const RunContext& context) {
  std::vector<Layer> layers;
  for (const char* name :
       {"hidden", "behind", "centre", "trail", "pattern", "thread", "isophote", "seam", "smooth",
        "intersection", "crease", "section", "boundary", "contour", "outline"}) {
    layers.push_back({name, {}});
  }
  for (std::size_t i = 0; i < lines.features.size(); ++i) {
    const Curve3& curve = lines.features[i];
    if (!how.draws(curve)) continue;
    for (const Span& span : drawn_spans(curve, lines.feature_spans[i], gaps[i])) {
      if (curve.border_alone && !span.outer) continue;
      // Hidden they say nothing.
      const bool shown_alone = curve.kind == LineClass::Pattern ||
                               curve.kind == LineClass::Isophote || curve.kind == LineClass::Trail;
      if (!span.visible && (shown_alone || !how.shows_hidden())) {
        if (found) keep(to_path(piece(curve, span), how.camera), false, found);
        continue;
      }
      const Curve3 drawn = piece(curve, span);
      Path path = to_path(drawn, how.camera);
      if (path.points.size() < 2) continue;
      // What haloes leave of a line between them, shorter than they are, is a speck.
      const double least = (span.visible ? 1 : 2) * how.style.halo.gap;
      if (!gaps[i].empty() && length_of(path) < least) continue;
      keep(path, span.visible, found);
      path.visible = span.visible;
      path.in_full = !span.visible && how.style.halo.hidden;
      path.width = {how.feature_width(curve, span)};
      path.color = how.feature_color(curve);
      cue_widths(how.cue, path);
      name_faces(drawn, proxy_of(how.proxies, curve), how.camera, path);
      simplify_path(path);
      const char* name = feature_layer(curve.kind, span, path.in_full);
      const auto layer = std::ranges::find(layers, name, &Layer::name);
      if (layer == layers.end()) {
        layers.push_back({name, {std::move(path)}});
      } else {
        layer->paths.push_back(std::move(path));
      }
    }
  }
  for (const Curve3& curve : lines.centres) {
    Path path = to_path(curve, how.camera);
    path.width = {how.feature_width(curve, {})};
    path.color = how.feature_color(curve);
    std::ranges::find(layers, kCentreLayer, &Layer::name)->paths.push_back(std::move(path));
  }
  keep_one_line(layers, context);
  join_lines(layers, context);
  // What other lines leave of a centre line, such as trails along it, may be specks.
  std::erase_if(std::ranges::find(layers, kCentreLayer, &Layer::name)->paths,
                [](const Path& path) { return length_of(path) < kLeastCentre; });
  for (Layer& layer : layers) {
    if (!layer.paths.empty()) drawing.layers.push_back(std::move(layer));
  }
}

}  // namespace

std::string Composition::feature_color(const Curve3& feature) const {
  const std::string& color = style_of(feature).line.color;
  return color == style.sheet.ink ? std::string() : color;
}

std::string Composition::stroke_color(const Curve3& stroke) const {
  const std::string& color = hatch_of(stroke).color;
  if (color.empty()) return feature_color(stroke);
  return color == style.sheet.ink ? std::string() : color;
}

double Composition::feature_width(const Curve3& feature, const Span& span) const {
  const auto& line = style_of(feature).line;
  if (!span.visible) return line.hidden;
  if (span.outer) return line.outer;
  switch (feature.kind) {
    case LineClass::Contour:
      return line.contour;
    case LineClass::Boundary:
      return line.boundary;
    case LineClass::Intersection:
      return line.intersection;
    case LineClass::Smooth:
    case LineClass::Seam:
    case LineClass::Pattern:
    case LineClass::Isophote:
      return line.smooth;
    case LineClass::Section:
      return line.contour;
    case LineClass::Trail:
      return line.trail;
    case LineClass::Centre:
      return line.centre;
    case LineClass::Thread:
      return line.thread;
    case LineClass::ThreadEnd:
      return line.contour;
    default:
      return line.crease;
  }
}

bool Composition::draws(const Curve3& feature) const {
  const auto& drawn = style_of(feature).feature;
  switch (feature.kind) {
    case LineClass::Contour:
      return drawn.contours;
    case LineClass::Boundary:
      return drawn.boundaries;
    case LineClass::Intersection:
      return drawn.intersections;
    case LineClass::Smooth:
      return drawn.smooth;
    case LineClass::Seam:
      return drawn.seams;
    case LineClass::Isophote:
      return drawn.isophotes > 0;
    case LineClass::Section:
    case LineClass::Pattern:
      return true;
    case LineClass::Trail:
      return drawn.trails;
    case LineClass::Centre:
      return drawn.centre_lines;
    case LineClass::Thread:
    case LineClass::ThreadEnd:
      return drawn.threads;
    default:
      return drawn.creases;
  }
}

void compose(const LinesToDraw& lines, const Composition& how, Drawing& drawing,
             const RunContext& context, std::vector<Path>* found) {
  const Haloes haloes = find_haloes(lines, how, context);
  compose_strokes(lines, haloes.strokes, how, drawing, found);
  compose_features(lines, haloes.features, how, drawing, found, context);
}

}  // namespace burin::detail
