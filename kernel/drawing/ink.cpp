#include <burin/drawing/ink.h>
#include <burin/drawing/length.h>
#include <burin/drawing/outline.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burin {
namespace {

constexpr double kVisibleWidthChange = 0.01;  // paper mm
constexpr double kWidestRoundCap = 0.15;      // paper mm

/// Whether a path is drawn as a filled outline: where its width varies, and strokes so wide that
/// the round cap of a stroked line would show beyond the crease that they end at.
bool is_outlined(const Path& p) {
  if (is_dot(p)) return false;
  return has_varying_width(p) ||
         (p.kind == LineClass::Stroke && !p.closed && mean_width(p) > kWidestRoundCap);
}

/// Adds a point half a width beyond the end of a line: the nose of an outline ends where its line
/// does, a round cap half a width later.
void prolong(std::vector<Vec2>& points, std::vector<double>& widths) {
  const std::size_t n = points.size();
  std::size_t before = n - 1;
  while (before > 0 && points[before - 1] == points[n - 1]) --before;
  if (before == 0) return;
  const Vec2 along = glm::normalize(points[n - 1] - points[before - 1]);
  points.push_back(points[n - 1] + 0.5 * widths[n - 1] * along);
  widths.push_back(widths[n - 1]);
}

/// The chains of a stroke; a closed one is cut open at its first point, where two noses meet. Lines
/// that are no strokes keep the round caps that they have where their width does not vary, so that
/// those that meet leave no notch.
std::vector<std::vector<CubicBezier>> outline_of(const Path& p, double tolerance) {
  std::vector<Vec2> points = p.points;
  std::vector<double> widths = p.width;
  widths.resize(points.size(), mean_width(p));
  if (p.closed) {
    // A little past the first point, so that the noses overlap.
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      points.push_back(points[i]);
      widths.push_back(widths[i]);
    }
  } else if (p.kind != LineClass::Stroke) {
    for (int end = 0; end < 2; ++end) {
      prolong(points, widths);
      std::reverse(points.begin(), points.end());
      std::reverse(widths.begin(), widths.end());
    }
  }
  return stroke_outline(points, widths, tolerance);
}

}  // namespace

std::vector<double> InkLayer::dashes(const DashOptions& options) const {
  if (!own_dashes.empty()) return own_dashes;
  if (name == kHiddenLayer) return {options.dash, options.gap};
  constexpr double kDot = 0.01;  // paper mm: its round caps make it a dot
  if (name == kTrailLayer) return {2 * options.dash, options.gap, kDot, options.gap};
  if (has_long_dashes(name)) return {3 * options.dash, options.gap, kDot, options.gap};
  return {};
}

std::vector<double> fitted_dashes(const std::vector<double>& dashes, const Path& path) {
  if (dashes.empty() || path.points.size() < 2) return dashes;
  double length = length_of(path);
  if (path.closed) length += glm::distance(path.points.back(), path.points.front());
  const double period = std::accumulate(dashes.begin(), dashes.end(), 0.0);
  if (!(length > 0) || !(period > 0)) return dashes;
  // An open line has one dash more than it has periods.
  const double more = path.closed ? 0 : dashes.front();
  // In an even number of them the middle is a dash.
  const double together = path.kind == LineClass::Centre && !path.closed ? 2 : 1;
  const double periods = together * std::round((length - more) / (together * period));
  if (periods < 1) return {length, period};
  std::vector<double> fitted = dashes;
  for (double& one : fitted) one *= length / (periods * period + more);
  return fitted;
}

