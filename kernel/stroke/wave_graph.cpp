#include "wave_graph.h"

#include <burin/base/parallel.h>

#include "sample_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

constexpr double kNodeFacing = 0.03;  // cosine: seen more edge-on, a cell has no node
constexpr double kLeastGap = 0.12;    // of its true length that a gap across the lines keeps
constexpr double kSameLine = 0.6;   // cosine of the turn from cell to cell up to which lines go on
constexpr double kTurned = 0.25;    // cosine: seen more edge-on, a surface turns away
constexpr double kUnbroken = 0.94;  // ... without a bend: 20 degrees
constexpr double kSlant = 0.34;     // ... and the sine of that to the border: as much
constexpr double kAlike = 0.9;      // of the border of two faces where lines go on so: they are one
constexpr double kDiagonal = 0.25;  // weight of a diagonal link
// Lines may draw together towards contours: where the surface is slanted by more than kSlantedLink.
constexpr double kSlantedLink = 0.5;
constexpr double kDrawnTogether = 0.35;

// What the links need to know of a cell.
struct Look {
  Vec3 normal{0}, tangent{0};
  Vec2 wave{0};
  FaceKind kind = FaceKind::Freeform;
  Vec3 around{0};  // of a torus: about its axis where that is the larger circle
};

// A face of the input.
using FaceId = std::pair<std::int32_t, std::int32_t>;  // part, face

// How far apart lines are to run at a place that is seen under a cosine of `facing`.
double gap_at(const Picture& picture, const RasterCell& cell, int family, double across) {
  const HatchOptions& o = picture.options;
  const double even =
      kDrawnTogether + (1 - kDrawnTogether) * std::min(1.0, cell.facing / kSlantedLink);
  constexpr double kLeastKept = 0.2;  // never denser than five times
  const double kept = std::max(across, kLeastKept);
  double gap = picture.line_spacing(picture.share(cell.darkness, family));
  if (family == 2) {
    constexpr double kSecond = 1.12;  // else it would beat with the first
    // What a width makes up for elsewhere would be missing with one pen.
    gap = picture.one_pen() ? std::max(gap, kSecond * o.spacing_min) : kSecond * gap;
  }
  return gap * even * (1 - o.foreshortening + o.foreshortening * kept);
}

std::optional<Look> look(const Picture& picture, const RasterCell& cell, int family) {
  if (!has_node(cell)) return std::nullopt;
  // The second family is nowhere but where it has ink.
  if (family == 2 && !(picture.share(cell.darkness, family) > 0)) return std::nullopt;
  const Surface& surface = picture.surface(cell.part);
  const Camera& camera = picture.camera;
  const SurfacePoint point = surface.lift(cell.place());
  const Frame frame = surface.frame(point);
  const auto cross = picture.field.cross({cell.part, point, frame});
  if (!cross) return std::nullopt;
  Look out{frame.normal, family_direction(*cross, family), Vec2(0)};
  const Vec2 along = camera.velocity(point.position, out.tangent);
  const Vec2 across = camera.velocity(point.position, glm::cross(out.normal, out.tangent));
  const double speed = glm::length(along), scale = camera.scale_at(point.position);
  if (!(speed > 1e-6 * scale)) return std::nullopt;  // a line that runs to the viewer
  // One mm across the lines on the surface shows as so many on paper.
  const double gap = std::abs(cross2(along, across)) / speed / scale;
  const double turns = std::max(1.0, kLeastGap / std::max(gap, 1e-6)) /
                       gap_at(picture, cell, family, glm::length(across) / scale) * cell.denser;
  const Vec2 unit = Vec2(-along.y, along.x) / speed;
  out.wave = turns * unit;
  out.kind = frame.kind;
  out.around = std::abs(frame.k1) < std::abs(frame.k2) ? frame.d1 : frame.d2;
  return std::isfinite(turns) ? std::optional(out) : std::nullopt;
}

class Builder {
 public:
  Builder(const Picture& picture, const ViewRaster& raster, int family, const RunContext& context)
      : picture_(picture), raster_(raster), family_(family), context_(context) {}

