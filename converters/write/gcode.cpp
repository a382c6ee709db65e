#include "gcode.h"

#include <burin/drawing/text.h>
#include <burin/drawing/title.h>

#include "gcode_options.h"
#include "own_formats.h"
#include "pen_plan.h"

#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <ostream>

namespace burin {
namespace {

constexpr int kDecimals = 3;
constexpr double kHalfTurn = std::numbers::pi * (1 - 1e-6);

/// For a comment: one line of printable ASCII.
std::string plain_comment(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 120)) out += c >= ' ' && c <= '~' ? c : '?';
  return out;
}

std::string number(double value) {
  Buffer out;
  append_fixed(out, value, kDecimals);
  return fmt::to_string(out);
}

/// The commands of a text, a line each.
std::string commands(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    std::string_view one = text.substr(0, text.find(';'));
    text.remove_prefix(std::min(one.size() + 1, text.size()));
    while (one.starts_with(' ')) one.remove_prefix(1);
    while (one.ends_with(' ')) one.remove_suffix(1);
    if (!one.empty()) lines += std::string(one) + "\n";
  }
  return lines;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

class Writer {
 public:
  Writer(const Drawing& drawing, const GcodeOptions& options, const PenPlan& plan)
      : drawing_(drawing), options_(options), plan_(plan) {
    const bool laser = options.tool == GcodeOptions::Tool::Laser;
    const std::string feed = " F" + number(options.feed);
    down_ = commands(!options.down.empty() ? options.down
                     : laser               ? "M3 S" + number(options.power)
                                           : "G1 Z" + number(options.z_down) + feed);
    up_ = commands(!options.up.empty() ? options.up : laser ? "M5" : "G0 Z" + number(options.z_up));
    if (options.origin == GcodeOptions::Origin::Middle) {
      zero_ = 0.5 * Vec2(drawing.paper_width, drawing.paper_height);
    }
  }

  void head(Buffer& out) const {
    append(out, fmt::format("; {}: {}, {}\n", creator(), plain_comment(title_of(drawing_)),
                            plain_comment(subject_of(drawing_))));
    append(out, fmt::format("; sheet {:g} x {:g} mm, zero {}\n", drawing_.paper_width,
                            drawing_.paper_height,
                            zero_ == Vec2(0) ? "at its lower left corner" : "in its middle"));
    for (const Pen& pen : plan_.pens) append(out, "; " + described(pen) + "\n");
    append(out, fmt::format("; {} lines, {:.0f} mm drawn, {:.0f} mm of travel\n",
                            plan_.order.lines.size(), plan_.order.drawn, plan_.order.travel));
    append(out, (options_.arcs ? "G21\nG90\nG17\n" : "G21\nG90\n") + up_);
  }

  void line(std::size_t i, Buffer& out) {
    const PenLine& line = plan_.order.lines[i];
    const std::vector<CurvePiece> pieces = pen_pieces(line, plan_, options_.arcs);
    const Vec2 first = pieces.front().start();
    const bool goes_on = plan_.goes_on(i, before_, first, options_.join);
    if (!goes_on) lift(out);
    if (i > 0 && line.group != plan_.order.lines[i - 1].group) change_to(line.group, out);
    Place last = place(before_);
    if (!goes_on) {
      last = place(first);
      append_place(out, "G0", last, options_.travel_feed);
      append(out, down_);
      is_down_ = true;
      fast_ = true;
    }
    bool moved = false;
    const auto go_to = [&](Vec2 p) {
      if (place(p) == last) return;
      last = place(p);
      append_place(out, "G1", last, fast_ ? options_.feed : 0);
      fast_ = false;
      moved = true;
    };
    for (const CurvePiece& piece : pieces) {
      if (!piece.arc) {
        for (const Vec2 p : piece.points) go_to(p);
        continue;
      }
      go_to(piece.start());
      // Half of a turn at most: none is so nearly whole that its ends round to one place.
      const int parts = std::abs(piece.arc->turn) > kHalfTurn ? 2 : 1;
      for (int k = 0; k < parts; ++k) moved |= append_arc(*piece.arc, k, parts, last, out);
    }
    // A line shorter than a micrometre is a dot.
    if (!moved && !goes_on) append_place(out, "G1", last, options_.feed);
    before_ = pieces.back().end();
  }

  void tail(Buffer& out) {
    lift(out);
    append_place(out, "G0", {}, options_.travel_feed);
    append(out, "M2\n");
  }

 private:
  struct Place {
    std::int64_t x = 0, y = 0;

    bool operator==(const Place&) const = default;
  };
  Place place(Vec2 p) const {
    return {std::llround(1000 * (p.x - zero_.x)), std::llround(1000 * (p.y - zero_.y))};
  }

  static std::string described(const Pen& pen) {
    return fmt::format("pen {}: {:.2f} mm, {}", pen.number, pen.width,
                       plain_comment(fmt::format("{}", fmt::join(pen.layers, ", "))));
  }

  /// `feed`: mm a minute, 0: as before.
  static void append_place(Buffer& out, const char* command, Place to, double feed) {
    append(out, command);
    append(out, " X");
    append_scaled(out, to.x, kDecimals);
    append(out, " Y");
    append_scaled(out, to.y, kDecimals);
    if (feed > 0) append(out, " F" + number(feed));
    append(out, "\n");
  }

  /// One of equal parts of an arc; whether it moves the pen.
  bool append_arc(const ConicArc& arc, int part, int parts, Place& last, Buffer& out) {
    const Place to = place(arc.at(arc.begin + arc.turn * (part + 1) / parts));
    if (to == last) return false;
    const Place center = place(arc.center);
    append(out, arc.turn > 0 ? "G3 X" : "G2 X");
    append_scaled(out, to.x, kDecimals);
    append(out, " Y");
    append_scaled(out, to.y, kDecimals);
    append(out, " I");
    append_scaled(out, center.x - last.x, kDecimals);
    append(out, " J");
    append_scaled(out, center.y - last.y, kDecimals);
    if (fast_) append(out, " F" + number(options_.feed));
    append(out, "\n");
    fast_ = false;
    last = to;
    return true;
  }

  void lift(Buffer& out) {
    if (is_down_) append(out, up_);
    is_down_ = false;
  }

  void change_to(std::uint32_t group, Buffer& out) const {
    const Pen& pen = plan_.pens[group];
    append(out, "; " + described(pen) + "\n");
    append(out, replaced(commands(options_.pen_change), "{pen}", std::to_string(pen.number)));
  }

  const Drawing& drawing_;
  const GcodeOptions& options_;
  const PenPlan& plan_;
  std::string down_, up_;
  Vec2 zero_{0}, before_{0};
  bool is_down_ = false;
  bool fast_ = true;  // the last feed was that of travelling
};

}  // namespace

void write_gcode(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                 const RunContext& context) {
  const auto gcode = values_in<GcodeOptions>(options.formats);
  GcodeOptions::check(gcode);
  const PenPlan plan = plan_pens(drawing, gcode, GcodeOptions::kRow, options, context);
  Writer writer(drawing, gcode, plan);
  Buffer text;
  writer.head(text);
  for (std::size_t i = 0; i < plan.order.lines.size(); ++i) {
    context.check();
    writer.line(i, text);
    if (text.size() > kFlushed) flush(text, out);
  }
  writer.tail(text);
  flush(text, out);
}

namespace detail {

Format gcode_format() {
  return {.name = "gcode",
          .keys = {"gcode."},
          .write = write_gcode,
          .other_suffixes = {"nc", "ngc", "gco", "tap"}};
}

}  // namespace detail
}  // namespace burin