std::vector<InkLayer> ink_layers(const Drawing& drawing) {
  std::vector<InkLayer> layers;
  InkLayer hidden{std::string(kHiddenLayer), {}};
  bool hidden_placed = false;
  std::size_t hidden_at = 0;
  for (const Layer& layer : drawing.layers) {
    if (layer.name == kHiddenLayer && !hidden_placed) {
      hidden_placed = true;
      hidden_at = layers.size();
      hidden.color = layer.color;
      hidden.own_dashes = layer.dashes;
    }
    InkLayer ink{layer.name, {}, {}, layer.color, layer.dashes};
    for (const Path& p : layer.paths) {
      if (p.points.size() < 2 || !is_finite(p)) continue;
      const bool to_hidden = (!p.visible && !p.in_full) || layer.name == kHiddenLayer;
      (to_hidden ? hidden : ink).parts[p.source.part].push_back(&p);
    }
    for (const Text& t : layer.texts) {
      const bool finite = std::isfinite(t.at.x) && std::isfinite(t.at.y) && std::isfinite(t.height);
      if (finite && t.height > 0 && !t.text.empty()) {
        (layer.name == kHiddenLayer ? hidden : ink).texts.push_back(&t);
      }
    }
    if (layer.name != kHiddenLayer) layers.push_back(std::move(ink));
  }
  if (hidden_placed || !hidden.parts.empty()) {
    layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(hidden_at), std::move(hidden));
  }
  return layers;
}

const std::string& ink_color(const InkLayer& layer, const Drawing& drawing) {
  return layer.color.empty() ? drawing.ink_color : layer.color;
}

const std::string& ink_color(const Path& path, const InkLayer& layer, const Drawing& drawing) {
  return path.color.empty() ? ink_color(layer, drawing) : path.color;
}

const char* to_string(TextAnchor anchor) {
  return anchor == TextAnchor::Start ? "start" : anchor == TextAnchor::Middle ? "middle" : "end";
}

bool is_dot(const Path& path) {
  const bool may_be = path.kind == LineClass::Stroke || path.kind == LineClass::Leader;
  if (path.closed || !may_be) return false;
  const double most = 0.5 * mean_width(path);
  double length = 0;
  for (std::size_t i = 1; i < path.points.size() && length < most; ++i) {
    length += glm::distance(path.points[i - 1], path.points[i]);
  }
  return length < most;
}

bool wants_area(const Path& path) { return (path.visible || path.in_full) && is_outlined(path); }

Ink ink_of(const Path& path, double tolerance) {
  Ink ink;
  if (wants_area(path)) ink.chains = outline_of(path, tolerance);
  ink.filled = !ink.chains.empty();
  if (!ink.filled) {
    ink.width = mean_width(path);
    ink.chains.push_back(fit_cubics(path.points, path.closed, tolerance));
  }
  return ink;
}

bool is_finite(const Path& path) {
  const auto number = [](double x) { return std::isfinite(x); };
  const auto point = [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  const auto point3 = [](Vec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  return std::all_of(path.points.begin(), path.points.end(), point) &&
         std::all_of(path.points3.begin(), path.points3.end(), point3) &&
         std::all_of(path.width.begin(), path.width.end(), number);
}

double mean_width(const Path& path) {
  const std::size_t n = path.points.size();
  if (path.width.empty()) return 0;
  if (path.width.size() != n || n < 2) return path.width.front();
  double ink = 0, length = 0;
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double l = glm::distance(path.points[i], path.points[j]);
    ink += l * 0.5 * (path.width[i] + path.width[j]);
    length += l;
  }
  return length > 0 ? ink / length : path.width.front();
}

bool has_varying_width(const Path& path) {
  if (path.width.size() != path.points.size() || path.width.size() < 2) return false;
  const auto [low, high] = std::minmax_element(path.width.begin(), path.width.end());
  return *high - *low > kVisibleWidthChange;
}

bool is_painted(const Area& area) { return !area.fill.empty() && area.opacity > 0; }

std::vector<const Area*> painted_areas(const Drawing& drawing) {
  std::vector<const Area*> areas;
  for (const Area& area : drawing.areas) {
    if (is_painted(area) && !area.rings.empty()) areas.push_back(&area);
  }
  return areas;
}

void add_ink(const std::string& name, const std::string& color, Drawing& drawing) {
  const auto known = std::ranges::find(drawing.inks, name, &SpotInk::name);
  if (!name.empty() && known == drawing.inks.end()) drawing.inks.push_back({name, color});
}

}  // namespace burin
