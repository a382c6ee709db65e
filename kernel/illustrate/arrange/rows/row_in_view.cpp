#include "row_in_view.h"

#include <burin/arrange/illustration.h>

#include "row_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace burin::detail {
namespace {

using Kind = DimensionRow::Kind;

/// Sine and share within which a direction lies in the sheet, or across it.
constexpr double kSquare = 1e-6;
/// Degrees of a circle beyond which it is a whole one, for leaders.
constexpr double kWhole = 350;

enum Rank { Best, Second, Hidden, HiddenSecond, Oblique, HiddenOblique };

Rank rank_of(bool square, bool seen) {
  return square ? (seen ? Best : Hidden) : (seen ? Oblique : HiddenOblique);
}

struct Shown {
  const MeasuredRow& row;
  const MeasuringView& view;
  const FeatureSight& sight;
  Vec3 to_viewer() const { return glm::transpose(view.axes)[2]; }
  bool in_sheet(Vec3 along) const { return std::abs(glm::dot(along, to_viewer())) < kSquare; }
  bool end_on(Vec3 along) const { return glm::length(glm::cross(along, to_viewer())) < kSquare; }
  /// Whether the view is along none of the axes of space nor across one, so that what is written
  /// along them is not taken for what is seen.
  bool pictorial() const {
    const Vec3 w = glm::abs(to_viewer());
    return std::min({w.x, w.y, w.z}) > kSquare;
  }
  bool seen(std::size_t feature) const {
    const auto& surface = row.there[view.scene][feature];
    return !surface || sight.shows({*surface, row.of[feature], row.row.of[feature].kind, row.moved,
                                    row.parts[feature]},
                                   to_viewer());
  }
  bool all_seen() const {
    for (std::size_t k = 0; k < row.of.size(); ++k) {
      if (!seen(k)) return false;
    }
    return true;
  }
};

/// Numbers in a text with the sign before their decimals that others have.
std::string with_sign(std::string text, const DimensionOptions& style) {
  if (style.sign != DimensionOptions::Sign::Comma) return text;
  const auto digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '.' && digit(i - 1) && digit(i + 1)) text[i] = ',';
  }
  return text;
}

const char* sign_of(const MeasuredRow& row) {
  const bool sphere = row.of.front().kind == FeatureKind::Sphere;
  if (row.row.kind == Kind::Diameter) return sphere ? "S\u2300" : "\u2300";
  if (row.row.kind == Kind::Radius) return sphere ? "SR" : "R";
  return "";
}

/// `end_on`: a depth that is seen along the hole has its diameter before it.
void write(const MeasuredRow& row, const DimensionOptions& sheet, bool end_on, Dimension& out) {
  const DimensionOptions style = style_of(row.row, sheet);
  const std::string value =
      row.row.kind == Kind::Angle ? angle_text(row.value, style) : dimension_text(row.value, style);
  out.text = row.row.text.empty() ? sign_of(row) + value : replaced(row.row.text, "{value}", value);
  if (row.row.kind == Kind::Depth && end_on && row.row.text.empty()) {
    out.text = "\u2300" + dimension_text(2 * row.of.front().radius, style) + " \u21a7 " + value;
  }
  if (!row.row.tolerance.empty()) out.text += " " + with_sign(row.row.tolerance, style);
  out.upper = with_sign(row.row.upper, style);
  out.lower = with_sign(row.row.lower, style);
}

std::vector<Vec3> moved(std::vector<Vec3> points, Vec3 by) {
  for (Vec3& p : points) p += by;
  return points;
}

/// Whether an axis leans to the viewer, so that the view shows one of its ends.
bool leans(const Feature& f, const Shown& shown) {
  return f.has_axis() && !shown.in_sheet(f.along) && !shown.end_on(f.along);
}

/// The end of a turned face that is nearer to the viewer, from `Feature::point` along its axis.
double near_end(const Feature& f, const Shown& shown) {
  return glm::dot(f.along, shown.to_viewer()) >= 0 ? f.high : f.low;
}

/// Where a distance ends at a feature: of an axis that leans at the end that is seen.
Vec3 end_at(const Feature& f, Vec3 at, const Shown& shown) {
  if (!leans(f, shown)) return at;
  return at + (near_end(f, shown) - glm::dot(at - f.point, f.along)) * f.along;
}

