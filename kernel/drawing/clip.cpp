#include <burin/drawing/clip.h>
#include <burin/planar/segment_in_box.h>

#include "breaks/strip_edge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace burin {
namespace {

// The share of a segment in the window, as parameters.
std::optional<std::pair<double, double>> inside(Vec2 a, Vec2 b, const Box2& window) {
  return segment_in_box(a, b, window);
}

std::optional<std::pair<double, double>> inside(Vec2 a, Vec2 b, const Disc& disc) {
  const Vec2 way = b - a, off = a - disc.center;
  const double A = glm::dot(way, way), B = glm::dot(off, way);
  const double C = glm::dot(off, off) - disc.radius * disc.radius;
  if (A == 0) return C <= 0 ? std::optional(std::pair(0.0, 1.0)) : std::nullopt;
  const double root = B * B - A * C;
  if (!(root >= 0)) return {};
  const double t0 = std::max(0.0, (-B - std::sqrt(root)) / A);
  const double t1 = std::min(1.0, (-B + std::sqrt(root)) / A);
  if (!(t0 <= t1)) return {};
  return std::pair(t0, t1);
}

// A segment over which the edges of the strip are straight.
std::optional<std::pair<double, double>> inside(Vec2 a, Vec2 b, const Strip& strip) {
  const double at_a = strip.at(a), at_b = strip.at(b), way = at_b - at_a;
  if (way == 0) {
    if (at_a < strip.low || at_a > strip.high) return {};
    return std::pair(0.0, 1.0);
  }
  const double u = (strip.low - at_a) / way, v = (strip.high - at_a) / way;
  const double from = std::max(0.0, std::min(u, v)), to = std::min(1.0, std::max(u, v));
  if (!(from <= to)) return {};
  return std::pair(from, to);
}

bool contains(const Strip& strip, Vec2 p) {
  const double at = strip.at(p);
  return at >= strip.low && at <= strip.high;
}
bool contains(const Box2& window, Vec2 p) { return window.contains(p); }
bool contains(const Disc& disc, Vec2 p) { return glm::distance(p, disc.center) <= disc.radius; }

// The share of a segment of the model that is seen as the share `t` of its picture.
double share_in_model(Vec3 a, Vec3 b, double t, const DrawingView* view) {
  if (view == nullptr || view->projection != "perspective") return t;
  const double far_a = glm::dot(view->eye - a, view->direction);
  const double far_b = glm::dot(view->eye - b, view->direction);
  const double sum = (1 - t) * far_b + t * far_a;
  return sum > 0 ? t * far_a / sum : t;
}

// The face of the input at a point of a path.
std::int32_t face_at(const Path& path, std::size_t point) {
  std::int32_t face = path.source.face;
  for (const PathFace& run : path.faces) {
    if (run.first_point <= point) face = run.face;
  }
  return face;
}

template <class Window>
class Cutter {
 public:
  Cutter(const Path& path, const Window& window, const DrawingView* view)
      : path_(path),
        window_(window),
        view_(view),
        varies_(path.width.size() == path.points.size()),
        spatial_(path.points3.size() == path.points.size()) {}

  std::vector<Path> run() {
    const std::size_t n = path_.points.size(), segments = path_.closed ? n : n - 1;
    // A closed path is cut from a point outside on, so that no piece is cut in two at its start.
    const std::size_t first = path_.closed ? outside() : 0;
    for (std::size_t k = 0; k < segments; ++k) segment((first + k) % n, (first + k + 1) % n);
    for (Path& piece : pieces_) name_main_face(piece);
    return std::move(pieces_);
  }

 private:
  std::size_t outside() const {
    std::size_t i = 0;
    while (i + 1 < path_.points.size() && contains(window_, path_.points[i])) ++i;
    return i;
  }

  void segment(std::size_t i, std::size_t j) {
    const auto part = inside(path_.points[i], path_.points[j], window_);
    // A line that touches a corner has no piece there.
    if (!part || (!goes_on_ && part->first == part->second)) {
      goes_on_ = false;
      return;
    }
    if (!goes_on_) {
      begin();
      add(i, j, part->first);
    }
    name_face(face_at(path_, i));
    add(i, j, part->second);
    goes_on_ = part->second == 1;
  }

  void begin() {
    Path head = without_points(path_);
    if (!varies_) head.width = path_.width;
    pieces_.push_back(std::move(head));
  }

  void add(std::size_t i, std::size_t j, double t) {
    Path& piece = pieces_.back();
    piece.points.push_back(glm::mix(path_.points[i], path_.points[j], t));
    if (varies_) piece.width.push_back(glm::mix(path_.width[i], path_.width[j], t));
    if (!spatial_) return;
    const Vec3 a = path_.points3[i], b = path_.points3[j];
    piece.points3.push_back(glm::mix(a, b, share_in_model(a, b, t, view_)));
  }

  // A piece that stays on one face names that alone.
  void name_face(std::int32_t face) {
    if (path_.faces.empty()) return;
    Path& piece = pieces_.back();
    const auto at = static_cast<std::uint32_t>(piece.points.size() - 1);
    const bool first = at == 0;
    if (first) piece.source.face = face;
    const std::int32_t before = piece.faces.empty() ? piece.source.face : piece.faces.back().face;
    if (first || face == before) return;
    if (piece.faces.empty()) piece.faces.push_back({0, piece.source.face});
    piece.faces.push_back({at, face});
  }

