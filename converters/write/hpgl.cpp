#include "hpgl.h"

#include <burin/drawing/text.h>

#include "pen_plan.h"

#include <cmath>
#include <ostream>

namespace burin {
namespace {

constexpr double kUnitsPerMm = 40;
/// Places of one PD, so that no line of the file is longer than programs read.
constexpr std::size_t kPlacesOfOne = 32;
constexpr std::size_t kFlushed = 1 << 16;  // bytes

struct Place {
  std::int64_t x = 0, y = 0;

  bool operator==(const Place&) const = default;
};

Place place(Vec2 p) { return {std::llround(p.x * kUnitsPerMm), std::llround(p.y * kUnitsPerMm)}; }

void flush(Buffer& text, std::ostream& out) {
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  text.clear();
}

void append_down(Buffer& out, const std::vector<Place>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    append(out, i % kPlacesOfOne == 0 ? "PD" : ",");
    fmt::format_to(fmt::appender(out), "{},{}", places[i].x, places[i].y);
    if ((i + 1) % kPlacesOfOne == 0 || i + 1 == places.size()) append(out, ";\n");
  }
}

}  // namespace

void write_hpgl(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                const RunContext& context) {
  const PenPlan plan = plan_pens(drawing, options.hpgl, "hpgl.", options, context);
  Buffer text;
  append(text, "IN;\n");
  Vec2 before(0);
  for (std::size_t i = 0; i < plan.order.lines.size(); ++i) {
    context.check();
    const PenLine& line = plan.order.lines[i];
    if (i == 0 || line.group != plan.order.lines[i - 1].group) {
      fmt::format_to(fmt::appender(text), "{}SP{};\n", i == 0 ? "" : "PU;\n",
                     plan.pens[line.group].number);
      if (options.hpgl.speed > 0) {
        append(text, "VS");
        append_fixed(text, options.hpgl.speed, 1);
        append(text, ";\n");
      }
    }
    std::vector<Vec2> points = points_of(line, plan.order, plan.paths);
    if (line.closed) points.push_back(points.front());
    std::vector<Place> places;
    if (!plan.goes_on(i, before, points.front(), options.hpgl.join)) {
      const Place first = place(points.front());
      fmt::format_to(fmt::appender(text), "PU{},{};\n", first.x, first.y);
    } else if (place(points.front()) != place(before)) {
      places.push_back(place(points.front()));
    }
    Place last = place(points.front());
    for (const Vec2 p : points) {
      if (place(p) == last) continue;
      last = place(p);
      places.push_back(last);
    }
    // A line shorter than a unit is a dot.
    if (places.empty()) places.push_back(last);
    append_down(text, places);
    before = points.back();
    if (text.size() > kFlushed) flush(text, out);
  }
  append(text, "PU0,0;\nSP0;\n");
  flush(text, out);
}

}  // namespace burin
