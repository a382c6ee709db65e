#include "hpgl.h"

#include <burin/drawing/text.h>

#include "hpgl_options.h"
#include "own_formats.h"
#include "pen_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>

namespace burin {
namespace {

constexpr double kUnitsPerMm = 40;
constexpr double kPi = std::numbers::pi;
/// Places of one PD, so that no line of the file is longer than programs read.
constexpr std::size_t kPlacesOfOne = 32;

struct Place {
  std::int64_t x = 0, y = 0;

  bool operator==(const Place&) const = default;
};

Place place(Vec2 p) { return {std::llround(p.x * kUnitsPerMm), std::llround(p.y * kUnitsPerMm)}; }

void append_down(Buffer& out, const std::vector<Place>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    append(out, i % kPlacesOfOne == 0 ? "PD" : ",");
    fmt::format_to(fmt::appender(out), "{},{}", places[i].x, places[i].y);
    if ((i + 1) % kPlacesOfOne == 0 || i + 1 == places.size()) append(out, ";\n");
  }
}

/// AA: an arc about a whole centre, from where the pen is.
struct WholeArc {
  Place center;
  double degrees = 0;
  int chord = 1;  // degrees
  Vec2 end{0};    // units
};

/// The arc of whole numbers that is nearest to one, which begins at a place in units; nothing where
/// it would be too far off.
std::optional<WholeArc> whole_arc(const CurvePiece& piece, Vec2 from) {
  constexpr double kFarthest = 0.022 * kUnitsPerMm, kChordOff = 0.002 * kUnitsPerMm;
  constexpr double kMostChordOff = 0.004 * kUnitsPerMm, kRange = 32767, kToDegrees = 180 / kPi;
  const ConicArc& arc = *piece.arc;
  const double radius = arc.radius() * kUnitsPerMm;
  const double chord = std::clamp(
      std::floor(2 * kToDegrees * std::acos(std::max(1 - kChordOff / radius, -1.0))), 1.0, 45.0);
  if (radius * (1 - std::cos(0.5 * chord / kToDegrees)) > kMostChordOff) return std::nullopt;
  const Place middle = place(arc.center);
  const Vec2 end = piece.end() * kUnitsPerMm;
  std::optional<WholeArc> best;
  double least = kFarthest;
  for (std::int64_t k = 0; k < 9; ++k) {
    const Place c{middle.x + k / 3 - 1, middle.y + k % 3 - 1};
    const Vec2 center(static_cast<double>(c.x), static_cast<double>(c.y));
    if (std::max(std::abs(center.x), std::abs(center.y)) > kRange) continue;
    const Vec2 a = from - center, b = end - center;
    double turn = std::atan2(cross2(a, b), glm::dot(a, b));
    turn += 2 * kPi * std::round((arc.turn - turn) / (2 * kPi));
    if (arc.is_whole()) turn = arc.turn;
    const double degrees = std::round(turn * kToDegrees * 1000) / 1000;
    const double t = degrees / kToDegrees, r = glm::length(a);
    const Vec2 to =
        center + Vec2(std::cos(t) * a.x - std::sin(t) * a.y, std::sin(t) * a.x + std::cos(t) * a.y);
    double off = glm::distance(to, end);
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
      const Vec2 p = piece.points[i] * kUnitsPerMm - center;
      off = std::max(off, std::abs(glm::length(p) - r));
      if (i == 0) continue;
      const Vec2 q = piece.points[i - 1] * kUnitsPerMm - center;
      off = std::max(off, std::abs(glm::length(0.5 * (p + q)) - r));
    }
    if (off >= least) continue;
    least = off;
    best = WholeArc{c, degrees, static_cast<int>(chord), to};
  }
  return best;
}

/// What the pen does; places are gathered until something else comes.
class Pencil {
 public:
  explicit Pencil(Buffer& out) : out_(out) {}

  void lift(Vec2 to) {
    stand_at(place(to));
    fmt::format_to(fmt::appender(out_), "PU{},{};\n", last_.x, last_.y);
    down_ = false;
  }

  void go(Vec2 to) {
    if (place(to) == last_) return;
    stand_at(place(to));
    places_.push_back(last_);
  }

  void draw(const CurvePiece& piece) {
    const auto arc = piece.arc ? whole_arc(piece, exact_) : std::nullopt;
    if (!arc) {
      for (const Vec2 p : piece.points) go(p);
      return;
    }
    flush_places();
    if (!down_) append(out_, "PD;\n");
    down_ = true;
    fmt::format_to(fmt::appender(out_), "AA{},{},", arc->center.x, arc->center.y);
    append_fixed(out_, arc->degrees, 3);
    fmt::format_to(fmt::appender(out_), ",{};\n", arc->chord);
    last_ = place(piece.end());
    exact_ = arc->end;
  }

  void finish() {
    // A line shorter than a unit is a dot.
    if (places_.empty() && !down_) places_.push_back(last_);
    flush_places();
  }

 private:
  void stand_at(Place at) {
    last_ = at;
    exact_ = {static_cast<double>(at.x), static_cast<double>(at.y)};
  }
  void flush_places() {
    if (!places_.empty()) down_ = true;
    append_down(out_, places_);
    places_.clear();
  }

  Buffer& out_;
  std::vector<Place> places_;
  Place last_;
  /// Where the pen is, in units: an arc may end between two.
  Vec2 exact_{0};
  bool down_ = false;
};

}  // namespace

void write_hpgl(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                const RunContext& context) {
  const auto hpgl = values_in<HpglOptions>(options.formats);
  const PenPlan plan = plan_pens(drawing, hpgl, HpglOptions::kRow, options, context);
  Buffer text;
  Pencil pen(text);
  append(text, "IN;\n");
  Vec2 before(0);
  for (std::size_t i = 0; i < plan.order.lines.size(); ++i) {
    context.check();
    const PenLine& line = plan.order.lines[i];
    if (i == 0 || line.group != plan.order.lines[i - 1].group) {
      fmt::format_to(fmt::appender(text), "{}SP{};\n", i == 0 ? "" : "PU;\n",
                     plan.pens[line.group].number);
      if (hpgl.speed > 0) {
        append(text, "VS");
        append_fixed(text, hpgl.speed, 1);
        append(text, ";\n");
      }
    }
    const std::vector<CurvePiece> pieces = pen_pieces(line, plan, hpgl.arcs);
    const Vec2 first = pieces.front().start();
    if (!plan.goes_on(i, before, first, hpgl.join)) {
      pen.lift(first);
    } else {
      pen.go(first);
    }
    for (const CurvePiece& piece : pieces) pen.draw(piece);
    pen.finish();
    before = pieces.back().end();
    if (text.size() > kFlushed) flush(text, out);
  }
  append(text, "PU0,0;\nSP0;\n");
  flush(text, out);
}

namespace detail {

Format hpgl_format() {
  return {.name = "hpgl", .keys = {"hpgl."}, .write = write_hpgl, .other_suffixes = {"plt", "hpg"}};
}

}  // namespace detail
}  // namespace burin
