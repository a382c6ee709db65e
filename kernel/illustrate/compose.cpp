#include "compose.h"

#include <burin/drawing/bezier.h>
#include <burin/feature/source_faces.h>

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

bool same_ink(const Span& a, const Span& b) { return a.visible == b.visible && a.outer == b.outer; }

// Neighbouring spans of one kind made one; on a closed curve the last may take in the first and run
// past the end.
std::vector<Span> merged(const std::vector<Span>& spans, bool closed, double end) {
  std::vector<Span> out;
  for (const Span& s : spans) {
    if (!out.empty() && same_ink(out.back(), s)) {
      out.back().end = s.end;
    } else {
      out.push_back(s);
    }
  }
  if (closed && out.size() > 1 && same_ink(out.front(), out.back())) {
    out.back().end = end + out.front().end;
    out.erase(out.begin());
  }
  return out;
}

Path to_path(const Curve3& curve, const Camera& camera) {
  Path path;
  path.kind = curve.kind;
  path.source = curve.source;
  path.closed = curve.closed;
  path.family = curve.family;
  path.points3 = curve.points;
  path.points.reserve(curve.points.size());
  for (const Vec3& p : curve.points) path.points.push_back(camera.to_paper(p));
  path.width = curve.widths;
  return path;
}

double paper_length(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    sum += glm::length(path.points[i] - path.points[i - 1]);
  return sum;
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

double feature_width(const Style& style, LineClass kind, const Span& span) {
  if (!span.visible) return style.line.hidden;
  if (span.outer) return style.line.outer;
  switch (kind) {
    case LineClass::Contour:
      return style.line.contour;
    case LineClass::Boundary:
      return style.line.boundary;
    case LineClass::Intersection:
      return style.line.intersection;
    case LineClass::Smooth:
    case LineClass::Seam:
      return style.line.smooth;
    default:
      return style.line.crease;
  }
}

bool is_drawn(const Style& style, LineClass kind) {
  switch (kind) {
    case LineClass::Contour:
      return style.feature.contours;
    case LineClass::Boundary:
      return style.feature.boundaries;
    case LineClass::Intersection:
      return style.feature.intersections;
    case LineClass::Smooth:
      return style.feature.smooth;
    case LineClass::Seam:
      return style.feature.seams;
    default:
      return style.feature.creases;
  }
}

const char* feature_layer(LineClass kind, const Span& span) {
  if (!span.visible) return "hidden";
  if (span.outer) return "outline";
  return to_string(kind);
}

const ProxyMesh& proxy_of(std::span<const ProxyMesh* const> proxies, const Curve3& curve) {
  return *proxies[static_cast<std::size_t>(curve.source.part)];
}

const Style& style_of(const Looks& looks, const Curve3& curve) {
  return looks.style(static_cast<std::size_t>(curve.source.part));
}

}  // namespace

void compose_strokes(std::span<const Curve3> strokes, const std::vector<std::vector<Span>>& spans,
                     std::span<const ProxyMesh* const> proxies, const Camera& camera,
                     const Looks& looks, Drawing& drawing) {
  Layer layers[2] = {{"stroke-1", {}}, {"stroke-2", {}}};
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Curve3& curve = strokes[i];
    const Style& style = style_of(looks, curve);
    const auto count = static_cast<double>(curve.segment_count());
    for (const Span& span : merged(spans[i], curve.closed, count)) {
      if (!span.visible) continue;
      const bool whole = span.begin <= 0 && span.end >= count;
      const Curve3 visible = piece(curve, span);
      Path path = to_path(visible, camera);
      if (!whole && paper_length(path) < kShortestRest * style.hatch.length_min) continue;
      path.field = style.hatch.field;
      name_faces(visible, proxy_of(proxies, curve), camera, path);
      simplify_path(path);
      layers[curve.family == 2 ? 1 : 0].paths.push_back(std::move(path));
    }
  }
  for (Layer& layer : layers) {
    drawing.stats.strokes += static_cast<std::int64_t>(layer.paths.size());
    if (!layer.paths.empty()) drawing.layers.push_back(std::move(layer));
  }
}

void compose_features(std::span<const Curve3> features, const std::vector<std::vector<Span>>& spans,
                      std::span<const ProxyMesh* const> proxies, const Camera& camera,
                      const Looks& looks, HiddenLines hidden, Drawing& drawing) {
  std::vector<Layer> layers;
  for (const char* name :
       {"hidden", "seam", "smooth", "intersection", "crease", "boundary", "contour", "outline"}) {
    layers.push_back({name, {}});
  }
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Curve3& curve = features[i];
    const Style& style = style_of(looks, curve);
    if (!is_drawn(style, curve.kind)) continue;
    for (const Span& span :
         merged(spans[i], curve.closed, static_cast<double>(curve.segment_count()))) {
      if (!span.visible && hidden == HiddenLines::None) continue;
      const Curve3 drawn = piece(curve, span);
      Path path = to_path(drawn, camera);
      if (path.points.size() < 2) continue;
      path.visible = span.visible;
      path.width = {feature_width(style, curve.kind, span)};
      name_faces(drawn, proxy_of(proxies, curve), camera, path);
      simplify_path(path);
      const char* name = feature_layer(curve.kind, span);
      const auto layer = std::ranges::find(layers, name, &Layer::name);
      if (layer == layers.end()) {
        layers.push_back({name, {std::move(path)}});
      } else {
        layer->paths.push_back(std::move(path));
      }
    }
  }
  for (Layer& layer : layers) {
    if (!layer.paths.empty()) drawing.layers.push_back(std::move(layer));
  }
}

}  // namespace burin::detail
