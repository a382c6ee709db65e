#include "dxf_entities.h"

#include <burin/drawing/color.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/text.h>

#include <array>
#include <cmath>
#include <numbers>

namespace burin::dxf {
namespace {

/// The line weights that DXF knows, in 1/100 mm; all widths of ISO 128 are among them.
constexpr std::array kWeights{0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                              53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};

/// Decimals of angles and ratios, which are multiplied by a radius.
constexpr int kExact = 12;
/// Of the tolerance of curves: how far the points of one may be from an arc.
constexpr double kShareOfPoints = 0.1;

/// Strokes carry tone: their exact width counts. Other lines have a weight, as CAD knows it.
bool has_true_width(const Path& path) {
  return path.kind == LineClass::Stroke || path.kind == LineClass::Pattern ||
         has_varying_width(path);
}

/// The head of an entity, up to its own data.
void append_entity(Groups& out, const char* kind, const char* type, const Item& item,
                   std::uint64_t handle) {
  out.text(0, kind).handle(5, handle).handle(330, Fixed::ModelSpace).text(100, "AcDbEntity");
  out.text(8, item.layer->name);
  const auto color = rgb_of(item.area   ? item.area->fill
                            : item.path ? item.path->color
                                        : std::string());
  const int number = !color      ? item.layer->color
                     : item.area ? nearest_of_all_colors(*color)
                                 : nearest_color(*color);
  if (number != item.layer->color) out.whole(62, number);
  const int weight = item.path ? weight_of(*item.path) : item.layer->weight;
  if (weight != item.layer->weight) out.whole(370, weight);
  out.text(100, type);
}

void append_source(Groups& out, const Path& path) {
  out.text(1001, kApplication).text(1000, to_string(path.kind));
  out.whole(1071, path.source.part).whole(1071, path.source.face).whole(1071, path.source.edge);
}

/// The points of a path that its shape, and the width along it, need; z = half the width. A closed
/// path does not repeat its first point, no two neighbours are the same.
std::vector<Vec3> thinned(const Path& path, bool widths, double tolerance) {
  const bool varies = widths && path.width.size() == path.points.size();
  const double constant = widths ? 0.5 * mean_width(path) : 0;
  std::vector<Vec3> all;
  all.reserve(path.points.size() + 1);
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    all.emplace_back(path.points[i], varies ? 0.5 * path.width[i] : constant);
  }
  if (path.closed) all.push_back(all.front());
  std::vector<Vec3> kept;
  for (const std::size_t i : simplify(all, tolerance)) {
    if (kept.empty() || Vec2(kept.back()) != Vec2(all[i])) kept.push_back(all[i]);
  }
  while (path.closed && kept.size() > 1 && Vec2(kept.back()) == Vec2(kept.front())) {
    kept.pop_back();
  }
  return kept;
}

void append_polyline(Groups& out, const Item& item, const std::vector<Vec3>& points,
                     std::uint64_t handle) {
  constexpr int kClosed = 1, kDashesGoOn = 128;
  append_entity(out, "LWPOLYLINE", "AcDbPolyline", item, handle);
  const bool closed = item.path->closed && points.size() > 2;
  out.whole(90, static_cast<std::int64_t>(points.size()));
  out.whole(70, (closed ? kClosed : 0) + (item.layer->linetype != kContinuous ? kDashesGoOn : 0));
  const bool widths = has_true_width(*item.path);
  const bool varies = has_varying_width(*item.path);
  if (!varies) out.real(43, widths ? 2 * points[0].z : 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    out.point(10, Vec2(points[i]));
    if (!varies) continue;
    const std::size_t next = i + 1 < points.size() ? i + 1 : closed ? 0 : i;
    out.real(40, 2 * points[i].z).real(41, 2 * points[next].z);
  }
}

/// A dot is a ring without a hole: two half circles of a quarter of its width, drawn half as wide.
void append_dot(Groups& out, const Item& item, std::uint64_t handle) {
  constexpr int kClosed = 1;
  const Path& path = *item.path;
  const double width = mean_width(path);
  const Vec2 middle = 0.5 * (path.points.front() + path.points.back()), side(0.25 * width, 0);
  append_entity(out, "LWPOLYLINE", "AcDbPolyline", item, handle);
  out.whole(90, 2).whole(70, kClosed).real(43, 0.5 * width);
  for (const Vec2 p : {middle - side, middle + side}) out.point(10, p).real(42, 1);
}

/// CIRCLE, ARC or ELLIPSE. DXF has arcs anticlockwise.
void append_arc(Groups& out, const Item& item, const ConicArc& arc, std::uint64_t handle) {
  const double first = arc.turn > 0 ? arc.begin : arc.begin + arc.turn;
  const double last = first + std::abs(arc.turn);
  if (!arc.is_circle()) {
    append_entity(out, "ELLIPSE", "AcDbEllipse", item, handle);
    out.point(10, Vec3(arc.center, 0)).point(11, Vec3(arc.major, 0)).point(210, Vec3(0, 0, 1));
    out.real(40, arc.ratio, kExact);
    constexpr double kTurn = 2 * std::numbers::pi;
    const double begin = arc.is_whole() ? 0 : first - kTurn * std::floor(first / kTurn);
    out.real(41, begin, kExact);
    out.real(42, arc.is_whole() ? kTurn : begin + last - first, kExact);
    return;
  }
  append_entity(out, arc.is_whole() ? "CIRCLE" : "ARC", "AcDbCircle", item, handle);
  out.point(10, Vec3(arc.center, 0)).real(40, arc.radius());
  if (arc.is_whole()) return;
  const double along = std::atan2(arc.major.y, arc.major.x);
  const auto degrees = [&](double t) {
    const double a = (t + along) * 180 / std::numbers::pi;
    return a - 360 * std::floor(a / 360);
  };
  out.text(100, "AcDbArc").real(50, degrees(first), kExact).real(51, degrees(last), kExact);
}

/// A chain of cubics as one B-spline: its control points are theirs, knots at joints are threefold.
void append_spline(Groups& out, const Item& item, const std::vector<CubicBezier>& chain,
                   std::uint64_t handle) {
  constexpr int kPlanar = 8;
  append_entity(out, "SPLINE", "AcDbSpline", item, handle);
  const auto n = static_cast<std::int64_t>(chain.size());
  out.point(210, Vec3(0, 0, 1)).whole(70, kPlanar).whole(71, 3);
  out.whole(72, 3 * n + 5).whole(73, 3 * n + 1).whole(74, 0);
  out.real(42, 0.000001).real(43, 0.000001);
  for (std::int64_t knot = 0; knot <= n; ++knot) {
    const int times = knot == 0 || knot == n ? 4 : 3;
    for (int i = 0; i < times; ++i) out.real(40, static_cast<double>(knot));
  }
  out.point(10, Vec3(chain.front()[0], 0));
  for (const CubicBezier& c : chain) {
    for (std::size_t i = 1; i < 4; ++i) out.point(10, Vec3(c[i], 0));
  }
}

void append_line(Groups& out, const Item& item, const Chosen& options, std::uint64_t handle) {
  const Path& path = *item.path;
  const double tolerance = options.svg.fit_tolerance;
  const bool true_width = has_true_width(path);
  std::vector<CubicBezier> chain;
  if (options.dxf.splines && !true_width) chain = fit_cubics(path.points, path.closed, tolerance);
  const bool curved = std::any_of(chain.begin(), chain.end(), [&](const CubicBezier& c) {
    return !is_straight(c, 0.1 * tolerance);
  });
  if (curved) {
    append_spline(out, item, chain, handle);
    return append_source(out, path);
  }
  if (is_dot(path)) {
    append_dot(out, item, handle);
    return append_source(out, path);
  }
  const std::vector<Vec3> points = thinned(path, true_width, tolerance);
  if (points.size() < 2) {
    append_entity(out, "POINT", "AcDbPoint", item, handle);
    out.point(10, Vec3(Vec2(points[0]), 0));
  } else if (points.size() == 2 && !true_width) {
    append_entity(out, "LINE", "AcDbLine", item, handle);
    out.point(10, Vec3(Vec2(points[0]), 0)).point(11, Vec3(Vec2(points[1]), 0));
  } else {
    append_polyline(out, item, points, handle);
  }
  append_source(out, path);
}

void append_path(Groups& out, const Item& item, const Chosen& options) {
  if (item.pieces.empty()) return append_line(out, item, options, item.handle);
  std::uint64_t handle = item.handle;
  for (const CurvePiece& piece : item.pieces) {
    if (piece.arc) {
      append_arc(out, item, *piece.arc, handle++);
      append_source(out, *item.path);
      continue;
    }
    Path between = without_points(*item.path);
    between.points = piece.points;
    between.width = {mean_width(*item.path)};
    append_line(out, {&between, item.layer}, options, handle++);
  }
}

/// Text as DXF writes it: characters beyond ASCII by their numbers, "%%" and control characters by
/// what they are not taken for.
std::string plain_text(std::string_view text) {
  std::string out;
  for (const char32_t c : code_points(text)) {
    const auto coded = [&](char32_t unit) {
      out += fmt::format("\\U+{:04X}", static_cast<unsigned>(unit));
    };
    if (c < 0x20) {
      out += ' ';
    } else if (c < 0x7F && c != '%' && c != '\\' && c != '^') {
      out += static_cast<char>(c);
    } else if (c < 0x10000) {
      coded(c);
    } else {
      coded(0xD800 + ((c - 0x10000) >> 10));
      coded(0xDC00 + ((c - 0x10000) & 0x3FF));
    }
  }
  return out;
}

void append_text(Groups& out, const Item& item, std::uint64_t handle) {
  const Text& text = *item.text;
  append_entity(out, "TEXT", "AcDbText", item, handle);
  out.point(10, Vec3(text.at, 0)).real(40, text.height).text(1, plain_text(text.text));
  if (text.turn != 0) out.real(50, text.turn);
  out.whole(72, static_cast<int>(text.anchor)).point(11, Vec3(text.at, 0));
  out.text(100, "AcDbText");
}

/// HATCH, solid, with the rings as closed polylines; what is in an odd number of them is filled.
void append_area(Groups& out, const Item& item) {
  constexpr int kExternalPolyline = 3;
  append_entity(out, "HATCH", "AcDbHatch", item, item.handle);
  out.point(10, Vec3(0)).point(210, Vec3(0, 0, 1)).text(2, "SOLID").whole(70, 1).whole(71, 0);
  out.whole(91, static_cast<std::int64_t>(item.area->rings.size()));
  for (const std::vector<Vec2>& ring : item.area->rings) {
    out.whole(92, kExternalPolyline).whole(72, 0).whole(73, 1);
    out.whole(93, static_cast<std::int64_t>(ring.size()));
    for (const Vec2& p : ring) out.point(10, p);
    out.whole(97, 0);
  }
  out.whole(75, 0).whole(76, 1).whole(98, 0);
  out.text(1001, kApplication).text(1000, "Area");
  out.whole(1071, item.area->part).whole(1071, item.area->face).whole(1071, item.area->tone);
}

}  // namespace

