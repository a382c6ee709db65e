#include <burin/annotate/label.h>
#include <burin/drawing/font.h>

#include <algorithm>
#include <string>

namespace burin {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else if (c != '\r') {
      lines.back() += c;
    }
  }
  return lines;
}

}  // namespace

void move(Label& label, Vec2 by) {
  const auto move_points = [&](std::vector<Vec2>& points) {
    for (Vec2& p : points) p += by;
  };
  for (Path& path : label.paths) move_points(path.points);
  for (Area& area : label.areas) std::ranges::for_each(area.rings, move_points);
  for (Text& text : label.texts) text.at += by;
}

Label text_label(std::string_view text, bool framed, const LabelPens& pens) {
  // Of the height of letters: from base line to base line (ISO 3098), and from letters to a frame.
  constexpr double kPitch = 1.6, kInFrame = 0.6, kBeside = 0.15;
  // Tails of letters stay clear of the line below.
  constexpr double kUnderTails = 0.45;
  const double h = pens.height;
  const std::vector<std::string> lines = lines_of(text);
  const double rows = static_cast<double>(lines.size() - 1);
  Label out;
  out.underlined = !framed && lines.size() == 1;
  out.ragged = !framed && lines.size() > 1;
  const Vec2 in = framed           ? Vec2(kInFrame * h)
                  : out.underlined ? Vec2(kBeside, kUnderTails) * h
                                   : Vec2(2 * kBeside * h, 0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out.size.x = std::max(out.size.x, text_width(lines[i], h) + 2 * in.x);
    const Vec2 at = in + Vec2(0, (rows - static_cast<double>(i)) * kPitch * h);
    if (!lines[i].empty()) {
      out.texts.push_back({at, h, TextAnchor::Start, lines[i], "note", 0});
    }
  }
  out.size.y = (1 + rows * kPitch) * h + (framed ? 2 : 1) * in.y;
  if (!out.underlined) out.shoulder = framed ? 0.5 * out.size.y : out.size.y - 0.5 * h;
  if (framed) {
    Path frame;
    frame.kind = LineClass::Frame;
    frame.closed = true;
    frame.width = {pens.line};
    frame.points = {{0, 0}, {out.size.x, 0}, out.size, {0, out.size.y}};
    out.paths.push_back(std::move(frame));
  }
  return out;
}

}  // namespace burin
