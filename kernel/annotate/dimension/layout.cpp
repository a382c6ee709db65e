#include "layout.h"

#include <burin/base/box_corners.h>
#include <burin/drawing/font.h>
#include <burin/planar/convex_hull.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace burin {
namespace detail {

double DimensionGround::taken_in(Vec2 way) const {
  return std::max(way.x, 0.0) * taken.right + std::max(-way.x, 0.0) * taken.left +
         std::max(way.y, 0.0) * taken.top + std::max(-way.y, 0.0) * taken.bottom;
}

namespace {

/// Whether letters lie on a line.
bool lies_on(const Quad& letters, const std::vector<Vec2>& line) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const std::array<Vec2, 2> piece{line[i - 1], line[i]};
    if (overlap(letters, piece)) return true;
  }
  return false;
}

}  // namespace

Conflicts DimensionGround::conflicts(const DimensionPlace& place) const {
  // Paper mm: half a wide line, and as much again.
  constexpr double kOffOutline = 0.7;
  // Paper mm beyond which two have nothing to do with each other, and that lines keep apart.
  const double apart = 0.9 * step(), far = std::max(apart, 1.0);
  const Box2 about = place.print.box();
  Conflicts all;
  for (std::size_t i = 0; i < laid.size() && !alone; ++i) {
    if (i == own) continue;
    const Box2& other = laid[i].about;
    const Vec2 off = glm::max(about.min - other.max, other.min - about.max);
    if (other.empty() || about.empty() || std::max(off.x, off.y) > far) continue;
    const Conflicts one = conflicts_of(place.print, laid[i].print, apart);
    all.hard += one.hard;
    all.crossings += one.crossings;
  }
  for (const PrintedPiece& piece : place.print.pieces) {
    for (const std::vector<Vec2>& line : beside) all.crossings += crossings_of(piece, line);
    for (const std::vector<Vec2>& line : over_it) all.crossings += crossings_of(piece, line);
  }
  for (const Quad& letters : place.print.letters) {
    all.hard += overlap(grown(letters, kOffOutline), outline) ? 1 : 0;
    const auto leaves = [&](Vec2 p) { return !within->contains(p); };
    all.hard += within && std::ranges::any_of(letters, leaves) ? 1 : 0;
    for (const std::vector<Vec2>& line : over_it) {
      all.hard += lies_on(grown(letters, kOffOutline), line) ? 1 : 0;
    }
    // Extension lines of an oblique view lean over the number between them.
    for (const PrintedPiece& piece : place.print.pieces) {
      const std::array<Vec2, 2> ends{piece.a, piece.b};
      const bool extension = piece.stroke == Stroke::Extension;
      all.hard += extension && overlap(letters, ends) ? 1 : 0;
    }
  }
  return all;
}

double cost_of(const Conflicts& found) {
  constexpr double kCrossing = 10, kHard = 1000;
  return kCrossing * found.crossings + kHard * found.hard;
}

DimensionPlace first_free(const std::function<DimensionPlace(int)>& make, int steps,
                          const DimensionGround& ground, double limit) {
  DimensionPlace best;
  best.cost = std::numeric_limits<double>::infinity();
  for (int i = 0; i < steps; ++i) {
    DimensionPlace place = make(i);
    if (place.cost >= limit) break;
    const Conflicts found = ground.conflicts(place);
    place.alone = place.cost;
    place.cost += cost_of(found);
    if (place.cost < best.cost) best = std::move(place);
    if (found.hard == 0) break;
  }
  return best;
}