  WaveGraph build() {
    make_nodes();
    find_fillets();
    make_links();
    orient();
    return std::move(graph_);
  }

 private:
  // Whether a cell lies in the narrow strip along a contour in which the surface turns away: what
  // lines would do there would decide what they do elsewhere. Strokes run through it by themselves.
  bool at_contour(std::size_t i) const {
    constexpr float kEdgeOn = 0.1F;     // cosine
    constexpr std::int32_t kWidth = 3;  // cells
    const RasterCell& cell = raster_.cells[i];
    if (cell.part < 0 || cell.facing > kEdgeOn) return false;
    const auto x = static_cast<std::int32_t>(i % static_cast<std::size_t>(raster_.nx)),
               y = static_cast<std::int32_t>(i / static_cast<std::size_t>(raster_.nx));
    bool border = false, turned = false;
    for (std::int32_t dy = -kWidth; dy <= kWidth; dy += kWidth) {
      for (std::int32_t dx = -kWidth; dx <= kWidth; dx += kWidth) {
        const std::int32_t bx = x + dx, by = y + dy;
        if (bx < 0 || by < 0 || bx >= raster_.nx || by >= raster_.ny) continue;
        const RasterCell& other = raster_.at(bx, by);
        const bool same = other.part == cell.part && other.region == cell.region;
        (same ? turned : border) |= !same || other.facing > kEdgeOn;
      }
    }
    return border && turned;
  }