/// Points at which extension lines may begin: of an axis its ends, or where its centre mark ends.
std::vector<Vec3> starts_of(const Feature& f, Vec3 at, Vec3 along, const Shown& shown) {
  if (!f.has_axis()) return f.kind == FeatureKind::Sphere ? std::vector{f.point} : f.points;
  if (leans(f, shown)) return {end_at(f, at, shown)};
  if (shown.end_on(f.along) && shown.view.centre_lines) {
    const Vec3 side = f.radius * glm::cross(shown.to_viewer(), along);
    return {at - side, at, at + side};
  }
  return {at + (f.low - glm::dot(at - f.point, f.along)) * f.along,
          at + (f.high - glm::dot(at - f.point, f.along)) * f.along};
}

/// Along the axes of space both ends are side by side: an axis goes on to where the other feature
/// has points. Not into its part, where it is hidden, unless it meets nothing else.
void reach_beside(const Shown& shown, Dimension& one) {
  const auto reach = [&](const Feature& axis, std::vector<Vec3>& points, const Feature& other,
                         const std::vector<Vec3>& others) {
    if (!axis.has_axis() || others.empty()) return;
    const Vec3 at = axis.point + shown.row.moved;
    const Vec3 out = glm::dot(axis.along, shown.to_viewer()) >= 0 ? axis.along : -axis.along;
    const auto height = [&](const Vec3& p) { return glm::dot(p - at, out); };
    const double end = leans(axis, shown) ? height(at + near_end(axis, shown) * axis.along)
                                          : -std::numeric_limits<double>::infinity();
    // As `ends_of` in the layout: what is that near is beside each other.
    const double near = 1e-6 * shown.row.distance.length;
    const double most = height(*std::ranges::max_element(others, {}, height));
    const double least = other.has_axis() ? end : std::min(end, most);
    for (const Vec3& p : others) {
      if (height(p) >= least - near) points.push_back(at + height(p) * out);
    }
  };
  const std::vector<Vec3> from = one.from_points, to = one.to_points;
  reach(shown.row.of[0], one.from_points, shown.row.of[1], to);
  reach(shown.row.of[1], one.to_points, shown.row.of[0], from);
}

std::optional<RowInView> distance_in(const Shown& shown) {
  const MeasuredDistance& d = shown.row.distance;
  RowInView out;
  const bool square = shown.in_sheet(d.along);
  if (!square && (!shown.pictorial() || shown.end_on(d.along))) return std::nullopt;
  const Vec3 by = shown.row.moved;
  out.rank = rank_of(square, shown.all_seen());
  Dimension& one = out.dimension;
  one.from = end_at(shown.row.of[0], d.from, shown) + by;
  // What lies across the distance is where extension lines begin, not where the line ends.
  one.to = one.from + d.length * d.along;
  one.from_points = moved(starts_of(shown.row.of[0], d.from, d.along, shown), by);
  one.to_points = moved(starts_of(shown.row.of[1], d.to, d.along, shown), by);
  if (!square) reach_beside(shown, one);
  return out;
}

/// The middle of an arc, from its centre, as long as the radius.
Vec3 middle_of(const Feature& f, Vec3 axis, Vec3 center) {
  Vec3 sum(0);
  for (const Vec3& p : f.points) {
    const Vec3 across = reject(p - center, axis);
    if (glm::length(across) > 0) sum += glm::normalize(across);
  }
  const bool whole =
      f.turn > kWhole || !(glm::length(sum) > 0.01 * static_cast<double>(f.points.size()));
  return f.radius * (whole ? any_orthogonal(axis) : glm::normalize(reject(sum, axis)));
}

/// A leader to a circle across an axis.
Dimension round(Vec3 center, Vec3 axis, Vec3 out, double sweep) {
  Dimension one;
  one.kind = Dimension::Kind::Round;
  one.from = center;
  one.to = center + out;
  one.other = axis;
  one.sweep = sweep;
  return one;
}

/// The middle of a turned face at the end that is nearer to the viewer.
Vec3 near_middle(const Feature& f, const Shown& shown) {
  return f.point + near_end(f, shown) * f.along + shown.row.moved;
}