int weight_of(const Path& path) {
  const double width = 100 * mean_width(path);
  return *std::min_element(kWeights.begin(), kWeights.end(),
                           [&](int a, int b) { return std::abs(a - width) < std::abs(b - width); });
}

std::vector<CurvePiece> pieces_of(const Path& path, const Chosen& options) {
  if (!options.dxf.arcs || has_true_width(path) || is_dot(path) || path.points.size() < 4)
    return {};
  const double tolerance = options.svg.fit_tolerance;
  const ArcOptions how{kShareOfPoints * tolerance, tolerance, true};
  std::vector<CurvePiece> pieces;
  if (path.closed && options.dxf.order == LineOrder::Travel) {
    // It begins where the pen comes to it.
    std::vector<Vec2> ring = path.points;
    ring.push_back(ring.front());
    pieces = fit_arcs(ring, false, how);
  } else {
    pieces = fit_arcs(path.points, path.closed, how);
  }
  const bool any =
      std::ranges::any_of(pieces, [](const CurvePiece& p) { return p.arc.has_value(); });
  return any ? pieces : std::vector<CurvePiece>();
}

bool is_whole_arc(const Path& ring, const Chosen& options) {
  const std::vector<CurvePiece> pieces = pieces_of(ring, options);
  return pieces.size() == 1 && pieces[0].arc && pieces[0].arc->is_whole();
}

void append(Groups& out, const Item& item, const Chosen& options) {
  if (item.text) return append_text(out, item, item.handle);
  if (item.area) return append_area(out, item);
  append_path(out, item, options);
}

}  // namespace burin::dxf
