#include <burin/drawing/near_sheet.h>

#include <algorithm>
#include <optional>

namespace burin {
namespace {

struct Window {
  Vec2 low, high;

  bool holds(Vec2 p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }
};

/// The share of a segment inside the window, as parameters. @cite LiangBarsky1984
std::optional<std::pair<double, double>> inside(Vec2 a, Vec2 b, const Window& window) {
  double t0 = 0, t1 = 1;
  for (int i = 0; i < 2; ++i) {
    const double d = b[i] - a[i];
    if (d == 0) {
      if (a[i] < window.low[i] || a[i] > window.high[i]) return {};
      continue;
    }
    const double u = (window.low[i] - a[i]) / d, v = (window.high[i] - a[i]) / d;
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
  if (!(t0 <= t1)) return {};
  return std::pair(t0, t1);
}

/// The pieces of a path inside the window; they have no points in the model.
void cut(const Path& path, const Window& window, std::deque<Path>& out) {
  const std::size_t n = path.points.size();
  const bool varies = path.width.size() == n;
  Path head;
  head.kind = path.kind;
  head.visible = path.visible;
  head.in_full = path.in_full;
  head.source = path.source;
  head.width = path.width;
  if (varies) head.width.clear();
  bool goes_on = false;
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Vec2 a = path.points[i], b = path.points[j];
    const auto part = inside(a, b, window);
    if (!part) {
      goes_on = false;
      continue;
    }
    const auto add = [&](double t) {
      Path& piece = out.back();
      piece.points.push_back(glm::mix(a, b, t));
      if (varies) piece.width.push_back(glm::mix(path.width[i], path.width[j], t));
    };
    if (!goes_on) {
      out.push_back(head);
      add(part->first);
    }
    add(part->second);
    goes_on = part->second == 1;
  }
}

}  // namespace

NearSheet::NearSheet(const Drawing& drawing) : layers_(ink_layers(drawing)) {
  const Vec2 sheet(drawing.paper_width, drawing.paper_height);
  const Vec2 room(std::max(sheet.x, sheet.y));
  const Window window{-room, sheet + room};
  for (InkLayer& layer : layers_) {
    for (auto& [part, paths] : layer.parts) {
      std::vector<const Path*> kept;
      kept.reserve(paths.size());
      for (const Path* path : paths) {
        if (std::all_of(path->points.begin(), path->points.end(),
                        [&](Vec2 p) { return window.holds(p); })) {
          kept.push_back(path);
          continue;
        }
        const std::size_t first = pieces_.size();
        cut(*path, window, pieces_);
        for (std::size_t i = first; i < pieces_.size(); ++i) kept.push_back(&pieces_[i]);
      }
      paths = std::move(kept);
    }
  }
}

}  // namespace burin