/// A leader ends where the rim of a hole, or of what stands out, is seen.
void end_where_seen(const Shown& shown, Dimension& round) {
  const Feature& f = shown.row.of.front();
  const Vec3 ahead = glm::dot(f.along, shown.to_viewer()) < 0 ? -f.along : f.along;
  for (const Vec3& p : points_of_round(round)) {
    const Vec3 out = glm::normalize(p - round.from);
    const Vec3 way = glm::normalize(ahead + (f.hollow ? -out : out));
    if (shown.sight.shows_place(p, way, shown.to_viewer())) round.from_points.push_back(p);
  }
}

Dimension across_axis(const Feature& f, const Shown& shown) {
  Dimension one;
  const Vec3 out = f.radius * glm::normalize(glm::cross(f.along, shown.to_viewer()));
  const Vec3 low = f.point + f.low * f.along + shown.row.moved,
             high = f.point + f.high * f.along + shown.row.moved;
  one.from = 0.5 * (low + high) - out;
  one.to = 0.5 * (low + high) + out;
  one.from_points = {low - out, high - out};
  one.to_points = {low + out, high + out};
  if (f.kind == FeatureKind::Cone || f.kind == FeatureKind::Turned) {
    // The largest circle alone is that wide.
    const auto widest = std::ranges::max_element(
        f.points, {}, [&](const Vec3& p) { return glm::length(reject(p - f.point, f.along)); });
    const Vec3 at = f.point + glm::dot(*widest - f.point, f.along) * f.along + shown.row.moved;
    one.from = at - out;
    one.to = at + out;
    one.from_points = {one.from};
    one.to_points = {one.to};
  }
  return one;
}

std::optional<RowInView> sphere_in(const Shown& shown) {
  const Feature& f = shown.row.of.front();
  RowInView out;
  const Vec3 w = shown.to_viewer(), center = f.point + shown.row.moved;
  out.dimension = round(center, w, middle_of(f, w, f.point), f.turn > kWhole ? 360 : 60);
  out.rank = shown.seen(0) ? Best : Hidden;
  return out;
}

std::optional<RowInView> diameter_in(const Shown& shown) {
  const Feature& f = shown.row.of.front();
  if (f.kind == FeatureKind::Sphere) return sphere_in(shown);
  RowInView out;
  const bool seen = shown.seen(0);
  if (shown.end_on(f.along) || shown.pictorial()) {
    const bool oblique = !shown.end_on(f.along);
    out.dimension = round(near_middle(f, shown), f.along, middle_of(f, f.along, f.point),
                          f.turn > kWhole ? 360 : f.turn);
    if (oblique) end_where_seen(shown, out.dimension);
    out.rank = oblique ? (seen ? Oblique : HiddenOblique)
               : seen  ? (f.hollow || f.kind == FeatureKind::Circle ? Best : Second)
                       : HiddenSecond;
    return out;
  }
  if (!shown.in_sheet(f.along)) return std::nullopt;
  out.dimension = across_axis(f, shown);
  const bool flat = f.kind == FeatureKind::Circle;
  out.rank = seen ? (flat ? Second : Best) : Hidden;
  return out;
}

/// The tube of a torus where the axis lies in the sheet: a circle on either side of it.
std::optional<RowInView> tube_in(const Shown& shown) {
  const Feature& f = shown.row.of.front();
  if (!shown.in_sheet(f.along)) return std::nullopt;
  RowInView out;
  const Vec3 w = shown.to_viewer(), side = glm::normalize(glm::cross(f.along, w));
  // Of the profile: from the middle of the tube, away from the axis and along it.
  Vec2 sum(0);
  for (const Vec3& p : f.points) {
    const double rho = glm::length(reject(p - f.point, f.along));
    sum += Vec2(rho - f.ring, glm::dot(p - f.point, f.along));
  }
  sum = glm::length(sum) > 0 ? glm::normalize(sum) : Vec2(1, 0);
  const double sense = glm::dot(Vec2(shown.view.axes * side), {1, 1}) < 0 ? -1 : 1;
  const Vec3 center = f.point + sense * f.ring * side + shown.row.moved;
  out.dimension = round(center, w, f.radius * (sense * sum.x * side + sum.y * f.along), 60);
  out.rank = shown.seen(0) ? Best : Hidden;
  return out;
}

