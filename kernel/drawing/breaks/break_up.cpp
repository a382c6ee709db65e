#include <burin/drawing/break_up.h>
#include <burin/drawing/clip.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// What is left between the bands, in the whole view.
std::vector<Strip> strips_of(const PaperBreaks& breaks, std::span<const Vec2> edge) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<Strip> strips;
  double low = -kFar;
  for (const PaperBreaks::Band& band : breaks.bands) {
    strips.push_back({low, band.low, breaks.along, {edge.begin(), edge.end()}});
    low = band.high;
  }
  strips.push_back({low, kFar, breaks.along, {edge.begin(), edge.end()}});
  return strips;
}

bool is_laid_over(const Path& path) {
  return path.kind == LineClass::Leader || path.kind == LineClass::Frame;
}

/// A centre line that both ends of the part share.
bool goes_through(const Path& path, const PaperBreaks& breaks) {
  constexpr double kAlong = 1e-3;  // radians: a line that leans more ends elsewhere
  if (path.kind != LineClass::Centre || path.closed || path.points.size() != 2) return false;
  const Vec2 a = path.points[0], b = path.points[1], way = b - a;
  const double across = way.x * breaks.along.y - way.y * breaks.along.x;
  return std::abs(across) <= kAlong * glm::length(way) && !breaks.leaves_out(a) &&
         !breaks.leaves_out(b);
}

void shift(Path& path, Vec2 by) {
  for (Vec2& p : path.points) p += by;
}

}  // namespace

void break_up(const PaperBreaks& breaks, std::span<const Vec2> edge, Drawing& drawing) {
  const std::vector<Strip> strips = strips_of(breaks, edge);
  drawing.stats.strokes = 0;
  for (Layer& layer : drawing.layers) {
    std::vector<Path> kept;
    for (Path& path : layer.paths) {
      if (is_laid_over(path)) {
        kept.push_back(std::move(path));
        continue;
      }
      if (goes_through(path, breaks)) {
        for (Vec2& p : path.points) p = breaks.moved(p);
        kept.push_back(std::move(path));
        continue;
      }
      for (std::size_t i = 0; i < strips.size(); ++i) {
        const Vec2 by = breaks.shift(i);
        if (lies_in(path, strips[i])) {
          shift(path, by);
          kept.push_back(std::move(path));
          break;
        }
        for (Path& piece : clipped(path, strips[i])) {
          shift(piece, by);
          kept.push_back(std::move(piece));
        }
      }
    }
    layer.paths = std::move(kept);
    for (Text& text : layer.texts) text.at = breaks.moved(text.at);
    for (const Path& path : layer.paths) drawing.stats.strokes += path.kind == LineClass::Stroke;
  }
  std::erase_if(drawing.layers,
                [](const Layer& layer) { return layer.paths.empty() && layer.texts.empty(); });
  break_up(breaks, edge, drawing.areas);
}

void break_up(const PaperBreaks& breaks, std::span<const Vec2> edge, std::vector<Area>& areas) {
  const std::vector<Strip> strips = strips_of(breaks, edge);
  for (Area& area : areas) {
    if (!area.role.empty()) continue;
    std::vector<std::vector<Vec2>> kept;
    for (std::size_t i = 0; i < strips.size(); ++i) {
      for (std::vector<Vec2>& piece : clipped_rings(area.rings, strips[i])) {
        for (Vec2& p : piece) p += breaks.shift(i);
        kept.push_back(std::move(piece));
      }
    }
    area.rings = std::move(kept);
  }
  std::erase_if(areas, [](const Area& area) { return area.rings.empty(); });
}

}  // namespace burin