namespace {

/// The order in which places are looked for: notes with a place of their own, short lengths, long
/// ones, those of the whole drawing, then what is shown by leaders.
std::vector<std::size_t> order_of(const std::vector<Dimension>& list, const PaperView& view) {
  std::vector<std::size_t> order(list.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    const Dimension& one = list[i];
    const bool length = one.kind == Dimension::Kind::Length;
    const int group = one.place                            ? 0
                      : length                             ? (one.overall ? 2 : 1)
                      : one.kind == Dimension::Kind::Angle ? 3
                      : one.kind == Dimension::Kind::Round ? 4
                                                           : 5;
    // Rounded, so that equal lengths are equal on any machine.
    constexpr double kRounded = 1e-6;  // paper mm
    const double size =
        length ? std::round(glm::distance(view.at(one.from), view.at(one.to)) / kRounded) : 0;
    return std::pair(group, size);
  };
  std::ranges::stable_sort(order, {}, rank);
  return order;
}

DimensionPlace found_place(const Dimension& one, const DimensionGround& ground) {
  switch (one.kind) {
    case Dimension::Kind::Round:
      return place_round(one, ground);
    case Dimension::Kind::Angle:
      return place_angle(one, ground);
    case Dimension::Kind::Note:
      return place_note(one, ground);
    case Dimension::Kind::Length:
      break;
  }
  return place_length(one, ground);
}

DimensionPlace place_of(const Dimension& one, const DimensionGround& ground) {
  DimensionPlace place = found_place(one, ground);
  place.about = place.print.box();
  return place;
}

/// `beside`: what it goes about, too.
std::vector<Vec2> outline_of(const Box3& about, const std::vector<std::vector<Vec2>>& beside,
                             const PaperView& view) {
  if (about.empty()) return {};
  std::vector<Vec2> corners;
  for (const std::vector<Vec2>& line : beside) {
    corners.insert(corners.end(), line.begin(), line.end());
  }
  for (const Vec3& corner : corners_of(about)) corners.push_back(view.at(corner));
  return convex_hull(std::move(corners));
}

/// Of all places, with what is wrong between them.
double cost_of_all(DimensionGround& ground) {
  double cost = 0;
  for (std::size_t k = 0; k < ground.laid.size(); ++k) {
    ground.own = k;
    cost += ground.laid[k].alone + cost_of(ground.conflicts(ground.laid[k]));
  }
  return cost;
}

/// One that went far away because another was first takes the place that it would have alone, where
/// the others find places that are better together.
void make_room(const std::vector<Dimension>& list, const std::vector<std::size_t>& order,
               DimensionGround& ground) {
  constexpr double kMuchWorse = 8;  // paper mm
  constexpr std::size_t kMostInTheWay = 3;
  // It looks at all pairs for each: beyond that many nobody would wait for it.
  constexpr std::size_t kMost = 60;
  if (order.size() > kMost) return;
  for (std::size_t k = 0; k < order.size(); ++k) {
    std::vector<DimensionPlace> before = ground.laid;
    ground.own = k;
    ground.alone = true;
    DimensionPlace alone = place_of(list[order[k]], ground);
    ground.alone = false;
    if (!(before[k].alone - alone.alone > kMuchWorse)) continue;
    const double cost = cost_of_all(ground);
    std::vector<std::size_t> in_the_way;
    for (std::size_t other = 0; other < order.size(); ++other) {
      if (other == k) continue;
      if (conflicts_of(alone.print, before[other].print, 0.9 * ground.step()).hard > 0) {
        in_the_way.push_back(other);
      }
    }
    if (in_the_way.empty() || in_the_way.size() > kMostInTheWay) continue;
    ground.laid[k] = std::move(alone);
    for (const std::size_t other : in_the_way) ground.laid[other] = {};
    for (const std::size_t other : in_the_way) {
      ground.own = other;
      ground.laid[other] = place_of(list[order[other]], ground);
    }
    if (!(cost_of_all(ground) < cost - 1e-6)) ground.laid = std::move(before);
  }
}

}  // namespace
}  // namespace detail

LaidDimensions lay_out(const ViewDimensions& dimensions, const PaperView& view,
                       const DimensionOptions& style, const Drawing* drawn) {
  using namespace detail;
  std::vector<std::vector<Vec2>> beside;
  for (const std::vector<Vec3>& line : dimensions.beside) {
    std::vector<Vec2>& points = beside.emplace_back();
    for (const Vec3& p : line) points.push_back(view.at(p));
  }
  DimensionGround ground{view,
                         style,
                         outline_of(dimensions.about, {}, view),
                         outline_of(dimensions.about, beside, view),
                         std::move(beside),
                         dimensions.taken,
                         dimensions.over_it,
                         dimensions.within,
                         drawn};
  const std::vector<std::size_t> order = order_of(dimensions.list, view);
  constexpr std::size_t kMany = 40;
  ground.many = order.size() > kMany;
  for (const std::size_t i : order) {
    ground.own = ground.laid.size();
    ground.laid.push_back(place_of(dimensions.list[i], ground));
  }
  // Those that came later may lie on the numbers of those before: these find other places.
  constexpr int kMostRounds = 4;
  for (int round = 0; round < (ground.many ? 1 : kMostRounds); ++round) {
    bool moved = false;
    for (std::size_t k = 0; k < order.size(); ++k) {
      ground.own = k;
      const int hard = ground.conflicts(ground.laid[k]).hard;
      if (hard == 0) continue;
      DimensionPlace other = place_of(dimensions.list[order[k]], ground);
      if (ground.conflicts(other).hard >= hard) continue;
      ground.laid[k] = std::move(other);
      moved = true;
    }
    if (!moved) break;
  }
  make_room(dimensions.list, order, ground);
  std::vector<Layer> layers(order.size());
  LaidDimensions out;
  for (std::size_t k = 0; k < order.size(); ++k) {
    layers[order[k]] = std::move(ground.laid[k].layer);
    for (const Area& area : ground.laid[k].areas) {
      for (const std::vector<Vec2>& ring : area.rings) {
        for (const Vec2& p : ring) out.box.add(p);
      }
      out.areas.push_back(area);
    }
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const bool note = dimensions.list[i].kind == Dimension::Kind::Note;
    Layer& to = note ? out.notes : out.layer;
    for (Path& path : layers[i].paths) {
      for (const Vec2& p : path.points) out.box.add(p);
      to.paths.push_back(std::move(path));
    }
    for (Text& text : layers[i].texts) {
      out.box.add(text_box(text));
      to.texts.push_back(std::move(text));
    }
  }
  return out;
}

}  // namespace burin