std::optional<RowInView> radius_in(const Shown& shown) {
  const Feature& f = shown.row.of.front();
  if (f.kind == FeatureKind::Sphere) return sphere_in(shown);
  if (f.kind == FeatureKind::Torus) return tube_in(shown);
  const bool square = shown.end_on(f.along);
  if (!square && !shown.pictorial()) return std::nullopt;
  RowInView out;
  out.dimension = round(near_middle(f, shown), f.along, middle_of(f, f.along, f.point), f.turn);
  if (!square) end_where_seen(shown, out.dimension);
  out.rank = rank_of(square, shown.seen(0));
  return out;
}

std::optional<RowInView> depth_in(const Shown& shown, bool& end_on) {
  const Feature& f = shown.row.of.front();
  end_on = !shown.in_sheet(f.along);
  if (end_on) {
    std::optional<RowInView> out = diameter_in(shown);
    if (out && out->rank == Best) out->rank = Second;
    return out;
  }
  RowInView out;
  Dimension& one = out.dimension;
  one = across_axis(f, shown);
  const Vec3 side = 0.5 * (one.to - one.from);
  const Vec3 low = f.point + f.low * f.along + shown.row.moved,
             high = f.point + f.high * f.along + shown.row.moved;
  one.from = low;
  one.to = high;
  one.from_points = {low - side, low + side};
  one.to_points = {high - side, high + side};
  out.rank = shown.seen(0) ? Best : Hidden;
  return out;
}

/// As far out along a side as its feature goes.
Vec3 far_along(const Feature& f, Vec3 vertex, Vec3 along) {
  double most = 0;
  for (const Vec3& p : f.points) most = std::max(most, glm::dot(p - vertex, along));
  if (f.has_axis()) {
    for (const double end : {f.low, f.high})
      most = std::max(most, glm::dot(f.point + end * f.along - vertex, along));
  }
  return vertex + (most > 0 ? most : 1) * along;
}

/// Between opposite sides of a cone, which the view sees from its side.
std::optional<RowInView> cone_angle_in(const Shown& shown) {
  const Feature& f = shown.row.of.front();
  if (!shown.in_sheet(f.along)) return std::nullopt;
  const Vec3 apex = shown.row.angle.vertex;
  const auto height = [&](const Vec3& p) { return std::abs(glm::dot(p - apex, f.along)); };
  const auto [low, high] = std::ranges::minmax_element(f.points, {}, height);
  const Vec3 axis = glm::dot(*high - apex, f.along) < 0 ? -f.along : f.along;
  const Vec3 out = std::tan(glm::radians(0.5 * f.opening)) * glm::cross(axis, shown.to_viewer());
  const auto end = [&](const Vec3& p, Vec3 side) {
    return apex + height(p) * (axis + side) + shown.row.moved;
  };
  RowInView found{.dimension = {.kind = Dimension::Kind::Angle,
                                .from = apex + shown.row.moved,
                                .to = end(*high, out),
                                .other = end(*high, -out)},
                  .rank = shown.seen(0) ? Best : Hidden};
  found.dimension.from_points = {end(*low, out), end(*high, out)};
  found.dimension.to_points = {end(*low, -out), end(*high, -out)};
  return found;
}

std::optional<RowInView> angle_in(const Shown& shown) {
  if (shown.row.of.size() == 1) return cone_angle_in(shown);
  const MeasuredAngle& a = shown.row.angle;
  if (!shown.end_on(glm::normalize(glm::cross(a.first, a.second)))) return std::nullopt;
  RowInView out;
  Dimension& one = out.dimension;
  one.kind = Dimension::Kind::Angle;
  one.from = a.vertex + shown.row.moved;
  one.to = far_along(shown.row.of[0], a.vertex, a.first) + shown.row.moved;
  one.other = far_along(shown.row.of[1], a.vertex, a.second) + shown.row.moved;
  one.from_points = moved(shown.row.of[0].points, shown.row.moved);
  one.to_points = moved(shown.row.of[1].points, shown.row.moved);
  out.rank = shown.all_seen() ? Best : Hidden;
  return out;
}