  void make_nodes() {
    const std::size_t count = raster_.cells.size();
    std::vector<std::optional<Look>> looks(count);
    constexpr std::size_t kGrain = 512;
    parallel_for(
        count, kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            if (!at_contour(i)) looks[i] = look(picture_, raster_.cells[i], family_);
          }
        },
        &context_);
    graph_.node.assign(count, kNone);
    for (std::size_t i = 0; i < count; ++i) {
      if (!looks[i]) continue;
      graph_.node[i] = static_cast<std::int32_t>(graph_.nodes.size());
      graph_.nodes.push_back(
          {static_cast<std::uint32_t>(i), looks[i]->wave, ruled(looks[i]->kind)});
      looks_.push_back(*looks[i]);
    }
  }

  // The sheet at a node, as strokes have it.
  GridSample sheet(std::uint32_t node) const {
    const std::size_t i = graph_.nodes[node].cell;
    const RasterCell& cell = raster_.cells[i];
    GridSample s;
    s.paper = raster_.center(i);
    s.depth = cell.depth;
    s.slope = Picture::slope(cell.facing, picture_.camera.scale());
    s.part = cell.part;
    s.region = cell.region;
    return s;
  }

  FaceId face_of(std::uint32_t node) const {
    const RasterCell& cell = raster_.cells[graph_.nodes[node].cell];
    return {cell.part, picture_.surface(cell.part).proxy().face_source(cell.face)};
  }

  // Calls `take(plane, torus)` for nodes beside each other of a plane and of a torus on one sheet.
  template <class Take>
  void for_each_fillet(const Take& take) const {
    const auto look_at = [&](std::size_t a, std::size_t b) {
      const std::int32_t i = graph_.node[a], j = graph_.node[b];
      if (i == kNone || j == kNone) return;
      auto plane = static_cast<std::uint32_t>(i), torus = static_cast<std::uint32_t>(j);
      if (looks_[plane].kind != FaceKind::Plane) std::swap(plane, torus);
      const bool both =
          looks_[plane].kind == FaceKind::Plane && looks_[torus].kind == FaceKind::Torus;
      if (both && same_sheet(sheet(plane), sheet(torus))) take(plane, torus);
    };
    for (std::int32_t y = 0; y < raster_.ny; ++y) {
      context_.check();
      for (std::int32_t x = 0; x < raster_.nx; ++x) {
        const std::size_t i = raster_.index(x, y);
        if (x + 1 < raster_.nx) look_at(i, i + 1);
        if (y + 1 < raster_.ny) look_at(i, raster_.index(x, y + 1));
      }
    }
  }

  // A plane and the fillet around something round on it: lines run straight on the one and about
  // its axis on the other, along the border here and across it there. One phase for both would bend
  // those of the plane all around. Where the border that is seen turns little they go on as one,
  // and where they cross it squarely, or run along it, all the way: those of a washer.
  void find_fillets() {
    struct Border {
      Mat3 directions{0};  // the sum of their squares
      double cells = 0;
      double alike = 0;  // cells where lines cross it squarely and go on
    };
    std::map<FaceId, Border> borders;
    for_each_fillet([&](std::uint32_t plane, std::uint32_t torus) {
      Border& border = borders[face_of(torus)];
      border.directions += glm::outerProduct(looks_[torus].around, looks_[torus].around);
      border.cells += 1;
      const bool squarely =
          std::abs(glm::dot(looks_[torus].tangent, looks_[torus].around)) < kSlant;
      border.alike += squarely && turn(plane, torus) > kUnbroken ? 1 : 0;
    });
    // Of an arc of 110 degrees: the share of its directions along the one that most have.
    constexpr double kOneWay = 0.75;
    for (const auto& [face, border] : borders) {
      // Directions in a plane: the larger of two eigenvalues, from the sum of their squares.
      double squares = 0;
      for (int k = 0; k < 3; ++k) squares += glm::dot(border.directions[k], border.directions[k]);
      const double share =
          0.5 + 0.5 * std::sqrt(std::max(0.0, 2 * squares / (border.cells * border.cells) - 1));
      if (share < kOneWay) round_[face] = border.alike >= kAlike * border.cells;
    }
  }

  // The cosine of the turn of lines from one node to the next one.
  double turn(std::uint32_t a, std::uint32_t b) const {
    const Vec3 there = transport(looks_[b].tangent, looks_[b].normal, looks_[a].normal);
    return std::abs(glm::dot(there, looks_[a].tangent));
  }

  bool part_ways(std::uint32_t a, std::uint32_t b) const {
    if (round_.empty()) return false;
    if (looks_[a].kind != FaceKind::Plane) std::swap(a, b);
    if (looks_[a].kind != FaceKind::Plane || looks_[b].kind != FaceKind::Torus) return false;
    const auto fillet = round_.find(face_of(b));
    return fillet != round_.end() && !(fillet->second && stays_in_sight(a, b));
  }

  // Whether a quarter of a torus that begins at a plane does not turn away from the viewer: lines
  // crowd towards a contour, and would bend those of the plane with them.
  bool stays_in_sight(std::uint32_t plane, std::uint32_t torus) const {
    const Vec3 up = looks_[plane].normal, towards = looks_[torus].normal;
    const Vec3 last = towards - glm::dot(towards, up) * up;  // the normal a quarter further on
    const RasterCell& cell = raster_.cells[graph_.nodes[torus].cell];
    const Vec3 position = picture_.surface(cell.part).lift(cell.place()).position;
    return glm::dot(last, picture_.camera.to_viewer(position)) > kTurned * glm::length(last);
  }

  bool one_line(std::uint32_t a, std::uint32_t b) const {
    if (!same_sheet(sheet(a), sheet(b))) return false;
    if (part_ways(a, b)) return false;
    if (turn(a, b) < kSameLine) return false;
    return std::abs(glm::dot(looks_[a].wave, looks_[b].wave)) >=
           0.5 * glm::length(looks_[a].wave) * glm::length(looks_[b].wave);
  }

  std::int32_t link(std::size_t a, std::size_t b, double weight) {
    const std::int32_t na = graph_.node[a], nb = graph_.node[b];
    if (na == kNone || nb == kNone) return kNone;
    const auto i = static_cast<std::uint32_t>(na), j = static_cast<std::uint32_t>(nb);
    if (!one_line(i, j)) return kNone;
    // Where the surface turns away a line may end more cheaply than elsewhere.
    const double edge = std::min(raster_.cells[a].facing, raster_.cells[b].facing) / kTurned;
    const double sure = std::clamp(edge * edge * edge, 0.003, 1.0);
    graph_.links.push_back({i, j, sheet(j).paper - sheet(i).paper, weight * sure, false});
    return static_cast<std::int32_t>(graph_.links.size()) - 1;
  }

  void make_links() {
    const std::size_t count = raster_.cells.size();
    graph_.links.clear();
    graph_.right.assign(count, kNone);
    graph_.up.assign(count, kNone);
    graph_.diagonal.assign(count, kNone);
    for (std::int32_t y = 0; y < raster_.ny; ++y) {
      context_.check();
      for (std::int32_t x = 0; x < raster_.nx; ++x) {
        const std::size_t i = raster_.index(x, y);
        if (x + 1 < raster_.nx) graph_.right[i] = link(i, i + 1, 1);
        if (y + 1 < raster_.ny) graph_.up[i] = link(i, raster_.index(x, y + 1), 1);
        if (x + 1 < raster_.nx && y + 1 < raster_.ny) graph_.diagonal[i] = diagonal(x, y);
      }
    }
  }

  // Alternating; where a corner is missing the one that closes a triangle.
  std::int32_t diagonal(std::int32_t x, std::int32_t y) {
    const std::size_t low = raster_.index(x, y), right = raster_.index(x + 1, y),
                      up = raster_.index(x, y + 1), far = raster_.index(x + 1, y + 1);
    const auto has = [&](std::size_t i) { return graph_.node[i] != kNone; };
    const bool rising = has(low) && has(far);
    const bool falling = has(right) && has(up);
    if (rising && (!falling || (x + y) % 2 == 0)) {
      const std::int32_t l = link(low, far, kDiagonal);
      if (l != kNone || !falling) return l;
    }
    if (falling) {
      const std::int32_t l = link(right, up, kDiagonal);
      if (l != kNone) return l;
    }
    return rising && falling && (x + y) % 2 != 0 ? link(low, far, kDiagonal) : kNone;
  }

  // Gives the waves signs along a tree through each component, breadth first.
  void orient() {
    const std::size_t n = graph_.nodes.size();
    const auto around = at_nodes(graph_, [](std::size_t l) {
      return std::array{static_cast<std::uint32_t>(l), static_cast<std::uint32_t>(l)};
    });
    constexpr std::size_t kCheckEvery = 65536;
    constexpr std::uint32_t kUnseen = 0xffffffffu;
    graph_.order.clear();
    graph_.components = 0;
    graph_.component.assign(n, kUnseen);
    graph_.parent_link.assign(n, kNone);
    graph_.order.reserve(n);
    for (std::uint32_t root = 0; root < n; ++root) {
      if (graph_.component[root] != kUnseen) continue;
      graph_.component[root] = graph_.components;
      graph_.order.push_back(root);
      for (std::size_t head = graph_.order.size() - 1; head < graph_.order.size(); ++head) {
        const std::uint32_t i = graph_.order[head];
        if (head % kCheckEvery == 0) context_.check();
        for (const std::uint32_t number : around[i]) {
          const WaveLink& l = graph_.links[number];
          const std::uint32_t j = l.a == i ? l.b : l.a;
          if (graph_.component[j] != kUnseen) continue;
          graph_.component[j] = graph_.components;
          graph_.parent_link[j] = static_cast<std::int32_t>(number);
          if (glm::dot(graph_.nodes[i].wave, graph_.nodes[j].wave) < 0) {
            graph_.nodes[j].wave = -graph_.nodes[j].wave;
          }
          graph_.order.push_back(j);
        }
      }
      ++graph_.components;
    }
    for (WaveLink& l : graph_.links) {
      l.flips = glm::dot(graph_.nodes[l.a].wave, graph_.nodes[l.b].wave) < 0;
    }
  }

  const Picture& picture_;
  const ViewRaster& raster_;
  int family_;
  const RunContext& context_;
  WaveGraph graph_;
  std::vector<Look> looks_;
  // Fillets around something round, and whether lines of the plane go on into theirs everywhere.
  std::map<FaceId, bool> round_;
};

}  // namespace

bool has_node(const RasterCell& cell) { return cell.part >= 0 && cell.facing >= kNodeFacing; }

WaveGraph wave_graph(const Picture& picture, const ViewRaster& raster, int family,
                     const RunContext& context) {
  return Builder(picture, raster, family, context).build();
}

}  // namespace burin::detail