  static void name_main_face(Path& piece) {
    std::map<std::int32_t, double> length;
    for (std::size_t run = 0; run < piece.faces.size(); ++run) {
      const std::size_t end =
          run + 1 < piece.faces.size() ? piece.faces[run + 1].first_point : piece.points.size() - 1;
      for (std::size_t i = piece.faces[run].first_point; i < end; ++i) {
        length[piece.faces[run].face] += glm::distance(piece.points[i], piece.points[i + 1]);
      }
    }
    double most = -1;
    for (const auto& [face, mm] : length) {
      if (mm > most) piece.source.face = face;
      most = std::max(most, mm);
    }
  }

  const Path& path_;
  const Window& window_;
  const DrawingView* view_;
  bool varies_, spatial_;
  bool goes_on_ = false;
  std::vector<Path> pieces_;
};

}  // namespace

Path without_points(const Path& path) {
  Path head;
  head.kind = path.kind;
  head.visible = path.visible;
  head.in_full = path.in_full;
  head.source = path.source;
  head.also = path.also;
  head.field = path.field;
  head.family = path.family;
  head.stroke_kind = path.stroke_kind;
  head.color = path.color;
  return head;
}

namespace {

template <class Window>
bool all_in(const Path& path, const Window& window) {
  return std::ranges::all_of(path.points, [&](Vec2 p) { return contains(window, p); });
}

template <class Window>
std::vector<Path> cut(const Path& path, const Window& window, const DrawingView* view) {
  if (path.points.size() < 2) return {};
  return Cutter(path, window, view).run();
}

}  // namespace

bool lies_in(const Path& path, const Box2& window) { return all_in(path, window); }
bool lies_in(const Path& path, const Disc& disc) { return all_in(path, disc); }

std::vector<Path> clipped(const Path& path, const Box2& window, const DrawingView* view) {
  return cut(path, window, view);
}
std::vector<Path> clipped(const Path& path, const Disc& disc, const DrawingView* view) {
  return cut(path, disc, view);
}

bool lies_in(const Path& path, const Strip& strip) {
  return all_in(strip.edge.empty() ? path : detail::refined(path, strip), strip);
}
std::vector<Path> clipped(const Path& path, const Strip& strip, const DrawingView* view) {
  return cut(detail::refined(path, strip), strip, view);
}

namespace {

/// Counterclockwise corners of a convex polygon.
std::vector<Vec2> polygon_of(const Box2& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}
std::vector<Vec2> polygon_of(const Disc& disc) {
  constexpr double kTolerance = 0.005, kMost = 720;  // paper mm; sides
  const double turn = std::acos(std::max(0.0, 1 - kTolerance / std::max(disc.radius, kTolerance)));
  const double sides = std::clamp(std::ceil(std::numbers::pi / turn), 8.0, kMost);
  std::vector<Vec2> corners;
  for (double i = 0; i < sides; ++i) {
    const double a = 2 * std::numbers::pi * i / sides;
    corners.push_back(disc.center + disc.radius * Vec2(std::cos(a), std::sin(a)));
  }
  return corners;
}

/// What is left of a ring in a convex polygon. Where it comes in again, its pieces hang together by
/// sides along the polygon, one over the other: the even-odd rule does not see them. @cite
/// SutherlandHodgman1974
std::vector<Vec2> clipped_ring(std::vector<Vec2> ring, std::span<const Vec2> polygon) {
  for (std::size_t k = 0; k < polygon.size() && !ring.empty(); ++k) {
    const Vec2 corner = polygon[k], side = polygon[(k + 1) % polygon.size()] - corner;
    const auto inside = [&](Vec2 p) {
      return side.x * (p.y - corner.y) - side.y * (p.x - corner.x);
    };
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 p = ring[i], q = ring[(i + 1) % ring.size()];
      const double a = inside(p), b = inside(q);
      if (a >= 0) kept.push_back(p);
      if ((a >= 0) != (b >= 0)) kept.push_back(glm::mix(p, q, a / (a - b)));
    }
    ring = std::move(kept);
  }
  return ring;
}

template <class Window>
void clip_areas(const Window& window, std::vector<Area>& areas) {
  const std::vector<Vec2> polygon = polygon_of(window);
  for (Area& area : areas) {
    for (std::vector<Vec2>& ring : area.rings) {
      const auto in = [&](Vec2 p) { return contains(window, p); };
      if (!std::ranges::all_of(ring, in)) ring = clipped_ring(std::move(ring), polygon);
    }
    std::erase_if(area.rings, [](const std::vector<Vec2>& ring) { return ring.size() < 3; });
  }
  std::erase_if(areas, [](const Area& area) { return area.rings.empty(); });
}

template <class Window>
void clip_all(const Window& window, Drawing& drawing) {
  clip_areas(window, drawing.areas);
  drawing.stats.strokes = 0;
  for (Layer& layer : drawing.layers) {
    std::vector<Path> kept;
    for (Path& path : layer.paths) {
      if (lies_in(path, window)) {
        kept.push_back(std::move(path));
      } else {
        std::vector<Path> pieces = clipped(path, window, &drawing.view);
        kept.insert(kept.end(), std::make_move_iterator(pieces.begin()),
                    std::make_move_iterator(pieces.end()));
      }
    }
    layer.paths = std::move(kept);
    for (const Path& path : layer.paths) drawing.stats.strokes += path.kind == LineClass::Stroke;
  }
  std::erase_if(drawing.layers, [](const Layer& layer) { return layer.paths.empty(); });
}

}  // namespace

void clip_to(const Box2& window, Drawing& drawing) { clip_all(window, drawing); }
void clip_to(const Disc& disc, Drawing& drawing) { clip_all(disc, drawing); }

}  // namespace burin