/// Adds the places of a feature of a note that its leader may end at.
void add_tips(const Shown& shown, std::size_t k, LeaderTarget& target) {
  const MeasuredRow& row = shown.row;
  if (row.parts[k] == MeasuredRow::kNoPart) {
    target.tips.push_back(row.of[k].point);
    target.rooms.push_back(0);
    return;
  }
  const auto& surface = row.there[shown.view.scene][k];
  if (!surface) return;
  const SeenFeature seen{*surface, row.of[k], row.row.of[k].kind, row.moves[k], row.parts[k]};
  for (const SeenPlace& place : shown.sight.seen_places(seen, shown.view.axes)) {
    target.tips.push_back(place.at);
    target.rooms.push_back(place.room);
  }
}

/// Where something is that no part may hide.
void add_hidden_tip(const Shown& shown, std::size_t k, LeaderTarget& target) {
  const auto& surface = shown.row.there[shown.view.scene][k];
  if (!surface) return;
  const Feature& f = shown.row.of[k];
  const std::vector<Vec3>& points = f.points.empty() ? surface->proxy().mesh.positions : f.points;
  if (points.empty()) return;
  const Vec3 at = points[points.size() / 2];
  target.tips.push_back(at + shown.row.moves[k]);
  target.rooms.push_back(0);
}

std::optional<RowInView> note_in(const Shown& shown) {
  const MeasuredRow& row = shown.row;
  RowInView out;
  out.dimension.kind = Dimension::Kind::Note;
  out.dimension.place = row.row.at_sheet;
  out.rank = Best;
  for (std::size_t k = 0; k < row.of.size();) {
    const std::size_t begin = k, of = row.target[k];
    LeaderTarget target{.mark = row.row.mark};
    target.source.part = row.parts[k] == MeasuredRow::kNoPart ? -1 : std::int32_t(row.parts[k]);
    if (row.row.of[k].kind == FeatureRow::Kind::Face) target.source.face = row.of[k].number;
    if (row.row.of[k].kind == FeatureRow::Kind::Edge) target.source.edge = row.of[k].number;
    for (; k < row.of.size() && row.target[k] == of; ++k) add_tips(shown, k, target);
    if (target.tips.empty()) {
      out.rank = Hidden;
      for (std::size_t other = begin; other < k; ++other) add_hidden_tip(shown, other, target);
    }
    if (target.tips.empty()) return std::nullopt;  // cut away
    const bool narrow = row.row.of[begin].kind == FeatureRow::Kind::Face &&
                        !(*std::ranges::max_element(target.rooms) > 0);
    if (out.rank == Best && narrow) out.rank = Second;
    out.dimension.targets.push_back(std::move(target));
  }
  return out;
}

}  // namespace

std::optional<RowInView> row_in_view(const MeasuredRow& row, const MeasuringView& view,
                                     const FeatureSight& sight, const DimensionOptions& style) {
  const Shown shown{row, view, sight};
  if (row.row.kind == Kind::Note) {
    std::optional<RowInView> note = note_in(shown);
    if (!note) return note;
    note->seen = note->rank != Hidden;
    return note;
  }
  for (std::size_t k = 0; k < row.of.size(); ++k) {
    const bool point = row.parts[k] == MeasuredRow::kNoPart;
    if (!point && !row.there[view.scene][k]) return std::nullopt;  // cut away
  }
  bool end_on = false;
  std::optional<RowInView> out;
  switch (row.row.kind) {
    case Kind::Note:
      break;
    case Kind::Distance:
      out = distance_in(shown);
      break;
    case Kind::Diameter:
    case Kind::Thread:
      out = diameter_in(shown);
      break;
    case Kind::Radius:
      out = radius_in(shown);
      break;
    case Kind::Angle:
      out = angle_in(shown);
      break;
    case Kind::Depth:
      out = depth_in(shown, end_on);
      break;
  }
  if (!out) return out;
  write(row, style, end_on, out->dimension);
  out->seen = out->rank == Best || out->rank == Second || out->rank == Oblique;
  return out;
}

}  // namespace burin::detail
